// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/patch/pressed_patch.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

Result<PressedPatch> press(std::span<const PatchPoint> points, double friction) {
  PressedPatch patch;
  double depth_m = 0.0;
  int touching = 0;
  for (const PatchPoint& point : points) {
    if (!(point.area_m2 > 0.0) || !point.p_m.allFinite() || !std::isfinite(point.penetration_m))
      return refused("a point has no area or no place"_text,
                     "give positive areas and numbers"_text);
    if (point.penetration_m <= 0.0) continue;
    depth_m += point.penetration_m;
    patch.volume_m3 += point.area_m2 * point.penetration_m;
    ++touching;
  }
  if (touching == 0)
    return refused("no point touches"_text, "give one a penetration above zero"_text);
  for (const PatchPoint& point : points) {
    const double pressed_m = std::max(0.0, point.penetration_m);
    patch.weights.push_back(pressed_m * touching / depth_m);
    if (pressed_m == 0.0) continue;
    const double share = point.area_m2 * pressed_m / patch.volume_m3;
    patch.touching.push_back({point.p_m, share});
    patch.centroid_m += share * point.p_m;
  }
  patch.torsion_m = friction * mean_distance(patch.touching, patch.centroid_m);
  patch.pure_torsion_limit_m =
      friction * mean_distance(patch.touching, geometric_median(patch.touching));
  return patch;
}

SlipFriction friction_of(const PressedPatch& patch, double friction,
                         const SlipTwist& slip) noexcept {
  SlipFriction sum;
  for (const PressedPoint& point : patch.touching) {
    const Vec2 arm_m = point.p_m - patch.centroid_m;
    const Vec2 u_mps = slip.v_mps + slip.w_radps * Vec2(-arm_m.y(), arm_m.x());
    const double speed_mps = u_mps.norm();
    if (speed_mps == 0.0) continue;
    const Vec2 force = -friction * point.share / speed_mps * u_mps;
    sum.force += force;
    sum.torque_m += arm_m.x() * force.y() - arm_m.y() * force.x();
    sum.dissipation += friction * point.share * speed_mps;
  }
  return sum;
}

}  // namespace isograsp
