// SPDX-License-Identifier: GPL-3.0-or-later
// How the patient's screen shows two hands at once, each on a platform of its own: the left one at
// the left, the right one at the right, the sum between them where it is the goal. A function of
// the stimulus (Stimulus::hands) and of the range of the trial's targets. Heights are shares of a
// bar, 0 … 1: no number is on this picture.
#pragma once

#include <optional>
#include <string>

#include "gui/picture/carry_picture.hpp"
#include "gui/picture/tray_picture.hpp"
#include "hand/hands.hpp"

namespace isograsp::gui {

struct PatientFacts;
struct PatientPicture;

struct TwoHandsPicture {
  /// A force as the height of a bar, and what is asked of it as a band across.
  struct Bar {
    bool force_shown = false;
    double force = 0.0;  ///< 0 while it is not shown; what pulls is 0
    bool target_shown = false;
    double target = 0.0;     ///< 0 while it is not
    double half_band = 0.0;  ///< of what looks like "on it"
    bool on_target = false;  ///< both are shown, and the force is inside the band
    bool operator==(const Bar&) const = default;
  };
  struct Side {
    bool works = false;  ///< it is to press; else to rest
    std::string name;    ///< "Left hand"
    std::string act;     ///< what it is to do, in a word or two
    Bar bar;
    bool operator==(const Side&) const = default;
  };
  OfHands<Side> of;
  std::optional<Bar> sum;  ///< nothing: the goal is not their sum
  std::string sum_name;    ///< "Together"
  /// Of the height of `sum`, what the left hand gives; nothing: the single forces are not shown.
  std::optional<double> left_of_sum;
  // In place of bars; nothing: there is none.
  std::optional<TrayPicture> tray;    ///< that both lift
  std::optional<CarryPicture> carry;  ///< a box that both carry
  bool operator==(const TwoHandsPicture&) const = default;
};

/// Inside gui/picture/ only. Page, signs and words of a trial of both hands.
/// @pre facts.task, facts.stimulus.hands
void add_two_hands(const PatientFacts& facts, PatientPicture& picture);
/// Between trials, or while the zeros are measured. False: what is said of one hand is said of
/// both.
[[nodiscard]] bool add_two_hands_between(const PatientFacts& facts, PatientPicture& picture);

}  // namespace isograsp::gui
