// SPDX-License-Identifier: GPL-3.0-or-later
// One hold of four objects, an object a lane: plan_lanes.cpp with the lanes the other way round,
// each sum in the same order. What leaves the usual way goes it alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "grasp_model/batch/batch_block.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp {

namespace {

using BatchRows = BatchTerms::Rows;

/// What is done for 0, 1, … count - 1, in straight code.
template <std::size_t count, class Do>
[[gnu::always_inline]] inline void unrolled(const Do& act) noexcept {
  [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
    (act(i), ...);
  }
  (std::make_index_sequence<count>{});
}

/// Forces of one finger on four objects, contact axes [N].
struct FourForces {
  Four x, y, z;
};
[[gnu::always_inline]] inline FourForces forces_of(const BatchRows& rows, std::size_t f) noexcept {
  static_assert(offsetof(Wrench, torque) == 3 * sizeof(double));  // t_x stands behind f_z
  using Unaligned = double __attribute__((vector_size(32), aligned(8), may_alias));
  const auto load = [&](std::size_t row) __attribute__((always_inline))->Four {
    return *reinterpret_cast<const Unaligned*>((*rows[row])[f].force.data());
  };
  const Four a = load(0), b = load(1), c = load(2), d = load(3);
  const Four xz_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Four xz_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Four y_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Four y_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(xz_ab, xz_cd, 0, 1, 4, 5),
          __builtin_shufflevector(y_ab, y_cd, 0, 1, 4, 5),
          __builtin_shufflevector(xz_ab, xz_cd, 2, 3, 6, 7)};
}

using FingersOfFour = std::array<FourForces, kFingerCount>;

/// What the fingers press with behind hysteresis, grasp rule and friction. False: some object needs
/// Plan's own way; then nothing has changed.
[[gnu::always_inline]] inline bool grip(const BatchTerms& terms, BatchBlock& block,
                                        FingersOfFour& forces) noexcept {
  constexpr double kLeast = PlanLanes::kLeast;
  constexpr double kMost = PlanLanes::kMost;
  std::array<Four, kFingerCount> holds, holds_squared, tangential_squared;
  LaneMask plain = kEveryLane;  // all press, none slides
  unrolled<kFingerCount>([&](std::size_t f) __attribute__((always_inline)) {
    const auto& [x, y, z] = forces[f];
    holds[f] = terms.friction[f] * z;
    holds_squared[f] = holds[f] * holds[f];
    tangential_squared[f] = x * x + y * y;
    plain &= (z > terms.presses_above[f]) & (tangential_squared[f] <= holds_squared[f]) &
             (holds_squared[f] < kMost);
  });
  if (in_every_lane(plain)) {
    unrolled<kFingerCount>([&](std::size_t f)
                               __attribute__((always_inline)) { block.contact[f] = kEveryLane; });
    return true;
  }
  LaneMask usual = kEveryLane;
  std::array<LaneMask, kFingerCount> on;
  unrolled<kFingerCount>([&](std::size_t f) __attribute__((always_inline)) {
    const LaneMask stays = forces[f].z > terms.stays_above[f];
    usual &= (holds_squared[f] + tangential_squared[f] < kMost) &
             ~(stays & (holds_squared[f] <= kLeast));
    on[f] = (forces[f].z > terms.touches_above[f]) | (block.contact[f] & stays);
  });
  if (!in_every_lane(usual)) return false;
  LaneMask acts = kEveryLane;
  if (!in_every_lane(on[0] & on[1] & on[2]))
    for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
      const auto set =
          static_cast<unsigned>((on[0][lane] & 1) | (on[1][lane] & 2) | (on[2][lane] & 4));
      acts[lane] = terms.acts[lane][set] ? -1 : 0;
    }
  unrolled<kFingerCount>([&](std::size_t f) __attribute__((always_inline)) {
    const LaneMask passes = acts & on[f];
    auto& [x, y, z] = forces[f];
    if (!in_every_lane(tangential_squared[f] <= holds_squared[f])) {
      Four kept = holds[f] / roots(tangential_squared[f]);
      kept = kept < 1.0 ? kept : Four{1.0, 1.0, 1.0, 1.0};
      x = kept * x;
      y = kept * y;
    }
    x = only(passes, x);
    y = only(passes, y);
    z = only(passes, z);
    block.contact[f] = on[f];
  });
  return true;
}

/// Sum over the fingers of a row of the grasp map, thumb first.
[[gnu::always_inline]] inline Four sum_of_row(const BatchTerms& terms, std::size_t r,
                                              const FingersOfFour& forces) noexcept {
  const auto of = [&](std::size_t f) __attribute__((always_inline)) {
    const auto& c = terms.columns[r][f];
    return (c[0] * forces[f].x + c[1] * forces[f].y) + c[2] * forces[f].z;
  };
  return (of(0) + of(1)) + of(2);
}

/// One hold of axis `a` under this force. `translates`: about an anchor, with the weight.
template <bool translates>
[[gnu::always_inline]] inline void advance_axis(const BatchTerms& terms, std::size_t a, Four force,
                                                Four& x, Four& v) noexcept {
  Four at = x;
  if constexpr (translates) {
    force += terms.weight[a];
    at -= terms.anchor[a];
  }
  Four base = at;
  if (terms.some_about_rest) {
    force *= terms.force_share[a];
    base = terms.about_rest[a] ? force : at;
  }
  const Four off = force - terms.position_share[a] * at;
  const Four to = base + (terms.x_of_v[a] * v + terms.x_of_off[a] * off);
  v = terms.v_of_v[a] * v + terms.v_of_off[a] * off;
  x = translates ? terms.anchor[a] + to : to;
}

[[gnu::always_inline]] inline void set_attitudes(const BatchTerms& terms,
                                                 BatchBlock& block) noexcept {
  const Four& angle = block.angle;
  const Four u = angle * angle;
  const Four u2 = u * u;
  const auto half_turn = [&](const auto& c) __attribute__((always_inline)) {
    const Four low = (c[0] + u * c[1]) + u2 * (c[2] + u * c[3]);
    const Four high = (c[4] + u * c[5]) + u2 * c[6];
    return low + (u2 * u2) * high;
  };
  Four& real = block.q[0];
  Four& imaginary = block.q[terms.turn_axis + 1];
  real = half_turn(so3::kHalfTurn[0]) * terms.branch;
  imaginary = half_turn(so3::kHalfTurn[1]) * (terms.branch * angle);
  const LaneMask near = (angle <= so3::kNear_rad) & (angle >= -so3::kNear_rad);
  if (in_every_lane(near)) return;
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    if (near[lane] != 0) continue;
    const auto [cosine, sine] = so3::cos_sin(0.5 * angle[lane]);
    real[lane] = terms.branch[lane] * cosine;
    imaginary[lane] = terms.branch[lane] * sine;
  }
}

template <std::size_t translations, Plan::Rotations rotations>
[[gnu::always_inline]] inline bool press_and_move(const BatchTerms& terms, const BatchRows& rows,
                                                  BatchBlock& block,
                                                  std::array<Four, 3>& torque) noexcept {
  FingersOfFour forces{forces_of(rows, 0), forces_of(rows, 1), forces_of(rows, 2)};
  if (!grip(terms, block, forces)) return false;
  if constexpr (rotations == Plan::Rotations::three)
    unrolled<3>([&](std::size_t i) __attribute__((always_inline)) {
      torque[i] = sum_of_row(terms, translations + i, forces);
    });
  unrolled<translations>([&](std::size_t a) __attribute__((always_inline)) {
    const std::size_t axis = terms.axes[a];
    advance_axis<true>(terms, a, sum_of_row(terms, a, forces), block.p[axis], block.v[axis]);
  });
  if constexpr (rotations == Plan::Rotations::one_axis) {
    advance_axis<false>(terms, translations, sum_of_row(terms, translations, forces), block.angle,
                        block.w[terms.turn_axis]);
    set_attitudes(terms, block);
  }
  return true;
}

template <std::size_t translations, Plan::Rotations rotations>
bool narrow_press(const BatchTerms& terms, const BatchRows& rows, BatchBlock& block,
                  std::array<Four, 3>& torque) noexcept {
  return press_and_move<translations, rotations>(terms, rows, block, torque);
}
#if defined(__x86_64__)
template <std::size_t translations, Plan::Rotations rotations>
[[gnu::target("avx2")]] bool wide_press(const BatchTerms& terms, const BatchRows& rows,
                                        BatchBlock& block, std::array<Four, 3>& torque) noexcept {
  return press_and_move<translations, rotations>(terms, rows, block, torque);
}
#endif

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

/// What four bodies begin a hold with.
struct SpinStart {
  so3::BodySpins y;
  so3::BodyTorques torques;
};
/// False: a body is too fast for one step of this order.
[[gnu::always_inline]] inline bool begin_of(const BatchTerms& terms, const BatchBlock& block,
                                            const std::array<Four, 3>& torque, so3::Order order,
                                            SpinStart& start) noexcept {
  std::array<Four, 4> q;
  unrolled<4>([&](std::size_t i)
                  __attribute__((always_inline)) { q[i] = terms.branch * block.q[i]; });
  const auto w = turned_by(block.q, block.w, -1.0);
  start.y = {q[0], q[1], q[2], q[3], w[0], w[1], w[2], Four{}};
  unrolled<3>([&](std::size_t i) __attribute__((always_inline)) {
    start.torques.world[i] = only(terms.world, torque[i]);
    start.torques.body[i] = only(~terms.world, torque[i]);
  });
  start.torques.has_world =
      terms.world & ((torque[0] != 0.0) | (torque[1] != 0.0) | (torque[2] != 0.0));
  start.torques.watched = terms.watched;
  // FreeTurn asks the same of SpinRate::fastest(), which may be rounded otherwise.
  constexpr double kRounding = 1.0 + 1e-12;
  const Four turn_rad =
      terms.hold_s * (length_of(w) + length_of(torque) / terms.resisting + terms.own_rate);
  return in_every_lane(kRounding * turn_rad <= so3::stable_rad(order));
}
/// The hold was one step. False: of some body it is not good enough, or at the end of what is
/// exact; nothing has changed.
[[gnu::always_inline]] inline bool end_of(const BatchTerms& terms, const so3::BodySteps& steps,
                                          BatchBlock& block) noexcept {
  const auto& y = steps.end;
  constexpr double kFar = 1e100;  // nothing overflows
  LaneMask good = steps.error_rad <= terms.tolerance_rad;
  unrolled<7>([&](std::size_t i)
                  __attribute__((always_inline)) { good &= (y[i] < kFar) & (y[i] > -kFar); });
  if (terms.rates.spring) good &= y[0] > 0.9 * FreeTurn::kCosineOfReach;
  if (!in_every_lane(good)) return false;
  const Four length = roots((y[0] * y[0] + y[2] * y[2]) + (y[1] * y[1] + y[3] * y[3]));
  unrolled<4>([&](std::size_t i)
                  __attribute__((always_inline)) { block.q[i] = terms.branch * (y[i] / length); });
  block.w = turned_by(block.q, {y[4], y[5], y[6]}, 1.0);
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    block.error_rad[lane] = steps.error_rad[lane];
    block.exceeded[lane] = false;
  }
  return true;
}

bool narrow_begin(const BatchTerms& terms, const BatchBlock& block,
                  const std::array<Four, 3>& torque, so3::Order order, SpinStart& start) noexcept {
  return begin_of(terms, block, torque, order, start);
}
bool narrow_end(const BatchTerms& terms, const so3::BodySteps& steps, BatchBlock& block) noexcept {
  return end_of(terms, steps, block);
}
#if defined(__x86_64__)
[[gnu::target("avx2")]] bool wide_begin(const BatchTerms& terms, const BatchBlock& block,
                                        const std::array<Four, 3>& torque, so3::Order order,
                                        SpinStart& start) noexcept {
  return begin_of(terms, block, torque, order, start);
}
[[gnu::target("avx2")]] bool wide_end(const BatchTerms& terms, const so3::BodySteps& steps,
                                      BatchBlock& block) noexcept {
  return end_of(terms, steps, block);
}
#else
constexpr auto* wide_begin = &narrow_begin;
constexpr auto* wide_end = &narrow_end;
#endif

/// Nearly every hold: one step of one order for all, and good enough. False: one of them needs
/// more; nothing has changed.
bool spin_at_once(const BatchTerms& terms, const std::array<Four, 3>& torque, BatchBlock& block,
                  bool narrow) noexcept {
  const int level = block.level[0];
  if (terms.some_watched || level > 0) return false;
  for (const int other : block.level)
    if (other != level) return false;
  const so3::Order order = order_of(level);
  SpinStart start;
  if (!(narrow ? narrow_begin : wide_begin)(terms, block, torque, order, start)) return false;
  so3::BodySteps steps;
  so3::explicit_steps(order, terms.rates, start.torques, start.y, terms.hold_s, steps, narrow);
  return (narrow ? narrow_end : wide_end)(terms, steps, block);
}

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

void step_each(const BatchTerms& terms, const BatchRows& rows, BatchBlock& block,
               bool narrow) noexcept {
  for (std::size_t lane = 0; lane < kLaneCount; ++lane) {
    ObjectState state = block.get(lane);
    if (narrow)
      terms.plans[lane]->step_narrow(*rows[lane], state);
    else
      terms.plans[lane]->step(*rows[lane], state);
    block.set(lane, state);
  }
}

}  // namespace

void step_block(const BatchTerms& terms, const BatchRows& rows, BatchBlock& block,
                bool narrow) noexcept {
  narrow = narrow || terms.press == terms.narrow;  // this processor has no wide registers
  std::array<Four, 3> torque;
  if (!terms.side_by_side || !(narrow ? terms.narrow : terms.press)(terms, rows, block, torque))
    return step_each(terms, rows, block, narrow);
  if (terms.spins && !spin_at_once(terms, torque, block, narrow))
    spin_step_by_step(terms, torque, block, narrow);
}

void BatchTerms::choose_press(std::size_t translations, Plan::Rotations rotations) noexcept {
  const auto choose =
      [&]<Plan::Rotations turning>(std::integral_constant<Plan::Rotations, turning>) {
        const auto of = [&]<std::size_t count>(std::integral_constant<std::size_t, count>) {
          if (translations != count) return;
          press = narrow = &narrow_press<count, turning>;
#if defined(__x86_64__)
          if (__builtin_cpu_supports("avx2") != 0) press = &wide_press<count, turning>;
#endif
        };
        of(std::integral_constant<std::size_t, 0>{});
        of(std::integral_constant<std::size_t, 1>{});
        of(std::integral_constant<std::size_t, 2>{});
        of(std::integral_constant<std::size_t, 3>{});
      };
  using R = Plan::Rotations;
  switch (rotations) {
    case R::none: choose(std::integral_constant<R, R::none>{}); break;
    case R::one_axis: choose(std::integral_constant<R, R::one_axis>{}); break;
    case R::three: choose(std::integral_constant<R, R::three>{}); break;
  }
}

}  // namespace isograsp
