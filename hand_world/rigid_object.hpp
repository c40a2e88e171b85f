// SPDX-License-Identifier: GPL-3.0-or-later
// The object that is grasped: a solid box or cylinder that moves freely. Its principal axes are its
// own. Frame O: origin at its centre, a cylinder along z. SI units. Real-time safe.
#pragma once

#include "core/spatial.hpp"
#include "hand_world/arrow.hpp"
#include "virtual_hand/capsule.hpp"

namespace isograsp::hand_world {

struct ObjectBody {
  virtual_hand::ObjectShape shape;
  double mass_kg = 0.0;
  Vec3 inertia_kg_m2 = Vec3::Zero();  ///< principal, in O
};
/// A solid of one density.
[[nodiscard]] ObjectBody solid_object(const virtual_hand::ObjectShape& shape,
                                      double density_kg_m3) noexcept;

struct ObjectMotion {
  Pose X_WO;
  Vec3 v_WO_W = Vec3::Zero();  ///< of its centre [m/s]
  Vec3 w_WO_O = Vec3::Zero();  ///< angular velocity, object axes [rad/s]

  [[nodiscard]] Vec3 w_WO_W() const noexcept { return X_WO.q * w_WO_O; }
  /// Velocity of a point of it that is `arm_W` from its centre.
  [[nodiscard]] Vec3 velocity_at(const Vec3& arm_W) const noexcept {
    return v_WO_W + w_WO_W().cross(arm_W);
  }
};

/// X after `time_s` of these velocities; w in object axes.
[[nodiscard]] Pose moved_object(const Pose& X_WO, const Vec3& v_W, const Vec3& w_O,
                                double time_s) noexcept;

class RigidObject {
 public:
  explicit RigidObject(const ObjectBody& body) noexcept : body_(body) {}

  [[nodiscard]] const ObjectBody& body() const noexcept { return body_; }
  [[nodiscard]] const ObjectMotion& motion() const noexcept { return motion_; }
  void place(const ObjectMotion& motion) noexcept { motion_ = motion; }
  /// Kinetic energy [J].
  [[nodiscard]] double kinetic_J() const noexcept;

  /// Where it would be in the middle of the step if nothing pulled.
  [[nodiscard]] Pose middle(double step_s) const noexcept {
    return moved_object(motion_.X_WO, motion_.v_WO_W, motion_.w_WO_O, 0.5 * step_s);
  }
  /// Adds its mass to the matrix, weight and gyroscopic torque to the pull.
  void add_to(Arrow& matrix, ArrowVector& pull, const Vec3& gravity_W,
              double step_s) const noexcept;
  /// The end of a step at which it has these velocities: implicit midpoint.
  void advance(const HubVector& velocity, double step_s) noexcept;

 private:
  ObjectBody body_;
  ObjectMotion motion_;
};

}  // namespace isograsp::hand_world
