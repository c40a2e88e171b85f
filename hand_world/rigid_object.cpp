// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/rigid_object.hpp"

#include <Eigen/LU>

#include "grasp_model/rotation.hpp"

namespace isograsp::hand_world {

namespace {

/// Mean of -w x I w over a step without other torques, w in object axes: that of the implicit
/// midpoint rule, which keeps the energy w^T I w.
Vec3 gyroscopic_torque(const Vec3& inertia, const Vec3& w, double step_s) noexcept {
  constexpr int kNewton = 3;  // quadratic: from h |w| = 0.3 to the last bit
  Vec3 middle = w;
  for (int k = 0; k < kNewton; ++k) {
    const Vec3 spin = inertia.cwiseProduct(middle);
    const Vec3 error = spin - inertia.cwiseProduct(w) + 0.5 * step_s * middle.cross(spin);
    Mat3 slope = 0.5 * step_s * (skew(middle) * inertia.asDiagonal() - skew(spin));
    slope.diagonal() += inertia;
    middle -= slope.inverse() * error;
  }
  return -middle.cross(inertia.cwiseProduct(middle));
}

}  // namespace

ObjectBody solid_object(const virtual_hand::ObjectShape& shape, double density_kg_m3) noexcept {
  const Vec3& half = shape.half_m;
  const Vec3 squares = half.cwiseProduct(half);
  ObjectBody body{shape, 0.0, Vec3::Zero()};
  if (shape.kind == virtual_hand::ObjectShape::Kind::box) {
    body.mass_kg = density_kg_m3 * 8.0 * half.prod();
    body.inertia_kg_m2 = body.mass_kg / 3.0 * (squares.sum() * Vec3::Ones() - squares);
    return body;
  }
  constexpr double kPi = 3.14159265358979323846;
  body.mass_kg = density_kg_m3 * kPi * squares.x() * 2.0 * half.z();
  const double across = body.mass_kg * (squares.x() / 4.0 + squares.z() / 3.0);
  body.inertia_kg_m2 = {across, across, body.mass_kg * squares.x() / 2.0};
  return body;
}

Pose moved_object(const Pose& X_WO, const Vec3& v_W, const Vec3& w_O, double time_s) noexcept {
  return {X_WO.p + time_s * v_W, (X_WO.q * so3::exp(time_s * w_O)).normalized()};
}

double RigidObject::kinetic_J() const noexcept {
  return 0.5 * body_.mass_kg * motion_.v_WO_W.squaredNorm() +
         0.5 * motion_.w_WO_O.dot(body_.inertia_kg_m2.cwiseProduct(motion_.w_WO_O));
}

void RigidObject::add_to(Arrow& matrix, ArrowVector& pull, const Vec3& gravity_W,
                         double step_s) const noexcept {
  matrix.hub.diagonal().segment<3>(kObjectPart).array() += body_.mass_kg;
  matrix.hub.diagonal().segment<3>(kObjectPart + 3) += body_.inertia_kg_m2;
  pull.hub.segment<3>(kObjectPart) += body_.mass_kg * gravity_W;
  pull.hub.segment<3>(kObjectPart + 3) +=
      gyroscopic_torque(body_.inertia_kg_m2, motion_.w_WO_O, step_s);
}

void RigidObject::advance(const HubVector& velocity, double step_s) noexcept {
  const Vec3 v = velocity.segment<3>(kObjectPart);
  const Vec3 w = velocity.segment<3>(kObjectPart + 3);
  motion_.X_WO =
      moved_object(motion_.X_WO, 0.5 * (motion_.v_WO_W + v), 0.5 * (motion_.w_WO_O + w), step_s);
  motion_.v_WO_W = v;
  motion_.w_WO_O = w;
}

}  // namespace isograsp::hand_world
