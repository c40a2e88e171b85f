// SPDX-License-Identifier: GPL-3.0-or-later
// What an object stands on: a table, and a block on it. Where it may touch: the four lowest corners
// of a box, the rim of the base on which a cylinder stands, the two lowest points of one that lies.
// World: y up. SI units. Real-time safe.
#pragma once

#include <array>
#include <optional>

#include "hand_world/rigid_object.hpp"

namespace isograsp::hand_world {

/// A block on the table, its edges along x and z.
struct SupportBlock {
  double x_m = 0.0;  ///< its centre
  double z_m = 0.0;
  double half_x_m = 0.0;
  double half_z_m = 0.0;
  double top_m = 0.0;  ///< height of its top in the world
};
struct Ground {
  double table_m = 0.0;  ///< height of the table
  std::optional<SupportBlock> block;

  /// What is below a point; beside the block or more than kEdge_m under its top: the table.
  [[nodiscard]] double height_below(const Vec3& p_W) const noexcept;
  static constexpr double kEdge_m = 0.005;
};

/// A point of an object, which has a number for as long as the object is the same.
struct SupportPoint {
  int number = 0;
  Vec3 p_W = Vec3::Zero();
};
struct SupportPoints {
  static constexpr std::size_t kMost = 9;
  static constexpr int kNumbers = 19;  ///< numbers are below this
  std::array<SupportPoint, kMost> points;
  std::size_t count = 0;
  /// The points are those of one base, which rubs as a disk where its pressure is.
  bool base = false;
};
[[nodiscard]] SupportPoints support_points(const virtual_hand::ObjectShape& shape,
                                           const Pose& X_WO) noexcept;

}  // namespace isograsp::hand_world
