// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen shows a box that both hands, as points, take and carry: the bubble of
// each hand, its point, the box, the outline where it is to be. A function of the stimulus
// (ShownHands::carry) and of the targets of the task. Metres of the scene, x right, y up; no number
// is on this picture, and it never turns.
#pragma once

#include "core/spatial.hpp"
#include "hand/hands.hpp"

namespace isograsp::gui {

struct PatientFacts;
struct PatientPicture;

struct CarryPicture {
  struct Point {
    Vec3 p_W = Vec3::Zero();
    Vec3 bubble_W = Vec3::Zero();
    bool beyond = false;  ///< the bubble moves
    bool operator==(const Point&) const = default;
  };
  Vec3 size_m = Vec3::Zero();
  Vec3 p_W = Vec3::Zero();  ///< of the middle of the box, where it is now
  double angle_rad = 0.0;
  Vec3 half_size_m = Vec3::Zero();  ///< of the bubbles
  OfHands<Point> of;
  bool held = false;
  bool clutch = false;  ///< points stay
  bool target_shown = false;
  Vec3 target_W = Vec3::Zero();
  double tolerance_m = 0.0;
  bool on_target = false;
  bool fetched = false;  ///< it was dropped and is brought back
  // What is to be seen: all targets, the box, both bubbles.
  Vec3 low_W = Vec3::Zero();
  Vec3 high_W = Vec3::Zero();
  bool operator==(const CarryPicture&) const = default;
};

/// Inside gui/picture/ only. The box, where there is one, and the words of its page.
/// @pre facts.stimulus.hands->carry, picture.two_hands
void add_carry(const PatientFacts& facts, PatientPicture& picture);

}  // namespace isograsp::gui
