// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. How each scheme of a URI is opened; open_hand_device() holds the table.
#pragma once

#include <memory>
#include <optional>

#include "device/hand/hand_device.hpp"

namespace isograsp {

/// leap://HOST[:PORT]?mounting=desk&delay_ms=…: the Leap service or Ultraleap's bridge, JSON of
/// protocol v6 over a WebSocket.
[[nodiscard]] Result<std::unique_ptr<HandDevice>> open_leap(const Uri& uri,
                                                            std::optional<Hand> side);

/// udp-hand://HOST[:PORT]?network=confirmed&mounting=desk&delay_ms=…: one JSON object a datagram
/// (hand_json.hpp). HOST is the address of this computer that is listened at; any but 127.0.0.1
/// lets others in the network send hands and wants `network=confirmed`.
[[nodiscard]] Result<std::unique_ptr<HandDevice>> open_udp_hand(const Uri& uri,
                                                                std::optional<Hand> side);

/// replay://FILE?speed=1: a table (hand_csv.hpp). Stamps are its times since the first row. speed
/// 0: never wait.
[[nodiscard]] Result<std::unique_ptr<HandDevice>> open_hand_replay(const Uri& uri,
                                                                   std::optional<Hand> side);

/// sim://hand?user=NAME&seed=N&rate=90: the hand of `person`, who lives in software. Errors: null.
[[nodiscard]] Result<std::unique_ptr<HandDevice>> open_simulated_hand(const Uri& uri,
                                                                      std::optional<Hand> side,
                                                                      HandSource* person);

/// What all live trackers are told in their URI: `mounting`, `delay_ms`.
[[nodiscard]] Result<HandDeviceInfo> live_hand_info(const Uri& uri);

}  // namespace isograsp
