// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/experiments.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/rotation.hpp"

namespace isograsp::hand_world {

SqueezeResult squeeze(const Squeeze& setup) noexcept {
  ObjectBody cuboid =
      solid_object({virtual_hand::ObjectShape::Kind::box, {0.01, 0.01, 0.075}}, 1.0);
  cuboid.inertia_kg_m2 *= setup.mass_kg / cuboid.mass_kg;
  cuboid.mass_kg = setup.mass_kg;
  WorldRules rules;
  rules.gravity_W = {0.0, -setup.gravity_m_s2, 0.0};
  rules.pad = setup.pad;
  World world(cuboid, rules);
  const Vec3 half = cuboid.shape.half_m;
  const Vec3 beside(0.0, 0.0, setup.offset_m);
  for (const double side : {-1.0, 1.0})
    world.add_pad({{side * half.x(), 0.0, setup.offset_m}, {-side, 0.0, 0.0}, setup.force_N});
  const auto steps = static_cast<long>(std::ceil(setup.duration_s / setup.step_s - 1e-9));
  SqueezeResult result;
  for (long k = 0; k < steps; ++k) {
    world.step(setup.step_s);
    const Pose& X_WO = world.object().motion().X_WO;
    result.slip_m = (X_WO.p + X_WO.q * beside - beside).norm();
    result.turn_rad = angle_between(Quat::Identity(), X_WO.q);
    const Vec3 pads_O = X_WO.q.conjugate() * (beside - X_WO.p);
    if (std::abs(pads_O.y()) > half.y() || std::abs(pads_O.z()) > half.z()) break;
  }
  return result;
}

SlideResult slide(const Slide& setup) noexcept {
  // So flat that friction at its base does not tip it. Its mass and height cancel.
  constexpr double kFlat = 1e-4;
  const double radius_m = setup.radius_m;
  ObjectBody disk = solid_object(
      {virtual_hand::ObjectShape::Kind::cylinder, {radius_m, radius_m, kFlat * radius_m}}, 1.0);
  disk.inertia_kg_m2 *= 0.1 / disk.mass_kg;
  disk.mass_kg = 0.1;
  WorldRules rules;
  rules.gravity_W = {0.0, -setup.gravity_m_s2, 0.0};
  rules.ground_friction = setup.friction;
  World world(disk, rules);
  world.place_ground({});
  // Its axis points up, and its weight has pressed it into the pads of the rim.
  constexpr double kRimPoints = 8.0;
  const double depth_m = disk.mass_kg * setup.gravity_m_s2 / kRimPoints * PadLaw::kSoftness_m_N_s /
                         PadLaw::kGiving_1_s;
  ObjectMotion start;
  start.X_WO.p.y() = disk.shape.half_m.z() - depth_m;
  start.X_WO.q = so3::shortest(Vec3::UnitZ(), Vec3::UnitY());
  start.v_WO_W = {setup.v0_m_s, 0.0, 0.0};
  start.w_WO_O = {0.0, 0.0, setup.w0_rad_s};
  world.place_object(start);

  constexpr double kRest_m_s = 1e-8;
  constexpr double kLast = 0.001;
  const double first_m_s = std::hypot(setup.v0_m_s, setup.w0_rad_s * radius_m);
  SlideResult result;
  Vec3 w_last = start.w_WO_W();
  for (long k = 0; static_cast<double>(k) * setup.step_s < kLongest_s; ++k) {
    const ObjectMotion& motion = world.object().motion();
    const Vec3 v(motion.v_WO_W.x(), 0.0, motion.v_WO_W.z());
    const double turns_m_s = std::abs(motion.w_WO_W().y()) * radius_m;
    const double speed_m_s = std::hypot(v.norm(), turns_m_s);
    if (speed_m_s <= kRest_m_s) {
      result.stopped = true;
      break;
    }
    if (speed_m_s >= kLast * first_m_s && turns_m_s > 0.0) result.last_slip = v.norm() / turns_m_s;
    world.step(setup.step_s);
    result.stop_s = static_cast<double>(k + 1) * setup.step_s;
    const Vec3 w_now = world.object().motion().w_WO_W();
    result.angle_rad += 0.5 * setup.step_s * (w_last.y() + w_now.y());
    w_last = w_now;
  }
  result.distance_m = world.object().motion().X_WO.p.x();
  return result;
}

}  // namespace isograsp::hand_world
