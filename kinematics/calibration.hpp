// SPDX-License-Identifier: GPL-3.0-or-later
// What a rig learns from recordings: templates and zeros from an arm held still, landmarks from a
// pointer. Rows are those of one recording: positions in the world of the cameras, missing ones
// NaN.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "hand/finger.hpp"
#include "kinematics/rig.hpp"

namespace isograsp {

/// Positions of markers over time [m].
struct MarkerRows {
  std::vector<std::string> markers;
  std::vector<double> t_s;
  std::vector<std::vector<Vec3>> p_W;  ///< [row][marker]
};

/// The rig with templates measured in the frames of their recipes (`calibration`): mean of each
/// marker over the rows in which all of them are seen; then with zeros where links have one: mean
/// attitude. Templates stay those of the cameras; zeros belong to the reflected world of a left
/// arm. Errors name a frame or link that no row shows.
[[nodiscard]] Result<Rig> calibrated(const Rig& rig, const MarkerRows& still, Hand hand);

struct MeasuredLandmark {
  std::size_t rows = 0;
  Vec3 position_m = Vec3::Zero();  ///< of the tip in the frame
  Vec3 sd_m = Vec3::Zero();        ///< n - 1
};
/// Above this length of the deviation the pointer is to be held again [m].
inline constexpr double kLargestLandmarkSd_m = 0.003;
/// The origin of frame `probe` in frame `frame`, over the rows that show both. Errors: a frame is
/// not known, or fewer than two rows.
[[nodiscard]] Result<MeasuredLandmark> measure_landmark(const Rig& rig, const MarkerRows& rows,
                                                        const std::string& probe,
                                                        const std::string& frame);

/// Poses of all frames in all rows; of a left arm in the reflected world. Errors as of
/// ArmFrames::compile().
[[nodiscard]] Result<std::vector<std::vector<Pose>>> poses_of(const Rig& rig,
                                                              const MarkerRows& rows, Hand hand);

}  // namespace isograsp
