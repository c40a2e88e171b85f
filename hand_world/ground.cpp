// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/ground.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::hand_world {

namespace {

using virtual_hand::ObjectShape;

// Numbers: corners of a box 0 … 7, rims of a cylinder's ends 0 … 15, their lowest points 16, 17.
constexpr int kRim = 8;
constexpr int kLowest = 2 * kRim;

SupportPoints corners_of(const Vec3& half, const Pose& X_WO) noexcept {
  std::array<SupportPoint, 8> corners;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner((k & 1) != 0 ? half.x() : -half.x(), (k & 2) != 0 ? half.y() : -half.y(),
                      (k & 4) != 0 ? half.z() : -half.z());
    corners[static_cast<std::size_t>(k)] = {k, X_WO.p + X_WO.q * corner};
  }
  SupportPoints lowest;
  lowest.count = 4;
  std::partial_sort_copy(corners.begin(), corners.end(), lowest.points.begin(),
                         lowest.points.begin() + 4,
                         [](const SupportPoint& a, const SupportPoint& b) {
                           if (a.p_W.y() != b.p_W.y()) return a.p_W.y() < b.p_W.y();
                           return a.number < b.number;
                         });
  std::sort(lowest.points.begin(), lowest.points.begin() + 4,
            [](const SupportPoint& a, const SupportPoint& b) { return a.number < b.number; });
  return lowest;
}

SupportPoints of_cylinder(const Vec3& half, const Pose& X_WO) noexcept {
  // Steeper than this it stands: there the rim has eight points and its lowest one.
  constexpr double kStands = 0.2;  // sine of the angle between its axis and up
  // Flatter than this every point of the base is its lowest.
  constexpr double kFlat = 0.02;
  const Vec3 up_O = X_WO.q.conjugate() * Vec3::UnitY();
  const double sine = std::hypot(up_O.x(), up_O.y());
  SupportPoints points;
  const auto add = [&](int number, const Vec3& p_O) {
    points.points[points.count++] = {number, X_WO.p + X_WO.q * p_O};
  };
  const auto lowest_of = [&](double z) {
    return Vec3(-half.x() * up_O.x() / sine, -half.x() * up_O.y() / sine, z);
  };
  if (sine >= kStands) {
    add(kLowest, lowest_of(-half.z()));
    add(kLowest + 1, lowest_of(half.z()));
    return points;
  }
  const double z = up_O.z() > 0.0 ? -half.z() : half.z();
  const int end = z < 0.0 ? 0 : 1;
  constexpr double kDiagonal = 0.70710678118654752440;
  constexpr std::array<double, kRim> kCosine{1.0,  kDiagonal,  0.0, -kDiagonal,
                                             -1.0, -kDiagonal, 0.0, kDiagonal};
  for (int k = 0; k < kRim; ++k)
    add(kRim * end + k, {half.x() * kCosine[static_cast<std::size_t>(k)],
                         half.x() * kCosine[static_cast<std::size_t>((k + 6) % kRim)], z});
  if (sine >= kFlat) add(kLowest + end, lowest_of(z));
  points.base = true;
  return points;
}

}  // namespace

double Ground::height_below(const Vec3& p_W) const noexcept {
  if (block && std::abs(p_W.x() - block->x_m) <= block->half_x_m &&
      std::abs(p_W.z() - block->z_m) <= block->half_z_m && p_W.y() >= block->top_m - kEdge_m)
    return std::max(table_m, block->top_m);
  return table_m;
}

SupportPoints support_points(const ObjectShape& shape, const Pose& X_WO) noexcept {
  return shape.kind == ObjectShape::Kind::box ? corners_of(shape.half_m, X_WO)
                                              : of_cylinder(shape.half_m, X_WO);
}

}  // namespace isograsp::hand_world
