// SPDX-License-Identifier: GPL-3.0-or-later
// What fingers do to four objects, an object a lane, and how what moves alone moves: plan_lanes.cpp
// with the lanes the other way round, each sum in the same order.
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "grasp_model/batch/batch_block.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp {

namespace {

using BatchRows = BatchTerms::Rows;

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

}  // namespace

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
