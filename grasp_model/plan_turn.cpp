// SPDX-License-Identifier: GPL-3.0-or-later
// The plan's motion while the object turns inside the hold: three free rotations, and translations
// under a force that turns with the object.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "grasp_model/free_turn.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp {

namespace {

/// A force in world axes that is constant in object axes. If q is not of length 1: as in SpinRate.
Vec3 turned(const so3::SpinVector& y, const Vec3& force_O) noexcept {
  const Vec3 v = y.segment<3>(1);
  const Vec3 t = 2.0 * v.cross(force_O);
  return force_O + y[0] * t + v.cross(t);
}

}  // namespace

template <class Between>
void Plan::push_over(const Follower& follower, const QuadraturePanel& panel,
                     const PanelForces& forces, const Between& between,
                     ObjectState& state) const noexcept {
  for (std::size_t a = 0; a < axis_count_; ++a) {
    const Eigen::Index axis = axes_[a];
    const auto i = static_cast<std::size_t>(axis);
    const double anchor = anchor_m_[axis];
    double& p = state.X_WO.p[axis];
    double& v = state.v_WO_W[axis];
    const Motion end = panel.advance(axis, {p - anchor, v}, forces);
    if (!limited_[i]) {
      p = anchor + end.x;
      v = end.v;
      continue;
    }
    const Travel& travel = travel_[i];
    const double k = linear_.oscillator[i].k;
    const auto rests = [&](double position, double force) {
      const double pull = force - k * (position - anchor);
      return (position >= travel.most && pull >= 0.0) || (position <= travel.least && pull <= 0.0);
    };
    if (v == 0.0 && rests(p, forces.begin[axis])) continue;
    const auto outside = [&](double x) {
      return anchor + x > travel.most || anchor + x < travel.least;
    };
    if (!outside(end.x)) {
      p = std::clamp(anchor + end.x, travel.least, travel.most);
      v = end.v;
      continue;
    }
    // The crossing, by bisection of the panel; from there at rest or back inside.
    const Motion start{p - anchor, v};
    double inside_s = 0.0;
    double outside_s = panel.length_s();
    for (int halving = 0; halving < 60; ++halving) {
      const double middle_s = 0.5 * (inside_s + outside_s);
      if (middle_s <= inside_s || middle_s >= outside_s) break;
      const Motion there = follower.panel_of(middle_s).advance(axis, start, between(0.0, middle_s));
      (outside(there.x) ? outside_s : inside_s) = middle_s;
    }
    p = anchor + end.x > travel.most ? travel.most : travel.least;
    v = 0.0;
    const double left_s = panel.length_s() - outside_s;
    if (!(left_s > 0.0)) continue;
    const PanelForces after = between(outside_s, panel.length_s());
    if (rests(p, after.begin[axis])) continue;
    const Motion back = follower.panel_of(left_s).advance(axis, {p - anchor, 0.0}, after);
    p = std::clamp(anchor + back.x, travel.least, travel.most);
    v = back.v;
  }
}

void Plan::turn(const Coefficients& steps, const double* rows, ObjectState& state) const noexcept {
  Vec6 held = Vec6::Zero();
  for (std::size_t r = 0; r < row_count_; ++r) held[rows_[r]] = rows[r];
  if (rotations_ == Rotations::three)
    turn_freely(steps.hold_s, {held.head<3>(), held.tail<3>()}, state);
  else
    follow_about_axis(steps, held, state);
}

void Plan::follow_about_axis(const Coefficients& steps, const Vec6& held,
                             ObjectState& state) const noexcept {
  const double hold_s = steps.hold_s;
  const Vec3 force_O = held.head<3>();
  const double torque = held[axis_ + 3];
  const double gained = turn_.m == 0.0 ? std::abs(torque) / turn_.c
                                       : std::abs(torque) / std::max(turn_.m / hold_s, turn_.c);
  const double rate =
      linear_.fastest_rate() + fastest_rate(turn_) + std::abs(state.w_WO_W[axis_]) + gained;
  const int wanted = level_for(rate * hold_s, kPanel_rad);
  state.tolerance_exceeded = wanted > kFinestLevel;
  const int level = std::min(wanted, kFinestLevel);
  const int panels = 1 << level;
  const double panel_s = hold_s / panels;

  const Follower& follower = followers_.back();
  std::optional<QuadraturePanel> fresh;
  const QuadraturePanel& panel =
      hold_s == hold_s_ ? follower.panel(level) : fresh.emplace(follower.panel_of(panel_s));
  Motion turn{state.angle_rad, state.w_WO_W[axis_]};
  const auto after = [&](double time_s) {
    const LinearStep step(turn_, time_s);
    const auto dof = static_cast<std::size_t>(axis_) + 3;
    if (!limited_[dof]) return step.advance(turn, torque);
    return advance_within(turn_, step, travel_[dof], time_s, turn, torque);
  };
  const auto force_at = [&](double angle_rad) -> Vec3 {
    const auto [cosine, sine] = so3::cos_sin(angle_rad);
    const Eigen::Index j = (axis_ + 1) % 3;
    const Eigen::Index k = (axis_ + 2) % 3;
    Vec3 force_W = weight_W_;
    force_W[axis_] += force_O[axis_];
    force_W[j] += cosine * force_O[j] - sine * force_O[k];
    force_W[k] += sine * force_O[j] + cosine * force_O[k];
    return force_W;
  };
  const auto between = [&](double from_s, double to_s) {
    PanelForces forces;
    forces.begin = force_at(after(from_s).x);
    for (std::size_t n = 0; n < follower.nodes().size; ++n)
      forces.node[n] = force_at(after(from_s + (to_s - from_s) * follower.nodes().time[n]).x);
    forces.end = force_at(after(to_s).x);
    return forces;
  };
  for (int i = 0; i < panels; ++i) {
    push_over(follower, panel, between(0.0, panel_s), between, state);
    turn = after(panel_s);
  }
  set_turn(turn, state);
}

FreeTurn::Terms Plan::turn_terms(double hold_s) const noexcept {
  return {hold_s,          scene_.tolerance_rad,
          coarsest_level_, scene_.wrench_frame == WrenchFrame::hand,
          branch_,         force_follows_ ? std::optional(linear_.fastest_rate()) : std::nullopt};
}

void Plan::turn_freely(double hold_s, const Wrench& held, ObjectState& state) const noexcept {
  FreeTurn body(rate_, turn_terms(hold_s), held.torque, state.X_WO.q, state.w_WO_W, state.level);
  const Vec3& force_O = held.force;
  // States at the nodes of the panel that a step makes, for the force that follows.
  so3::StageStates seen;
  const auto take = [&](const so3::SpinVector& from, double h_s) {
    return body.stiff() ? so3::stiff_step(body.rate(), from, h_s)
                        : so3::explicit_step(order_of(body.level()), body.rate(), from, h_s,
                                             force_follows_ ? &seen : nullptr);
  };
  const auto forces_along = [&](const so3::SpinVector& from, const so3::SpinVector& to,
                                double h_s) {
    const Quadrature& nodes = stage_nodes(order_of(body.level()));
    PanelForces forces;
    forces.begin = weight_W_ + turned(from, force_O);
    forces.end = weight_W_ + turned(to, force_O);
    for (std::size_t n = 0; n < nodes.size; ++n)
      forces.node[n] = weight_W_ + turned(body.stiff() ? so3::between(from, to, h_s, nodes.time[n])
                                                       : seen[nodes.stage[n]],
                                          force_O);
    return forces;
  };
  while (body.turning()) {
    const double h_s = body.step_s();
    const so3::SpinStep step = take(body.y(), h_s);
    if (!body.accepts(step)) continue;
    if (force_follows_) {
      const Follower& follower = followers_[static_cast<std::size_t>(order_of(body.level()))];
      const PanelForces forces = forces_along(body.y(), step.end, h_s);
      const auto between = [&](double from_s, double to_s) {
        const so3::SpinVector at = from_s > 0.0 ? take(body.y(), from_s).end : body.y();
        return forces_along(at, take(at, to_s - from_s).end, to_s - from_s);
      };
      std::optional<QuadraturePanel> fresh;
      push_over(follower,
                hold_s == hold_s_ ? follower.panel(body.halvings())
                                  : fresh.emplace(follower.panel_of(h_s)),
                forces, between, state);
    }
    body.advance(step);
  }
  state.level = body.level();
  const auto [error_rad, exceeded] = body.finish(branch_, state.X_WO.q, state.w_WO_W);
  state.error_rad = error_rad;
  state.tolerance_exceeded = exceeded;
}

}  // namespace isograsp
