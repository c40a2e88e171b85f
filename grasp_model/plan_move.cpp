// SPDX-License-Identifier: GPL-3.0-or-later
// The plan's step: how the object moves over one hold (docs/grasp_model.md).
#include <algorithm>
#include <cmath>
#include <optional>

#include "grasp_model/plan.hpp"

namespace isograsp {

namespace {

// Gauss-Legendre nodes and weights on [0, 1], exact for polynomials of degree 9.
constexpr std::size_t kNodes = 5;
constexpr std::array<double, kNodes> kNode{0.046910077030668004, 0.23076534494715845, 0.5,
                                           0.76923465505284155, 0.953089922969332};
constexpr std::array<double, kNodes> kWeight{0.11846344252809454, 0.23931433524968324,
                                             0.28444444444444444, 0.23931433524968324,
                                             0.11846344252809454};
/// A panel of the quadrature turns the fastest rate by at most this: error below 1e-13 of the
/// force.
constexpr double kPanel_rad = 0.5;
/// With travel limits the crossing is found to one panel.
constexpr int kPanelsWithLimits = 16;

double rate_of(const Oscillator& o) noexcept {
  return o.m == 0.0 ? o.k / o.c : std::sqrt(o.k / o.m) + o.c / o.m;
}

}  // namespace

/// One panel of a hold during which the force turns with the object.
struct Plan::Panel {
  Panel(const Plan& plan, double panel_s) noexcept : length_s(panel_s) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!plan.scene_.free[i]) continue;
      whole[i] = LinearStep(plan.linear_[i], panel_s);
      for (std::size_t n = 0; n < kNodes; ++n)
        response[i][n] = LinearStep(plan.linear_[i], panel_s * (1.0 - kNode[n])).impulse();
    }
  }
  double length_s;
  std::array<LinearStep, 3> whole;
  std::array<std::array<Motion, kNodes>, 3> response;  ///< at the panel's end to a push at the node
  std::array<Vec3, kNodes> force_W;                    ///< at the nodes
  Vec3 force_at_end_W;
};

void Plan::move(const Coefficients& steps, const GraspWrench& wrench,
                ObjectState& state) const noexcept {
  state.tolerance_exceeded = false;
  const Wrench& F_O_W = wrench.F_O_W;
  if (rotations_ == Rotations::one_axis && force_follows_) {
    follow_about_axis(steps.hold_s, F_O_W, state);
    return;
  }
  if (!force_follows_) move_along_axes(steps, F_O_W.force + weight_W_, state);
  if (rotations_ == Rotations::one_axis) {
    // The axis is the same in world and object axes, and so is the torque about it.
    const Motion start{state.angle_rad, state.w_WO_W[axis_]};
    set_turn(turn_about_axis(steps.turn, steps.hold_s, F_O_W.torque[axis_], start), state);
  } else if (rotations_ == Rotations::three) {
    turn_freely(steps.hold_s, F_O_W, state);
  }
}

void Plan::move_along_axes(const Coefficients& steps, const Vec3& force_W,
                           ObjectState& state) const noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!scene_.free[i]) continue;
    const auto axis = static_cast<Eigen::Index>(i);
    const double anchor = scene_.anchor_m[axis];
    double& p = state.pose.p_WO[axis];
    const Motion start{p - anchor, state.v_WO_W[axis]};
    Motion end;
    if (limited_[i]) {
      const Travel travel{travel_[i].least - anchor, travel_[i].most - anchor};
      end = advance_within(linear_[i], steps.linear[i], travel, steps.hold_s, start, force_W[axis]);
      p = std::clamp(anchor + end.x, travel_[i].least, travel_[i].most);
    } else {
      end = steps.linear[i].advance(start, force_W[axis]);
      p = anchor + end.x;
    }
    state.v_WO_W[axis] = end.v;
  }
}

Motion Plan::turn_about_axis(const LinearStep& step, double hold_s, double torque,
                             const Motion& start) const noexcept {
  const auto dof = static_cast<std::size_t>(axis_) + 3;
  if (!limited_[dof]) return step.advance(start, torque);
  return advance_within(turn_, step, travel_[dof], hold_s, start, torque);
}

void Plan::set_turn(const Motion& turn, ObjectState& state) const noexcept {
  state.angle_rad = turn.x;
  state.w_WO_W[axis_] = turn.v;
  state.pose.q_WO.w() = branch_ * std::cos(0.5 * turn.x);
  state.pose.q_WO.vec()[axis_] = branch_ * std::sin(0.5 * turn.x);
}

double Plan::linear_rate() const noexcept {
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    if (scene_.free[i]) rate = std::max(rate, rate_of(linear_[i]));
  return rate;
}

void Plan::push_over(const Panel& panel, ObjectState& state) const noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!scene_.free[i]) continue;
    const auto axis = static_cast<Eigen::Index>(i);
    const double anchor = scene_.anchor_m[axis];
    // Exact for the force at the end of the panel, quadrature for its difference from that: what a
    // stiff axis remembers is the end, where the difference vanishes.
    const Motion start{state.pose.p_WO[axis] - anchor, state.v_WO_W[axis]};
    Motion end = panel.whole[i].advance(start, panel.force_at_end_W[axis]);
    for (std::size_t n = 0; n < kNodes; ++n) {
      const double push =
          kWeight[n] * panel.length_s * (panel.force_W[n][axis] - panel.force_at_end_W[axis]);
      end.x += push * panel.response[i][n].x;
      end.v += push * panel.response[i][n].v;
    }
    const double p = anchor + end.x;
    const double allowed = std::clamp(p, travel_[i].least, travel_[i].most);
    state.pose.p_WO[axis] = allowed;
    state.v_WO_W[axis] = p == allowed ? end.v : 0.0;
  }
}

void Plan::follow_about_axis(double hold_s, const Wrench& F_O_W,
                             ObjectState& state) const noexcept {
  const Vec3 force_O = state.pose.q_WO.conjugate() * F_O_W.force;
  const double torque = F_O_W.torque[axis_];
  const double gained = turn_.m == 0.0 ? std::abs(torque) / turn_.c
                                       : std::abs(torque) / std::max(turn_.m / hold_s, turn_.c);
  const double rate = linear_rate() + rate_of(turn_) + std::abs(state.w_WO_W[axis_]) + gained;
  const bool limits = limited_[0] || limited_[1] || limited_[2];
  const double wanted =
      std::max(std::ceil(rate * hold_s / kPanel_rad), limits ? double{kPanelsWithLimits} : 1.0);
  state.tolerance_exceeded = !(wanted <= so3::kMostSubsteps);
  const int panels = state.tolerance_exceeded ? so3::kMostSubsteps : static_cast<int>(wanted);

  Panel panel(*this, hold_s / panels);
  std::array<LinearStep, kNodes> turn_to_node;
  for (std::size_t n = 0; n < kNodes; ++n)
    turn_to_node[n] = LinearStep(turn_, panel.length_s * kNode[n]);
  const LinearStep turn_whole(turn_, panel.length_s);
  const auto force_at = [&](double angle_rad) -> Vec3 {
    return Eigen::AngleAxisd(angle_rad, Vec3::Unit(axis_)) * force_O + weight_W_;
  };
  Motion turn{state.angle_rad, state.w_WO_W[axis_]};
  for (int i = 0; i < panels; ++i) {
    for (std::size_t n = 0; n < kNodes; ++n)
      panel.force_W[n] =
          force_at(turn_about_axis(turn_to_node[n], panel.length_s * kNode[n], torque, turn).x);
    turn = turn_about_axis(turn_whole, panel.length_s, torque, turn);
    panel.force_at_end_W = force_at(turn.x);
    push_over(panel, state);
  }
  set_turn(turn, state);
}

void Plan::turn_freely(double hold_s, const Wrench& F_O_W, ObjectState& state) const noexcept {
  Quat& q_WO = state.pose.q_WO;
  const Vec3 force_O = q_WO.conjugate() * F_O_W.force;
  so3::Torques torques;
  if (scene_.wrench_frame == WrenchFrame::hand)
    torques.world = F_O_W.torque;
  else
    torques.body = q_WO.conjugate() * F_O_W.torque;
  so3::Spin spin{Quat(branch_ * q_WO.coeffs()), q_WO.conjugate() * state.w_WO_W};

  auto division = so3::divide(so3::fastest_rate(body_, torques, spin, hold_s), hold_s);
  if (force_follows_) {
    const bool limits = limited_[0] || limited_[1] || limited_[2];
    const double wanted = std::max(std::ceil(linear_rate() * hold_s / kPanel_rad),
                                   limits ? double{kPanelsWithLimits} : 1.0);
    division.tolerance_exceeded |= !(wanted <= so3::kMostSubsteps);
    division.substeps =
        std::max(division.substeps, static_cast<int>(std::min(wanted, double{so3::kMostSubsteps})));
  }
  const double h_s = hold_s / division.substeps;
  std::optional<Panel> panel;
  if (force_follows_) panel.emplace(*this, h_s);
  for (int i = 0; i < division.substeps; ++i) {
    const so3::Spin start = spin;
    if (division.implicit)
      so3::implicit_step(body_, torques, h_s, spin);
    else
      so3::rkmk4(body_, torques, h_s, spin);
    if (!panel) continue;
    // Between the ends of the substep: the cubic in the Lie algebra that fits both velocities.
    const Vec3 turned = so3::log(start.q_WO.conjugate() * spin.q_WO);
    const Vec3 speed_at_end = so3::jr_inverse(turned, spin.w_O);
    for (std::size_t n = 0; n < kNodes; ++n) {
      const double t = kNode[n];
      const Vec3 u = t * t * (3.0 - 2.0 * t) * turned +
                     h_s * t * (1.0 - t) * ((1.0 - t) * start.w_O - t * speed_at_end);
      panel->force_W[n] = start.q_WO * so3::exp(u) * force_O + weight_W_;
    }
    panel->force_at_end_W = spin.q_WO * force_O + weight_W_;
    push_over(*panel, state);
  }
  spin.q_WO.normalize();
  if (!body_.stiffness.isZero(0.0) && so3::log(spin.q_WO).norm() > so3::kSpringReach_rad)
    division.tolerance_exceeded = true;
  state.tolerance_exceeded = division.tolerance_exceeded;
  q_WO.coeffs() = branch_ * spin.q_WO.coeffs();
  state.w_WO_W = q_WO * spin.w_O;
}

}  // namespace isograsp
