// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen shows a tray that both hands lift: from the front, hands at its ends,
// the band into which it is to be lifted, its rest below. A function of the stimulus
// (ShownHands::tray). Metres of the scene, x right, y up; no number is on this picture.
#pragma once

#include <string>

#include "core/spatial.hpp"
#include "hand/hands.hpp"

namespace isograsp::gui {

struct PatientFacts;
struct PatientPicture;

struct TrayPicture {
  struct End {
    Vec3 p_W = Vec3::Zero();
    bool touches = false;
    bool slips = false;
    bool operator==(const End&) const = default;
  };
  Vec3 size_m = Vec3::Zero();
  Vec3 p_W = Vec3::Zero();  ///< of its middle, where it is now
  double angle_rad = 0.0;   ///< above 0: the right end is higher
  OfHands<End> of;
  double rest_y_m = 0.0;  ///< of its middle while it rests
  bool target_shown = false;
  double target_y_m = 0.0;  ///< likewise where it is to be
  double band_m = 0.0;      ///< to either side
  bool level = true;        ///< its tilt is inside the band
  bool on_target = false;   ///< in height and tilt
  bool fetched = false;     ///< it was dropped and is brought back
  bool operator==(const TrayPicture&) const = default;
};

/// Inside gui/picture/ only. The tray, where there is one, and the words of its page.
/// @pre facts.stimulus.hands->tray, picture.two_hands
void add_tray(const PatientFacts& facts, PatientPicture& picture);

}  // namespace isograsp::gui
