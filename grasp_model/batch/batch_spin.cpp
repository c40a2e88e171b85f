// SPDX-License-Identifier: GPL-3.0-or-later
// One hold of four objects that turn freely, an object a lane: FreeTurn side by side, each sum in
// the same order. What leaves the usual way goes it alone.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>

#include "grasp_model/batch/batch_block.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp {

namespace {

/// q v q* in the order in which Eigen turns a vector.
[[gnu::always_inline]] inline std::array<Four, 3> turned_by(const std::array<Four, 4>& q,
                                                            const std::array<Four, 3>& v,
                                                            double sign) noexcept {
  const Four x = sign * q[1], y = sign * q[2], z = sign * q[3];
  Four a = y * v[2] - z * v[1], b = z * v[0] - x * v[2], c = x * v[1] - y * v[0];
  a += a;
  b += b;
  c += c;
  return {(v[0] + q[0] * a) + (y * c - z * b), (v[1] + q[0] * b) + (z * a - x * c),
          (v[2] + q[0] * c) + (x * b - y * a)};
}
[[gnu::always_inline]] inline Four length_of(const std::array<Four, 3>& v) noexcept {
  return roots((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
}

/// One hold of four bodies.
struct SpinHold {
  so3::BodySpins start, y;
  so3::BodyTorques torques;
  Four turn_rad;  ///< by the fastest rate in the hold
  Four error_rad{};
  std::array<TurnPace, kLaneCount> pace;
};
[[gnu::always_inline]] inline void begin_of(const BatchTerms& terms, const BatchBlock& block,
                                            const std::array<Four, 3>& torque,
                                            SpinHold& hold) noexcept {
  std::array<Four, 4> q;
  unrolled<4>([&](std::size_t i)
                  __attribute__((always_inline)) { q[i] = terms.branch * block.q[i]; });
  const auto w = turned_by(block.q, block.w, -1.0);
  hold.start = hold.y = {q[0], q[1], q[2], q[3], w[0], w[1], w[2], Four{}};
  unrolled<3>([&](std::size_t i) __attribute__((always_inline)) {
    hold.torques.world[i] = only(terms.world, torque[i]);
    hold.torques.body[i] = only(~terms.world, torque[i]);
  });
  hold.torques.has_world =
      terms.world & ((torque[0] != 0.0) | (torque[1] != 0.0) | (torque[2] != 0.0));
  hold.torques.watched = terms.watched;
  hold.turn_rad =
      terms.hold_s * (length_of(w) + length_of(torque) / terms.resisting + terms.own_rate);
}
/// False: some body is at the end of what is exact; nothing has changed.
[[gnu::always_inline]] inline bool end_of(const BatchTerms& terms, const SpinHold& hold,
                                          BatchBlock& block) noexcept {
  const auto& y = hold.y;
  constexpr double kFar = 1e100;  // nothing overflows
  LaneMask good = kEveryLane;
  unrolled<7>([&](std::size_t i)
                  __attribute__((always_inline)) { good &= (y[i] < kFar) & (y[i] > -kFar); });
  if (terms.rates.spring) good &= y[0] > 0.9 * FreeTurn::kCosineOfReach;
  if (!in_every_lane(good)) return false;
  const Four length = roots((y[0] * y[0] + y[2] * y[2]) + (y[1] * y[1] + y[3] * y[3]));
  unrolled<4>([&](std::size_t i)
                  __attribute__((always_inline)) { block.q[i] = terms.branch * (y[i] / length); });
  block.w = turned_by(block.q, {y[4], y[5], y[6]}, 1.0);
  const LaneMask held = hold.error_rad <= terms.tolerance_rad;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    block.error_rad[lane] = hold.error_rad[lane];
    block.exceeded[lane] = held[lane] == 0;
    block.level[lane] = hold.pace[lane].level;
  }
  return true;
}

/// False: some body needs stiff steps, or so many that it is better alone.
[[gnu::always_inline]] inline bool set_paces(const BatchTerms& terms, const BatchBlock& block,
                                             SpinHold& hold) noexcept {
  // FreeTurn asks the same of SpinRate::fastest(), which may be rounded otherwise.
  constexpr double kRounding = 1e-12;
  const bool calm = in_every_lane((1.0 + kRounding) * hold.turn_rad <= terms.stable_rad);
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    TurnPace& pace = hold.pace[lane];
    pace.coarsest = terms.turn_terms[lane].coarsest_level;
    if (!calm) {
      const int least = pace.coarsest;
      const double turn_rad = hold.turn_rad[lane];
      pace.coarsest = TurnPace::coarsest_for(least, (1.0 + kRounding) * turn_rad);
      if (pace.coarsest > FreeTurn::kStiffLevel ||
          pace.coarsest != TurnPace::coarsest_for(least, (1.0 - kRounding) * turn_rad))
        return false;
    }
    pace.level = std::clamp(block.level[lane], pace.coarsest, kFinestLevel);
  }
  return true;
}

so3::SpinVector lane_of(const so3::BodySpins& bodies, std::size_t lane) noexcept {
  so3::SpinVector y;
  for (std::size_t i = 0; i < bodies.size(); ++i) y[static_cast<Eigen::Index>(i)] = bodies[i][lane];
  return y;
}
void set_lane(so3::BodySpins& bodies, std::size_t lane, const so3::SpinVector& y) noexcept {
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i][lane] = y[static_cast<Eigen::Index>(i)];
}
Vec3 lane_of(const std::array<Four, 3>& vectors, std::size_t lane) noexcept {
  return {vectors[0][lane], vectors[1][lane], vectors[2][lane]};
}

/// One step of one body, which no other wants to go with.
void step_alone(const BatchTerms& terms, std::size_t lane, bool narrow, SpinHold& hold) noexcept {
  TurnPace& pace = hold.pace[lane];
  so3::SpinRate rate = terms.rate[lane];
  rate.load({lane_of(hold.torques.world, lane), lane_of(hold.torques.body, lane)});
  const so3::SpinVector y = lane_of(hold.y, lane);
  const double h_s = pace.part() * terms.hold_s[lane];
  const so3::Order order = order_of(pace.level);
  const so3::SpinStep step = narrow ? so3::explicit_step_narrow(order, rate, y, h_s)
                                    : so3::explicit_step(order, rate, y, h_s, nullptr);
  if (!pace.accepts(step.error_rad, terms.tolerance_rad[lane])) return;
  pace.advance(step.error_rad, step.coarser_rad, terms.tolerance_rad[lane]);
  set_lane(hold.y, lane, step.end);
  hold.error_rad[lane] += step.error_rad;
}

/// One step of each body that wants this order.
[[gnu::always_inline]] inline void step_together(const BatchTerms& terms, so3::Order order,
                                                 bool narrow, SpinHold& hold) noexcept {
  unsigned wants = 0;
  std::array<double, kLaneCount> parts;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    const TurnPace& pace = hold.pace[lane];
    if (pace.turning() && order_of(pace.level) == order) wants |= 1U << lane;
    parts[lane] = pace.part();
  }
  if (std::has_single_bit(wants))
    return step_alone(terms, static_cast<std::size_t>(std::countr_zero(wants)), narrow, hold);
  const Four part{parts[0], parts[1], parts[2], parts[3]};
  so3::BodySteps steps;
  so3::explicit_steps(order, terms.rates, hold.torques, hold.y, part * terms.hold_s, steps, narrow);
  unsigned goes_on = 0;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    TurnPace& pace = hold.pace[lane];
    const double error_rad = steps.error_rad[lane];
    if ((wants >> lane & 1U) == 0 || !pace.accepts(error_rad, terms.tolerance_rad[lane])) continue;
    pace.advance(error_rad, steps.coarser_rad[lane], terms.tolerance_rad[lane]);
    goes_on |= 1U << lane;
  }
  constexpr LaneMask kBits{1, 2, 4, 8};
  const LaneMask advances = (kBits & (LaneMask{} + static_cast<long long>(goes_on))) != 0;
  for (std::size_t i = 0; i < hold.y.size(); ++i) hold.y[i] = advances ? steps.end[i] : hold.y[i];
  hold.error_rad += only(advances, steps.error_rad);
}

/// Takes from bodies that were watched what they have more than they may.
[[gnu::always_inline]] inline void limit_energies(const BatchTerms& terms,
                                                  SpinHold& hold) noexcept {
  const LaneMask suspect = terms.watched & so3::may_gain_energy(terms.rates, hold.start, hold.y);
  if (!in_some_lane(suspect)) return;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    if (suspect[lane] == 0) continue;
    const so3::SpinRate& rate = terms.rate[lane];
    so3::SpinVector y = lane_of(hold.y, lane);
    hold.error_rad[lane] += rate.limit_energy(rate.energy(lane_of(hold.start, lane)) + y[7], y);
    set_lane(hold.y, lane, y);
  }
}

/// Nearly every hold: explicit steps, together while bodies want the same order. False: one of them
/// needs more; nothing has changed.
[[gnu::always_inline]] inline bool spin(const BatchTerms& terms, const std::array<Four, 3>& torque,
                                        bool narrow, BatchBlock& block) noexcept {
  SpinHold hold;
  begin_of(terms, block, torque, hold);
  if (!set_paces(terms, block, hold)) return false;
  for (const TurnPace& pace : hold.pace)
    while (pace.turning()) step_together(terms, order_of(pace.level), narrow, hold);
  if (terms.some_watched) limit_energies(terms, hold);
  return end_of(terms, hold, block);
}
bool narrow_spin(const BatchTerms& terms, const std::array<Four, 3>& torque,
                 BatchBlock& block) noexcept {
  return spin(terms, torque, true, block);
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] bool wide_spin(const BatchTerms& terms, const std::array<Four, 3>& torque,
                                       BatchBlock& block) noexcept {
  return spin(terms, torque, false, block);
}
#else
constexpr auto* wide_spin = &narrow_spin;
#endif

/// Any hold: bodies take their steps together while they want the same order.
void spin_step_by_step(const BatchTerms& terms, const std::array<Four, 3>& torque,
                       BatchBlock& block, bool narrow) noexcept {
  const auto of = [&](const auto& vector, std::size_t lane) {
    return Vec3(vector[0][lane], vector[1][lane], vector[2][lane]);
  };
  std::array<std::optional<FreeTurn>, kLaneCount> bodies;
  so3::BodyTorques torques;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    const FreeTurn& body = bodies[lane].emplace(
        terms.rate[lane], terms.turn_terms[lane], of(torque, lane),
        Quat(block.q[0][lane], block.q[1][lane], block.q[2][lane], block.q[3][lane]),
        of(block.w, lane), block.level[lane]);
    const so3::Torques& held = body.rate().torques();
    for (std::size_t i = 0; i < 3; ++i) {
      torques.world[i][lane] = held.world[static_cast<Eigen::Index>(i)];
      torques.body[i][lane] = held.body[static_cast<Eigen::Index>(i)];
    }
    torques.has_world[lane] = held.world.isZero(0.0) ? 0 : -1;
    torques.watched[lane] = body.rate().watched() ? -1 : 0;
  }
  const auto absorb = [](FreeTurn& body, const so3::SpinStep& step) {
    if (body.accepts(step)) body.advance(step);
  };
  for (std::size_t first = 0; first < kLaneCount;) {
    FreeTurn& one = *bodies[first];
    if (!one.turning()) {
      ++first;
      continue;
    }
    if (one.stiff()) {
      absorb(one, so3::stiff_step(one.rate(), one.y(), one.step_s()));
      continue;
    }
    // Those that want what this one wants.
    const so3::Order order = order_of(one.level());
    so3::BodySpins y;
    Four h_s;
    std::array<bool, kLaneCount> together{};
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const FreeTurn& body = *bodies[lane];
      together[lane] = body.turning() && !body.stiff() && order_of(body.level()) == order;
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i][lane] = body.y()[static_cast<Eigen::Index>(i)];
      h_s[lane] = body.step_s();
    }
    if (std::count(together.begin(), together.end(), true) == 1) {
      absorb(one, narrow ? so3::explicit_step_narrow(order, one.rate(), one.y(), one.step_s())
                         : so3::explicit_step(order, one.rate(), one.y(), one.step_s(), nullptr));
      continue;
    }
    so3::BodySteps steps;
    so3::explicit_steps(order, terms.rates, torques, y, h_s, steps, narrow);
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      if (!together[lane]) continue;
      so3::SpinStep step;
      for (std::size_t i = 0; i < y.size(); ++i)
        step.end[static_cast<Eigen::Index>(i)] = steps.end[i][lane];
      step.error_rad = steps.error_rad[lane];
      step.coarser_rad = steps.coarser_rad[lane];
      absorb(*bodies[lane], step);
    }
  }
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    block.level[lane] = bodies[lane]->level();
    Quat q_WO;
    Vec3 w_WO_W;
    const auto [error_rad, exceeded] =
        bodies[lane]->finish(terms.turn_terms[lane].branch, q_WO, w_WO_W);
    block.error_rad[lane] = error_rad;
    block.exceeded[lane] = exceeded;
    block.q[0][lane] = q_WO.w();
    for (std::size_t i = 0; i < 3; ++i) {
      block.q[i + 1][lane] = q_WO.vec()[static_cast<Eigen::Index>(i)];
      block.w[i][lane] = w_WO_W[static_cast<Eigen::Index>(i)];
    }
  }
}

}  // namespace

void spin_block(const BatchTerms& terms, const std::array<Four, 3>& torque, BatchBlock& block,
                bool narrow) noexcept {
  if (terms.some_pushed || !(narrow ? narrow_spin : wide_spin)(terms, torque, block))
    spin_step_by_step(terms, torque, block, narrow);
}

}  // namespace isograsp
