// SPDX-License-Identifier: GPL-3.0-or-later
// Which force follows a target, and in which unit its levels are told. SI units.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "hand/force_channel.hpp"

namespace isograsp::tasks {

/// What the number 1 of a level stands for.
enum class Scale : std::uint8_t {
  newton,          ///< 1 N
  of_maximum,      ///< the maximum of the same channel in this session
  of_comfortable,  ///< the comfortable force of the same channel in this session
  of_baseline      ///< the maximum of the patient's first assessments: the same load every time
};

/// Which force follows the target, and how both are shown.
struct Aim {
  ForceChannel channel;
  Scale scale = Scale::of_maximum;
  double band_fraction = 0.05;  ///< of the target: half the width of the band that counts as on it
  bool force_shown = true;      ///< feedback: the own force is on the screen
  double preview_s = 0.0;       ///< how much of the target's future is on the screen
  /// Visual gain [deg of visual angle per unit of the scale]; nothing: the screen fits the target.
  std::optional<double> gain_deg;
  double viewing_distance_m = 0.6;
};

/// Newtons of one unit of a task's scale in a channel.
using Unit = std::function<double(ForceChannel)>;

}  // namespace isograsp::tasks
