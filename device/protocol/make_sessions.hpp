// SPDX-License-Identifier: GPL-3.0-or-later
// The conversations with three sensors, by protocol.
#pragma once

#include <array>
#include <memory>

#include "device/codec/net_ft_box_config.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

using SensorSessions = std::array<std::unique_ptr<SensorSession>, kFingerCount>;

/// What the boxes of Net F/T sensors said about themselves; others have none.
using NetFtBoxes = std::array<NetFtBoxConfig, kFingerCount>;

/// @pre the protocol has conversations: a card in this computer has none. The rate and filter of
/// the configuration exist.
[[nodiscard]] SensorSessions make_sessions(const DeviceConfig& config,
                                           const NetFtBoxes& boxes = {});

}  // namespace isograsp
