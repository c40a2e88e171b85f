// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene to its plan.
#include "grasp_model/plan.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "grasp_model/grasp.hpp"

namespace isograsp {

namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
/// With a tolerance above this, lower orders are tried and energy is watched; below it the motion
/// is as good as exact and nothing would be gained.
constexpr double kWatched_rad = 1e-9;

/// Matrix of springs or dampers along axes turned against the world.
Mat3 in_world(const Mat3& R_WA, const Vec3& values) {
  if (values.x() == values.y() && values.y() == values.z()) return values.asDiagonal();
  return R_WA * values.asDiagonal() * R_WA.transpose();
}

}  // namespace

Result<Plan> Plan::compile(const Scene& scene, double hold_s) {
  if (!(hold_s > 0.0) || !std::isfinite(hold_s))
    return refused("a hold of %1 s is not possible"_text(shortest(hold_s)),
                   "give times that increase"_text)
        .at(scene.file);
  const int free_rotations = int{scene.free[3]} + int{scene.free[4]} + int{scene.free[5]};
  if (free_rotations == 2)
    return refused(
               "two free rotations are not a rotation group: what the locked one means would "
               "depend on the order of turning"_text,
               "free one rotation or all three"_text)
        .at(scene.file)
        .about("dynamics.free");
  if (free_rotations == 3 && (scene.inertia_kg_m2.array() == 0.0).count() == 2)
    return refused(
               "no body has one principal moment alone: each is at most the sum of the others"_text,
               "give at least two moments, or none"_text)
        .at(scene.file)
        .about("object.inertia_kg_m2");
  Plan plan;
  plan.scene_ = scene;
  plan.hold_s_ = hold_s;
  plan.rotations_ = free_rotations == 0   ? Rotations::none
                    : free_rotations == 1 ? Rotations::one_axis
                                          : Rotations::three;
  plan.anchor_m_ = scene.anchor_m;
  plan.weight_W_ = scene.mass_kg * scene.gravity_m_s2;
  // The logarithm starts on its principal branch, whatever sign the file gave the quaternion.
  plan.branch_ = scene.initial_X_WO.q.w() < 0.0 ? -1.0 : 1.0;
  plan.coupling_ = {scene.mass_kg,
                    in_world(scene.R_WD, scene.damping.head<3>()),
                    in_world(scene.R_WK, scene.stiffness.head<3>()),
                    {scene.free[0], scene.free[1], scene.free[2]}};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    plan.linear_.oscillator[i] = {scene.mass_kg, plan.coupling_.damping(axis, axis),
                                  plan.coupling_.stiffness(axis, axis)};
    plan.linear_.free[i] = scene.free[i];
    if (scene.free[i]) plan.axes_[plan.axis_count_++] = axis;
    if (free_rotations == 1 && scene.free[i + 3]) plan.axis_ = axis;
  }
  plan.coupled_ = plan.coupling_.coupled();
  plan.rate_ =
      so3::SpinRate({scene.inertia_kg_m2, scene.damping.tail<3>(), scene.stiffness.tail<3>()});
  plan.turn_ = {scene.inertia_kg_m2[plan.axis_], scene.damping[plan.axis_ + 3],
                scene.stiffness[plan.axis_ + 3]};
  plan.force_follows_ =
      scene.wrench_frame == WrenchFrame::object && free_rotations > 0 && plan.axis_count_ > 0;
  if (plan.coupled_ && plan.force_follows_)
    return refused(
               "the force turns with the object while springs or dampers stand at an angle to "
               "the world's axes"_text,
               "align them, or write wrench_frame = \"hand\""_text)
        .at(scene.file)
        .about("dynamics.wrench_frame");

  plan.travel_.fill({-kUnbounded, kUnbounded});
  for (const auto& limit : scene.limits) {
    const auto dof = static_cast<std::size_t>(limit.dof);
    plan.travel_[dof] = {limit.least, limit.most};
    plan.limited_[dof] = scene.free[dof];
    if (dof >= 3 && free_rotations == 3)
      return refused("a travel limit of %1 has no meaning while all three rotations are free"_text(
                         kDofNames[dof]),
                     "remove the limit, or free one rotation only"_text)
          .at(scene.file)
          .about("dynamics.limits");
    if (dof < 3 && plan.coupled_)
      return refused(
                 "a travel limit of %1 while springs or dampers at an angle couple the axes"_text(
                     kDofNames[dof]),
                 "remove the limit, or align springs and dampers with the world"_text)
          .at(scene.file)
          .about("dynamics.limits");
  }
  const double angle_rad = plan.initial_state().angle_rad;
  const Travel& turn = plan.travel_[static_cast<std::size_t>(plan.axis_) + 3];
  if (free_rotations == 1 && (angle_rad < turn.least || angle_rad > turn.most))
    return refused("starts outside the limit of the rotation"_text,
                   "start inside the limit, or widen it"_text)
        .at(scene.file)
        .about("initial.quaternion_wxyz");

  plan.compile_contacts();
  plan.steps_ = plan.coefficients(hold_s);
  plan.compile_lanes();
  plan.compile_levels();
  return plan;
}

void Plan::compile_contacts() {
  // Rows that act on something free. A force that turns with the object acts in the whole plane
  // across the axis.
  std::array<bool, 6> moves = scene_.free;
  if (force_follows_)
    for (std::size_t i = 0; i < 3; ++i)
      moves[i] =
          rotations_ == Rotations::three || scene_.free[i] || static_cast<Eigen::Index>(i) != axis_;
  for (std::size_t dof = 0; dof < 6; ++dof)
    if (moves[dof]) rows_[row_count_++] = static_cast<Eigen::Index>(dof);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const Contact* const found = scene_.contact_of(static_cast<Finger>(f));
    if (found == nullptr) continue;
    const Contact& contact = *found;
    Pressing& pressing = pressing_[contacts_++];
    pressing.finger = f;
    pressing.bit = 1u << pressing.finger;
    pressing.rule = TouchRule(contact.threshold_N);
    pressing.limit = FrictionLimit(contact);
    torsion_ = torsion_ || pressing.limit.torsional;
    const auto columns = contact_columns(contact);
    for (Eigen::Index c = 0; c < columns.cols(); ++c) {
      // A frictionless contact has one column, that of f_z.
      const Eigen::Index column = columns.cols() == 1 ? 2 : c;
      pressing.all.col(column) = columns.col(c);
      for (std::size_t r = 0; r < row_count_; ++r)
        pressing.moving(static_cast<Eigen::Index>(r), column) = columns(rows_[r], c);
    }
  }
  for (unsigned mask = 0; mask < 8; ++mask) acts_[mask] = grasp_rule_holds(scene_, mask);
}

void Plan::compile_levels() {
  if (rotations_ == Rotations::three && scene_.tolerance_rad > kWatched_rad) {
    rate_.watch();
    // A force that turns is integrated along the rotation's stages: their order must do for what
    // the translations remember of it.
    const double remembered_rad = force_follows_ ? linear_.fastest_rate() * hold_s_ : 0.0;
    const so3::SpinVector start = so3::pack(
        {scene_.initial_X_WO.q, scene_.initial_X_WO.q.conjugate() * scene_.initial_w_WO_W});
    const double turn_rad = rate_.fastest(start, hold_s_) * hold_s_;
    for (int level = -1; level >= kCoarsestLevel; --level) {
      const so3::Order order = order_of(level);
      const bool fifth = order == so3::Order::fifth;
      const double forgotten =
          fifth ? std::pow(remembered_rad, 5) / 720.0 : std::pow(remembered_rad, 3) / 24.0;
      if (forgotten > scene_.tolerance_rad) break;
      coarsest_level_ = level;
      if (so3::typical_error_rad(order, turn_rad) <= scene_.tolerance_rad) likely_level_ = level;
    }
  }
  if (!force_follows_) return;
  if (rotations_ == Rotations::one_axis)
    followers_.back() = Follower(linear_, gauss5(), hold_s_, kFinestLevel);
  else
    for (int level = coarsest_level_; level <= 0; ++level)
      followers_[static_cast<std::size_t>(order_of(level))] =
          Follower(linear_, stage_nodes(order_of(level)), hold_s_, level == 0 ? kFinestLevel : 0);
}

ObjectState Plan::initial_state() const {
  ObjectState state;
  state.level = likely_level_;
  state.X_WO = scene_.initial_X_WO;
  state.v_WO_W = scene_.initial_v_WO_W;
  state.w_WO_W = scene_.initial_w_WO_W;
  if (rotations_ == Rotations::one_axis) {
    const Quat& q = scene_.initial_X_WO.q;
    state.angle_rad = 2.0 * std::atan2(branch_ * q.vec()[axis_], branch_ * q.w());
  }
  return state;
}

ObjectState Plan::at_rest(const Pose& X_WO) const noexcept {
  ObjectState state;
  state.level = likely_level_;
  state.X_WO = scene_.initial_X_WO;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (scene_.free[static_cast<std::size_t>(i)]) state.X_WO.p[i] = X_WO.p[i];
  // Both signs of a quaternion are the same attitude: the springs take the shorter way back.
  if (rotations_ == Rotations::three)
    state.X_WO.q.coeffs() =
        X_WO.q.w() < 0.0 ? -branch_ * X_WO.q.coeffs() : branch_ * X_WO.q.coeffs();
  if (rotations_ == Rotations::one_axis) {
    const double angle_rad = 2.0 * std::atan2(X_WO.q.vec()[axis_], X_WO.q.w());
    state.angle_rad = std::remainder(angle_rad, 2.0 * std::numbers::pi);
    set_attitude(state.angle_rad, state);
  }
  return state;
}

Plan::Coefficients Plan::coefficients(double hold_s) const {
  Coefficients steps;
  steps.hold_s = hold_s;
  if (rotations_ == Rotations::one_axis) steps.turn = LinearStep(turn_, hold_s);
  if (force_follows_) return steps;
  if (coupled_) {
    steps.coupled = CoupledStep(coupling_, hold_s);
    return steps;
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (scene_.free[i]) steps.linear[i] = LinearStep(linear_.oscillator[i], hold_s);
  return steps;
}

}  // namespace isograsp
