// SPDX-License-Identifier: GPL-3.0-or-later
// Mean and spread of movements to the same posture, on a time axis that begins where the object
// begins to turn and is as long as the movement.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/movement.hpp"

namespace isograsp {

struct BandPoint {
  std::string posture;
  std::string channel;  ///< x_m, y_m, z_m, roll_rad, pitch_rad, yaw_rad of the object in its
                        ///< reference, from its first row; LINK_r: r_angle of a link
  double tau = 0.0;
  int n = 0;  ///< movements that reach this point
  double mean = 0.0;
  std::optional<double> sd;  ///< n - 1; nothing for one movement
};

/// Postures in the order in which they were asked for first. @pre scores are of this rig and series
[[nodiscard]] Result<std::vector<BandPoint>> movement_bands(const Rig& rig,
                                                            const PoseSeries& series,
                                                            const MovementScores& scores);

}  // namespace isograsp
