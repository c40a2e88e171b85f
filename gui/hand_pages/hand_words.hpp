// SPDX-License-Identifier: GPL-3.0-or-later
// Words and lengths of a tracked hand as they stand on the screen.
#pragma once

#include <QString>

#include "hand/tracked_hand.hpp"
#include "virtual_hand/assistance.hpp"
#include "virtual_hand/assistance_level.hpp"

namespace isograsp::gui {

/// "64": whole millimetres, cut and not rounded, so that no object is promised that is too wide.
[[nodiscard]] QString in_whole_mm(double length_m);
/// "Thumb", … "Little finger".
[[nodiscard]] QString digit_title(Digit digit);
/// "free", "touches", "holds", "let go".
[[nodiscard]] QString state_words(virtual_hand::DigitState state);
/// "full", "softer", "none".
[[nodiscard]] QString level_words(virtual_hand::AssistanceLevel level);

/// "G min", "H min", "H det": of GraspLive::criteria.
[[nodiscard]] QString criterion_name(std::size_t which);

}  // namespace isograsp::gui
