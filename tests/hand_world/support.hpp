// SPDX-License-Identifier: GPL-3.0-or-later
// A hand around an object, for tests of the world of contacts.
#pragma once

#include <memory>
#include <vector>

#include "hand_world/world.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::test {

inline constexpr double kStep_s = 0.001;

/// A hand half closed, thumb opposed, palm down.
inline virtual_hand::HandPose half_closed() {
  virtual_hand::HandPose pose;
  pose.X_WP.p = {0.0, 0.25, 0.1};
  pose.angles[0] = {0.5, 0.3, 0.3, 0.3};
  for (std::size_t d = 1; d < kDigitCount; ++d) pose.angles[d] = {0.0, 0.7, 0.7, 0.3};
  return pose;
}

/// A hand that may close on an object between its thumb and its other digits.
struct Grip {
  std::unique_ptr<hand_world::World> world;
  hand_world::HandTarget open;
  std::vector<Digit> digits;
  Vec3 across = Vec3::UnitX();  ///< from the thumb to the others, unit vector

  /// The target that presses `depth_m` farther than the open hand.
  [[nodiscard]] hand_world::HandTarget pressed(double depth_m) const {
    hand_world::HandTarget target = open;
    for (const Digit digit : digits)
      for (auto& link : target.links[index_of(digit)])
        link.X_W.p += (digit == Digit::thumb ? depth_m : -depth_m) * across;
    return target;
  }
  void run(const hand_world::HandTarget& target, int steps) {
    for (int k = 0; k < steps; ++k) world->step(kStep_s, target);
  }
  [[nodiscard]] const hand_world::ObjectMotion& object() const { return world->object().motion(); }
};

/// The object's x axis lies across the grip; `gap_m` is left to each side.
inline Grip grip_of(const virtual_hand::HandModel& model, const std::vector<Digit>& digits,
                    double gap_m, const hand_world::WorldRules& rules, double half_y_m = 0.02,
                    double half_z_m = 0.05, double mass_kg = 0.06) {
  const virtual_hand::HandPose pose = half_closed();
  const virtual_hand::HandInSpace hand = virtual_hand::hand_in_space(model, pose);
  const auto pad = [&](Digit digit) {
    return Vec3(0.5 * (hand.digit(digit).joints[2] + hand.digit(digit).joints[3]));
  };
  Vec3 others = Vec3::Zero();
  for (const Digit digit : digits)
    if (digit != Digit::thumb) others += pad(digit) / static_cast<double>(digits.size() - 1);
  const Vec3 thumb = pad(Digit::thumb);
  Grip grip;
  grip.digits = digits;
  grip.across = (others - thumb).normalized();
  grip.open = hand_world::still_target(hand);
  const double radius_m = model.digits[0].radii_m[2];
  hand_world::ObjectBody body = hand_world::solid_object(
      {virtual_hand::ObjectShape::Kind::box,
       {0.5 * (others - thumb).norm() - radius_m - gap_m, half_y_m, half_z_m}},
      1.0);
  body.inertia_kg_m2 *= mass_kg / body.mass_kg;
  body.mass_kg = mass_kg;
  grip.world = std::make_unique<hand_world::World>(body, rules);
  grip.world->place_hand(model, pose);
  hand_world::ObjectMotion motion;
  motion.X_WO.p = 0.5 * (others + thumb);
  const Vec3 side = hand.digits[1].axes[1];  // along the knuckles
  const Vec3 y = grip.across.cross(side).normalized();
  Mat3 R_WO;
  R_WO << grip.across, y, grip.across.cross(y);
  motion.X_WO.q = Quat(R_WO).normalized();
  grip.world->place_object(motion);
  return grip;
}

inline hand_world::WorldRules weightless() {
  hand_world::WorldRules rules;
  rules.gravity_W.setZero();
  return rules;
}

}  // namespace isograsp::test
