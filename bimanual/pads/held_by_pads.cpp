// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/held_by_pads.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/LU>

namespace isograsp::bimanual {

namespace {

/// An axis that cannot move is as good as one that this mass holds.
constexpr double kLocked = 1e18;

Vec3 rotation_vector(const Quat& q) {
  const Eigen::AngleAxisd turn(q);
  return turn.angle() * turn.axis();
}
Quat turned(const Vec3& rotation) {
  const double angle_rad = rotation.norm();
  return angle_rad == 0.0 ? Quat::Identity()
                          : Quat(Eigen::AngleAxisd(angle_rad, rotation / angle_rad));
}
Pose moved(const Pose& X, const Vec6& velocity, double step_s) {
  return {X.p + step_s * velocity.head<3>(),
          (turned(step_s * velocity.tail<3>()) * X.q).normalized()};
}

/// Where a proxy wants its pad.
Pose wanted(const Pose& X_WProxy, const PadSpec& pad) {
  return {X_WProxy.p + X_WProxy.q * pad.from_hand_m, X_WProxy.q};
}

/// Where a point is in a solid, and the normal of the face beneath; object axes.
struct Depth {
  double depth_m = -1.0;  ///< below 0: outside
  Vec3 inward = Vec3::Zero();
};
/// `normal`: of the pad; it decides which face of a box, or whether side or cap.
Depth depth_in(Shape shape, const Vec3& size_m, const Vec3& p, const Vec3& normal) {
  Depth depth;
  const auto face = [&](Eigen::Index axis, double half_m) {
    depth.inward[axis] = normal[axis] > 0.0 ? 1.0 : -1.0;
    depth.depth_m = half_m + depth.inward[axis] * p[axis];
  };
  switch (shape) {
    case Shape::box: {
      Eigen::Index axis = 0;
      normal.cwiseAbs().maxCoeff(&axis);
      Vec3 beside_m = p.cwiseAbs() - size_m / 2.0;
      beside_m[axis] = -1.0;
      face(axis, size_m[axis] / 2.0);
      if (beside_m.maxCoeff() > 0.0) depth.depth_m = -1.0;
      return depth;
    }
    case Shape::sphere:
      depth.inward = -p.normalized();
      depth.depth_m = size_m.x() / 2.0 - p.norm();
      return depth;
    case Shape::cylinder: break;
  }
  const double from_axis_m = p.head<2>().norm();
  if (std::abs(normal.z()) > std::numbers::sqrt2 / 2.0) {
    face(2, size_m.y() / 2.0);
    if (from_axis_m > size_m.x() / 2.0) depth.depth_m = -1.0;
    return depth;
  }
  depth.inward = Vec3(-p.x(), -p.y(), 0.0) / from_axis_m;
  depth.depth_m = size_m.x() / 2.0 - from_axis_m;
  if (std::abs(p.z()) > size_m.y() / 2.0) depth.depth_m = -1.0;
  return depth;
}

}  // namespace

HeldByPads::HeldByPads(const Scene& scene, std::vector<PadSpec> pads, double step_s,
                       PadSolver solver, const std::array<Pose, kSides>& proxies)
    : scene_(scene),
      pads_(std::move(pads)),
      step_s_(step_s),
      steps_(solver),
      proxies_(proxies),
      X_WO_(scene.initial_X_WO),
      v_W_(scene.initial_v_WO_W),
      w_W_(scene.initial_w_WO_W),
      wrenches_(pads_.size()) {
  for (const PadSpec& pad : pads_) {
    X_WP_.push_back(wanted(proxies[index_of(pad.hand)], pad));
    std::vector<PatchRay> rays;
    for (int j = 0; j < pad.face.rays; ++j) {
      const double reach_m = reach_of_ray(pad.face, j).limit_m;
      rays.push_back({reach_m, RayStop::length, {{0.0, reach_m}}});
    }
    points_.push_back(elements_of(rays, pad.face));
  }
}

void HeldByPads::begin(const std::array<Pose, kSides>& proxies) noexcept {
  proxies_ = proxies;
  for (std::size_t pad = 0; pad < pads_.size(); ++pad)
    X_WP_[pad] = wanted(proxies[index_of(pads_[pad].hand)], pads_[pad]);
}

void HeldByPads::put(const Pose& X_WO) noexcept {
  X_WO_ = X_WO;
  v_W_.setZero();
  w_W_.setZero();
}

HeldByPads::Body HeldByPads::object_body(const Vec3& gravity_m_s2) const {
  const Mat3 R = X_WO_.q.toRotationMatrix();
  Body body;
  body.inertia.setZero();
  body.inertia.diagonal().head<3>().setConstant(scene_.mass_kg);
  const Mat3 I_W = R * scene_.inertia_kg_m2.asDiagonal() * R.transpose();
  body.inertia.bottomRightCorner<3, 3>() = I_W;
  Vec6 momentum;
  momentum << scene_.mass_kg * (v_W_ + step_s_ * gravity_m_s2),
      I_W * w_W_ - step_s_ * w_W_.cross(I_W * w_W_);
  // Springs and dampers of the scene, at the end of the step.
  Vec6 off;
  off << X_WO_.p - scene_.anchor_m, rotation_vector(X_WO_.q);
  const Vec6& K = scene_.stiffness;
  momentum -= step_s_ * K.cwiseProduct(off);
  body.inertia.diagonal() += step_s_ * (scene_.damping + step_s_ * K);
  for (std::size_t dof = 0; dof < 6; ++dof)
    if (!scene_.free[dof]) {
      const auto i = static_cast<Eigen::Index>(dof);
      body.inertia.row(i).setZero();
      body.inertia.col(i).setZero();
      body.inertia(i, i) = kLocked;
      momentum[i] = 0.0;
    }
  body.velocity_free = body.inertia.inverse() * momentum;
  return body;
}

HeldByPads::Body HeldByPads::pad_body(std::size_t pad,
                                      const std::array<Pose, kSides>& proxies) const {
  const PadSpec& spec = pads_[pad];
  const Pose before = wanted(proxies_[index_of(spec.hand)], spec);
  const Pose after = wanted(proxies[index_of(spec.hand)], spec);
  Vec6 v_proxy, behind;
  v_proxy << (after.p - before.p) / step_s_,
      rotation_vector(after.q * before.q.conjugate()) / step_s_;
  behind << after.p - X_WP_[pad].p, rotation_vector(after.q * X_WP_[pad].q.conjugate());
  const Vec6 give = spec.damping + step_s_ * spec.stiffness;
  Body body;
  body.inertia = (step_s_ * give).asDiagonal();
  body.velocity_free = (spec.damping.cwiseProduct(v_proxy) + spec.stiffness.cwiseProduct(behind))
                           .cwiseQuotient(give);
  return body;
}

void HeldByPads::put_face(std::size_t pad, const Vec6& object_free, const Vec6& pad_free,
                          PadFace& face) const {
  const PadSpec& spec = pads_[pad];
  const Pose& X_WP = X_WP_[pad];
  face.object = 0;
  face.pad = pad + 1;
  face.friction = spec.friction;
  face.stiffness_N_m3 = spec.foundation_N_m3;
  const Vec3 across = spec.normal.cross(spec.tangent);
  const Vec3 normal_O = X_WO_.q.conjugate() * (X_WP.q * spec.normal);
  face.points.resize(points_[pad].size());
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const PressedPoint& element = points_[pad][i];
    PadPoint& point = face.points[i];
    point.p_pad = X_WP.q * (element.p_m.x() * spec.tangent + element.p_m.y() * across);
    point.p_object = X_WP.p + point.p_pad - X_WO_.p;
    const Depth depth =
        depth_in(scene_.shape, scene_.size_m, X_WO_.q.conjugate() * point.p_object, normal_O);
    point.normal = X_WO_.q * depth.inward;
    // The bed gives way: they meet on the surface of the object.
    const Vec3 out = -std::max(depth.depth_m, 0.0) * point.normal;
    point.p_pad += out;
    point.p_object += out;
    point.area_m2 = element.share;
    const Vec3 slip = pad_free.head<3>() + Vec3(pad_free.tail<3>()).cross(point.p_pad) -
                      object_free.head<3>() - Vec3(object_free.tail<3>()).cross(point.p_object);
    point.penetration_free_m = depth.depth_m + step_s_ * point.normal.dot(slip);
  }
}

void HeldByPads::put_step(const std::array<Pose, kSides>& proxies, const Vec3& gravity_m_s2,
                          PadStep& step) const {
  step.step_s = step_s_;
  step.inertia.resize(1 + pads_.size());
  step.velocity_free.resize(1 + pads_.size());
  step.faces.resize(pads_.size());
  const auto put = [&step](std::size_t body, const Body& what) {
    step.inertia[body] = what.inertia;
    step.velocity_free[body] = what.velocity_free;
  };
  put(0, object_body(gravity_m_s2));
  for (std::size_t pad = 0; pad < pads_.size(); ++pad) {
    put(pad + 1, pad_body(pad, proxies));
    put_face(pad, step.velocity_free[0], step.velocity_free[pad + 1], step.faces[pad]);
  }
}

PadStep HeldByPads::next(const std::array<Pose, kSides>& proxies, const Vec3& gravity_m_s2) const {
  PadStep step;
  put_step(proxies, gravity_m_s2, step);
  return step;
}

void HeldByPads::step(const std::array<Pose, kSides>& proxies, const Vec3& gravity_m_s2) {
  put_step(proxies, gravity_m_s2, step_);
  const PadSolution& solution = steps_.solve(step_);
  settled_ = settled_ && solution.settled;
  for (std::size_t pad = 0; pad < pads_.size(); ++pad) {
    const Vec6& wrench = solution.wrench_on_object[pad];
    wrenches_[pad].force = wrench.head<3>();
    wrenches_[pad].torque =
        Vec3(wrench.tail<3>()) + (X_WO_.p - X_WP_[pad].p).cross(Vec3(wrench.head<3>()));
    X_WP_[pad] = moved(X_WP_[pad], solution.velocity[pad + 1], step_s_);
  }
  X_WO_ = moved(X_WO_, solution.velocity[0], step_s_);
  v_W_ = solution.velocity[0].head<3>();
  w_W_ = solution.velocity[0].tail<3>();
  proxies_ = proxies;
}

}  // namespace isograsp::bimanual
