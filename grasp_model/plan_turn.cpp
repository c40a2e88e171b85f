// SPDX-License-Identifier: GPL-3.0-or-later
// The plan's motion while the object turns inside the hold: three free rotations, and translations
// under a force that turns with the object.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "grasp_model/plan.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp {

namespace {

/// Of half of so3::kSpringReach_rad, 1.9 pi.
constexpr double kCosineOfReach = -0.98768834059513773;
/// A hold divided by 2^level: exact.
constexpr std::array<double, kFinestLevel + 1> kPart{1.0,        1.0 / 2.0,  1.0 / 4.0, 1.0 / 8.0,
                                                     1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0};
/// A panel turns the fastest rate by at most this: error of the quadrature below 1e-13 of the
/// force.
constexpr double kPanel_rad = 0.5;
/// If a damper needs more than 2 to this explicit steps, one stiff step is better.
constexpr int kStiffLevel = 3;
/// A step of twice the length makes an error larger by 2 to this power.
constexpr int kExplicitOrder = 8;
constexpr int kStiffOrder = 5;

/// The coarsest of levels 0 … that divides `turn_rad` into parts of `part_rad`; more than
/// kFinestLevel: not possible.
int level_for(double turn_rad, double part_rad) noexcept {
  int level = 0;
  for (; level <= kFinestLevel && !(turn_rad <= part_rad); ++level) turn_rad *= 0.5;
  return level;
}

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

void Plan::turn_freely(double hold_s, const Wrench& held, ObjectState& state) const noexcept {
  const bool world = scene_.wrench_frame == WrenchFrame::hand;
  const Vec3& force_O = held.force;
  const Vec3& torque = held.torque;
  so3::SpinRate rate = rate_;
  rate.load(world ? so3::Torques{torque, Vec3::Zero()} : so3::Torques{Vec3::Zero(), torque});
  Quat& q_WO = state.X_WO.q;
  so3::SpinVector y = so3::pack({Quat(branch_ * q_WO.coeffs()), q_WO.conjugate() * state.w_WO_W});

  const double turn_rad = rate.fastest(y, hold_s) * hold_s;
  int coarsest = coarsest_level_;
  while (coarsest < 0 && !(turn_rad <= so3::stable_rad(order_of(coarsest)))) ++coarsest;
  if (coarsest == 0) coarsest = level_for(turn_rad, so3::stable_rad(so3::Order::eighth));
  const bool stiff = coarsest > (rate.overdamped() ? kStiffLevel : kFinestLevel);
  if (stiff) coarsest = 0;
  int follow_level = 0;
  if (force_follows_) follow_level = level_for(linear_.fastest_rate() * hold_s, kPanel_rad);
  bool exceeded = follow_level > kFinestLevel ||
                  (stiff && rate.too_fast(y, std::ldexp(hold_s, -kFinestLevel), hold_s));
  if (follow_level > 0) coarsest = std::max(coarsest, std::min(follow_level, kFinestLevel));

  // What may not be followed must not gain energy either.
  const bool hard = stiff || coarsest == kFinestLevel;
  if (hard) rate.watch();

  // States at the nodes of the panel that a step makes, for the force that follows.
  so3::StageStates seen;
  int level = std::clamp(state.level, coarsest, kFinestLevel);
  const auto take = [&](const so3::SpinVector& from, double h_s) {
    return stiff ? so3::stiff_step(rate, from, h_s)
                 : so3::explicit_step(order_of(level), rate, from, h_s,
                                      force_follows_ ? &seen : nullptr);
  };
  const auto forces_along = [&](const so3::SpinVector& from, const so3::SpinVector& to,
                                double h_s) {
    const Quadrature& nodes = stage_nodes(order_of(level));
    PanelForces forces;
    forces.begin = weight_W_ + turned(from, force_O);
    forces.end = weight_W_ + turned(to, force_O);
    for (std::size_t n = 0; n < nodes.size; ++n)
      forces.node[n] = weight_W_ + turned(stiff ? so3::between(from, to, h_s, nodes.time[n])
                                                : seen[nodes.stage[n]],
                                          force_O);
    return forces;
  };

  const so3::SpinVector start = y;
  const int order = stiff ? kStiffOrder : kExplicitOrder;
  constexpr int kSlots = 1 << kFinestLevel;
  double error_rad = 0.0;
  for (int slot = 0; slot < kSlots;) {
    const int halvings = std::max(level, 0);
    const double part = kPart[static_cast<std::size_t>(halvings)];
    const double h_s = part * hold_s;
    const so3::SpinStep step = take(y, h_s);
    const double allowed_rad = part * scene_.tolerance_rad;
    if (!(step.error_rad <= allowed_rad) && level < kFinestLevel) {
      ++level;
      continue;
    }
    if (force_follows_) {
      const Follower& follower = followers_[static_cast<std::size_t>(order_of(level))];
      const PanelForces forces = forces_along(y, step.end, h_s);
      const auto between = [&](double from_s, double to_s) {
        const so3::SpinVector at = from_s > 0.0 ? take(y, from_s).end : y;
        return forces_along(at, take(at, to_s - from_s).end, to_s - from_s);
      };
      std::optional<QuadraturePanel> fresh;
      push_over(
          follower,
          hold_s == hold_s_ ? follower.panel(halvings) : fresh.emplace(follower.panel_of(h_s)),
          forces, between, state);
    }
    y = step.end;
    error_rad += step.error_rad;
    slot += kSlots >> halvings;
    if (level <= coarsest) continue;
    if (level <= 0) {
      if (step.coarser_rad <= allowed_rad) --level;
    } else if (slot % (kSlots >> (level - 1)) == 0 &&
               std::ldexp(step.error_rad, order) <= allowed_rad) {
      --level;
    }
  }
  exceeded = exceeded || !(error_rad <= scene_.tolerance_rad);
  if (!(y.squaredNorm() < std::numeric_limits<double>::infinity()))
    y = so3::pack({so3::unpack(start).q_WO, Vec3::Zero()});
  if (rate_.watched() || (exceeded && hard))
    error_rad += rate.limit_energy(rate.energy(start) + y[7], y);
  rate.settle(y);
  y.head<4>() /= y.head<4>().norm();
  const so3::Spin spin = so3::unpack(y);
  // The angle is beyond kSpringReach_rad.
  if (spin.q_WO.w() < kCosineOfReach && rate.spring()) exceeded = true;
  state.level = level;
  state.error_rad = error_rad;
  state.tolerance_exceeded = exceeded || !(error_rad <= scene_.tolerance_rad);
  q_WO.coeffs() = branch_ * spin.q_WO.coeffs();
  state.w_WO_W = q_WO * spin.w_O;
}

}  // namespace isograsp
