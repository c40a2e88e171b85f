// SPDX-License-Identifier: GPL-3.0-or-later
// One hold of any plan: from finger forces to the wrench, and the motion along axes, coupled axes
// and about one axis.
#include <algorithm>
#include <cmath>

#include "grasp_model/plan.hpp"

namespace isograsp {

namespace {

/// Columns times force, each row in the same order as in plan_lanes.cpp.
Vec6 product(const Eigen::Matrix<double, 6, 4>& columns, const ContactForce& f) noexcept {
  Vec6 sum = (columns.col(0) * f.fx + columns.col(1) * f.fy) + columns.col(2) * f.fz;
  if (f.tz != 0.0) sum += columns.col(3) * f.tz;
  return sum;
}

}  // namespace

template <class Use>
unsigned Plan::touch(const FingerWrenches& wrench_C, ObjectState& state,
                     const Use& use) const noexcept {
  unsigned mask = 0;
  for (std::size_t i = 0; i < contacts_; ++i) {
    const Pressing& contact = pressing_[i];
    const Wrench& measured = wrench_C[contact.finger];
    if (!usable(contact.limit, measured)) continue;  // no sample: state kept, no force passed
    bool& on = state.contact[contact.finger];
    on = contact.rule.touches(on, measured.force.z());
    if (!on) continue;
    mask |= contact.bit;
    use(contact, measured, clamp_to_friction(contact.limit, measured));
  }
  return mask;
}

GraspWrench Plan::grasp(const FingerWrenches& wrench_C, ObjectState& state) const noexcept {
  GraspWrench out;
  Vec6 sum = Vec6::Zero();
  const unsigned mask =
      touch(wrench_C, state,
            [&](const Pressing& contact, const Wrench& measured, const ContactForce& force) {
              sum += product(contact.all, force);
              out.utilisation[contact.finger] = utilisation(contact.limit, measured);
              out.slip[contact.finger] = force.slip;
            });
  for (std::size_t i = 0; i < contacts_; ++i) {
    const std::size_t f = pressing_[i].finger;
    out.contact[f] = state.contact[f];
    out.invalid[f] = !usable(pressing_[i].limit, wrench_C[f]);
  }
  if (!acts_[mask]) return out;
  out.held = {sum.head<3>(), sum.tail<3>()};
  out.F_O_W = out.held;
  if (scene_.wrench_frame == WrenchFrame::object && rotations_ != Rotations::none)
    out.F_O_W = {state.X_WO.q * out.held.force, state.X_WO.q * out.held.torque};
  return out;
}

std::array<double, 6> Plan::rows_of(const Wrench& held) const noexcept {
  Vec6 all;
  all << held.force, held.torque;
  std::array<double, 6> rows{};
  for (std::size_t r = 0; r < row_count_; ++r) rows[r] = all[rows_[r]];
  return rows;
}

void Plan::move(const GraspWrench& wrench, ObjectState& state) const noexcept {
  move(steps_, rows_of(wrench.held).data(), state);
}

void Plan::move(const GraspWrench& wrench, double hold_s, ObjectState& state) const {
  if (hold_s == hold_s_)
    move(wrench, state);
  else
    move(coefficients(hold_s), rows_of(wrench.held).data(), state);
}

Motion Plan::turn_about_axis(const LinearStep& step, double hold_s, double torque,
                             const Motion& start) const noexcept {
  const auto dof = static_cast<std::size_t>(axis_) + 3;
  if (!limited_[dof]) return step.advance(start, torque);
  return advance_within(turn_, step, travel_[dof], hold_s, start, torque);
}

void Plan::set_far_attitude(double angle_rad, ObjectState& state) const noexcept {
  const auto [cosine, sine] = so3::cos_sin(0.5 * angle_rad);
  state.X_WO.q.w() = branch_ * cosine;
  state.X_WO.q.vec()[axis_] = branch_ * sine;
}

void Plan::move_coupled(const CoupledStep& step, const double* rows,
                        ObjectState& state) const noexcept {
  Vec3 x = Vec3::Zero();
  Vec3 force_W = Vec3::Zero();
  for (std::size_t a = 0; a < axis_count_; ++a) {
    const Eigen::Index axis = axes_[a];
    x[axis] = state.X_WO.p[axis] - anchor_m_[axis];
    force_W[axis] = rows[a] + weight_W_[axis];
  }
  step.advance(force_W, x, state.v_WO_W);
  for (std::size_t a = 0; a < axis_count_; ++a)
    state.X_WO.p[axes_[a]] = anchor_m_[axes_[a]] + x[axes_[a]];
}

void Plan::move_along_axes(const Coefficients& steps, const double* rows,
                           ObjectState& state) const noexcept {
  for (std::size_t a = 0; a < axis_count_; ++a) {
    const Eigen::Index axis = axes_[a];
    const auto i = static_cast<std::size_t>(axis);
    const double anchor = anchor_m_[axis];
    const double force = rows[a] + weight_W_[axis];
    double& p = state.X_WO.p[axis];
    const Motion start{p - anchor, state.v_WO_W[axis]};
    Motion end;
    if (limited_[i]) {
      const Travel travel{travel_[i].least - anchor, travel_[i].most - anchor};
      end = advance_within(linear_.oscillator[i], steps.linear[i], travel, steps.hold_s, start,
                           force);
      p = std::clamp(anchor + end.x, travel_[i].least, travel_[i].most);
    } else {
      end = steps.linear[i].advance(start, force);
      p = anchor + end.x;
    }
    state.v_WO_W[axis] = end.v;
  }
}

void Plan::move(const Coefficients& steps, const double* rows, ObjectState& state) const noexcept {
  if (coupled_)
    move_coupled(steps.coupled, rows, state);
  else if (!force_follows_)
    move_along_axes(steps, rows, state);
  if (rotations_ == Rotations::none) return;
  if (force_follows_ || rotations_ == Rotations::three) {
    turn(steps, rows, state);
    return;
  }
  // One axis: the same in world and object axes, and so is the torque about it.
  set_turn(turn_about_axis(steps.turn, steps.hold_s, rows[axis_count_],
                           {state.angle_rad, state.w_WO_W[axis_]}),
           state);
}

void Plan::step_any(const FingerWrenches& wrench_C, ObjectState& state) const noexcept {
  Vec6 sum = Vec6::Zero();
  const unsigned mask = touch(
      wrench_C, state, [&sum](const Pressing& contact, const Wrench&, const ContactForce& force) {
        sum += product(contact.moving, force);
      });
  if (!acts_[mask]) sum.setZero();
  move(steps_, sum.data(), state);
}

void Plan::step(const FingerWrenches& wrench_C, ObjectState& state) const noexcept {
  if (lanes_.step != nullptr)
    lanes_.step(*this, wrench_C, state);
  else
    step_any(wrench_C, state);
}

void Plan::step_narrow(const FingerWrenches& wrench_C, ObjectState& state) const noexcept {
  if (lanes_.narrow != nullptr)
    lanes_.narrow(*this, wrench_C, state);
  else
    step_any(wrench_C, state);
}

}  // namespace isograsp
