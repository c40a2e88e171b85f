// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/plan.hpp"

#include <cmath>
#include <limits>

#include "grasp_model/contact.hpp"
#include "grasp_model/grasp.hpp"

namespace isograsp {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

Error refused(const Scene& scene, std::string field, std::string what, std::string remedy) {
  return {Error::Code::bad_input, std::move(what), std::move(remedy), scene.file, 0,
          std::move(field)};
}

}  // namespace

Result<Plan> Plan::compile(const Scene& scene, double hold_s) {
  if (!(hold_s > 0.0) || !std::isfinite(hold_s))
    return refused(scene, "", "a hold of " + std::to_string(hold_s) + " s is not possible",
                   "give times that increase");
  Plan plan;
  plan.scene_ = scene;
  plan.hold_s_ = hold_s;
  const int free_rotations = int{scene.free[3]} + int{scene.free[4]} + int{scene.free[5]};
  if (free_rotations == 2)
    return refused(scene, "dynamics.free",
                   "two free rotations are not a rotation group: what the locked one means would "
                   "depend on the order of turning",
                   "free one rotation or all three");
  plan.rotations_ = free_rotations == 0   ? Rotations::none
                    : free_rotations == 1 ? Rotations::one_axis
                                          : Rotations::three;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    plan.linear_[i] = {scene.mass_kg, scene.damping[axis], scene.stiffness[axis]};
    if (free_rotations == 1 && scene.free[i + 3]) plan.axis_ = axis;
  }
  plan.body_ = {scene.inertia_kg_m2, scene.damping.tail<3>(), scene.stiffness.tail<3>()};
  plan.turn_ = {plan.body_.inertia_kg_m2[plan.axis_], plan.body_.damping[plan.axis_],
                plan.body_.stiffness[plan.axis_]};
  const auto massless = (scene.inertia_kg_m2.array() == 0.0).count();
  if (free_rotations == 3 && massless == 2)
    return refused(scene, "object.inertia_kg_m2",
                   "no body has one principal moment alone: each is at most the sum of the others",
                   "give at least two moments, or none");
  plan.weight_W_ = scene.mass_kg * scene.gravity_m_s2;
  const bool free_translations = scene.free[0] || scene.free[1] || scene.free[2];
  plan.force_follows_ =
      scene.wrench_frame == WrenchFrame::object && free_rotations > 0 && free_translations;
  // The logarithm starts on its principal branch, whatever sign the file gave the quaternion.
  plan.branch_ = scene.initial_pose.q_WO.w() < 0.0 ? -1.0 : 1.0;

  plan.travel_.fill({-kUnbounded, kUnbounded});
  for (const auto& limit : scene.limits) {
    const auto dof = static_cast<std::size_t>(limit.dof);
    plan.travel_[dof] = {limit.least, limit.most};
    plan.limited_[dof] = scene.free[dof];
    if (dof >= 3 && free_rotations == 3)
      return refused(scene, "dynamics.limits",
                     "a travel limit of " + std::string(kDofNames[dof]) +
                         " has no meaning while all three rotations are free",
                     "remove the limit, or free one rotation only");
  }
  const double angle_rad = plan.initial_state().angle_rad;
  const Travel& turn = plan.travel_[static_cast<std::size_t>(plan.axis_) + 3];
  if (free_rotations == 1 && (angle_rad < turn.least || angle_rad > turn.most))
    return refused(scene, "initial.quaternion_wxyz", "starts outside the limit of the rotation",
                   "start inside the limit, or widen it");

  for (unsigned mask = 0; mask < 8; ++mask) plan.acts_[mask] = grasp_rule_holds(scene, mask);
  plan.steps_ = plan.coefficients(hold_s);
  return plan;
}

ObjectState Plan::initial_state() const {
  ObjectState state;
  state.pose = scene_.initial_pose;
  state.v_WO_W = scene_.initial_v_WO_W;
  state.w_WO_W = scene_.initial_w_WO_W;
  if (rotations_ == Rotations::one_axis) {
    const Quat& q = scene_.initial_pose.q_WO;
    state.angle_rad = 2.0 * std::atan2(branch_ * q.vec()[axis_], branch_ * q.w());
  }
  return state;
}

int Plan::substeps() const noexcept {
  if (rotations_ != Rotations::three) return 0;
  return so3::divide(so3::fastest_rate(body_, {}, {}, hold_s_), hold_s_).substeps;
}

Plan::Coefficients Plan::coefficients(double hold_s) const noexcept {
  Coefficients steps;
  steps.hold_s = hold_s;
  for (std::size_t i = 0; i < 3; ++i)
    if (scene_.free[i]) steps.linear[i] = LinearStep(linear_[i], hold_s);
  if (rotations_ == Rotations::one_axis) steps.turn = LinearStep(turn_, hold_s);
  return steps;
}

GraspWrench Plan::grasp(const FingerWrenches& wrench_C, ObjectState& state) const noexcept {
  GraspWrench out;
  unsigned mask = 0;
  Wrench F_O;  // hand: in world axes; object: in object axes
  for (const Contact& contact : scene_.contacts) {
    const std::size_t f = index_of(contact.finger);
    const Wrench& measured = wrench_C[f];
    const bool on = in_contact(state.contact[f], measured.force.z(), contact.threshold_N);
    state.contact[f] = on;
    out.contact[f] = on;
    if (!on) continue;
    mask |= 1u << f;
    const Transmitted passed = transmit(contact, measured);
    out.utilisation[f] = passed.utilisation;
    out.slip[f] = passed.slip();
    const Vec3 force = contact.R_OC * passed.F_C.force;
    F_O.force += force;
    F_O.torque += contact.p_OC.cross(force);
    if (contact.model == ContactModel::soft)
      F_O.torque += passed.F_C.torque.z() * contact.R_OC.col(2);
  }
  if (!acts_[mask]) return out;
  if (scene_.wrench_frame == WrenchFrame::object && rotations_ != Rotations::none) {
    out.F_O_W.force = state.pose.q_WO * F_O.force;
    out.F_O_W.torque = state.pose.q_WO * F_O.torque;
  } else {
    out.F_O_W = F_O;
  }
  return out;
}

void Plan::move(const GraspWrench& wrench, ObjectState& state) const noexcept {
  move(steps_, wrench, state);
}

void Plan::move(const GraspWrench& wrench, double hold_s, ObjectState& state) const noexcept {
  if (hold_s == hold_s_)
    move(steps_, wrench, state);
  else
    move(coefficients(hold_s), wrench, state);
}

}  // namespace isograsp
