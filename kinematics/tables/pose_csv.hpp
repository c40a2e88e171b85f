// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of frames and of links as tables (docs/markers.md): t_s, then for each frame
//   NAME_x_m, _y_m, _z_m, _qw, _qx, _qy, _qz, _residual_m, _used, _state
// and for each link
//   NAME_x_m, _y_m, _z_m, _qw, _qx, _qy, _qz, _a1_rad, _a2_rad, _a3_rad
// What is missing is an empty field.
#pragma once

#include <span>
#include <string>

#include "core/files.hpp"
#include "core/result.hpp"
#include "hand/finger.hpp"
#include "kinematics/arm_frames.hpp"
#include "kinematics/pose_series.hpp"

namespace isograsp {

/// Reads a whole table; quaternions are normalised. Errors name file, line and column.
[[nodiscard]] Result<PoseSeries> read_poses(const std::string& path);

/// Writes poses row by row, in constant memory.
class PoseWriter {
 public:
  /// A comment says of which hand they are; those of a left one are reflected.
  [[nodiscard]] static Result<PoseWriter> create(const std::string& path, const Rig& rig,
                                                 Hand hand);
  /// @pre one pose for each frame of the rig
  void write(double t_s, std::span<const FramePose> frames);
  /// Without commit() no file is left under the path.
  [[nodiscard]] Result<void> commit();

 private:
  PoseWriter(FileWriter file, const Rig& rig) : file_(std::move(file)), rig_(&rig) {}
  FileWriter file_;
  const Rig* rig_;
  std::string text_;
};

/// Writes the links of the rig with their angles.
[[nodiscard]] Result<void> write_links(const std::string& path, const Rig& rig,
                                       const PoseSeries& series);

}  // namespace isograsp
