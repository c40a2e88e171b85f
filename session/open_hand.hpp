// SPDX-License-Identifier: GPL-3.0-or-later
// leap://, udp-hand://, sim://hand, replay:// of a recorded hand: a hand that a tracker sees.
#pragma once

#include "session/open_apparatus.hpp"

namespace isograsp::session {

/// `size=other`: the size of the hand is that of the other one. Of sim://hand the person: user,
/// seed. Errors name the URI.
[[nodiscard]] Result<std::unique_ptr<Apparatus>> open_hand(const ApparatusRequest& request);

/// The URI says itself whose size the hand has.
[[nodiscard]] bool says_size(const std::string& uri);
/// The same tracker, for a hand with the size of the other one. @pre !says_size(uri)
[[nodiscard]] std::string with_size_of_other(const std::string& uri);

/// replay:// of a table of a tracked hand: its first line says so.
[[nodiscard]] bool is_recorded_hand(const Uri& uri);

}  // namespace isograsp::session
