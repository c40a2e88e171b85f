// SPDX-License-Identifier: GPL-3.0-or-later
// Segments, links and states of an arm in words that a therapist uses.
#pragma once

#include <QString>

#include "hand/arm_columns.hpp"
#include "kinematics/rigid_body.hpp"

namespace isograsp::gui {

/// "Forearm", "Back of the hand".
[[nodiscard]] QString segment_title(ArmSegment segment);
/// "Forearm", "Wrist", "Fingers": what turns.
[[nodiscard]] QString link_title(ArmLink link);
/// "seen", "too few markers".
[[nodiscard]] QString sight_words(FrameState state);
/// "23": whole degrees, in the language that is set.
[[nodiscard]] QString in_degrees(double angle_rad);

}  // namespace isograsp::gui
