// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of most scenes: three fingers, every free axis moves independently, no travel ends, no
// torsion. From finger forces to pose in one straight line where all fingers press and none slides,
// in another where not, so that the processor guesses right and overlaps frames; three free
// rotations get their torque here and turn in plan_turn.cpp. Gives the same bits as step_any, which
// serves all other scenes and whatever over- or underflows here.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "grasp_model/lanes.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp {

namespace {

using Pair = double __attribute__((vector_size(16)));
using PairMask = long long __attribute__((vector_size(16)));
using Mask = LaneMask;

constexpr double kLeast = PlanLanes::kLeast;
constexpr double kMost = PlanLanes::kMost;

/// A set of fingers is the bits of the first three lanes.
constexpr unsigned kAll = 7;
/// ObjectState::contact of a set.
constexpr std::array<std::array<bool, kFingerCount>, 8> kContact{{{false, false, false},
                                                                  {true, false, false},
                                                                  {false, false, true},
                                                                  {true, false, true},
                                                                  {false, true, false},
                                                                  {true, true, false},
                                                                  {false, true, true},
                                                                  {true, true, true}}};
[[gnu::always_inline]] inline unsigned set_of(
    const std::array<bool, kFingerCount>& contact) noexcept {
  return unsigned{contact[0]} + 2 * unsigned{contact[2]} + 4 * unsigned{contact[1]};
}
[[gnu::always_inline]] inline unsigned set_of(const Mask& mask) noexcept {
#if defined(__SSE2__)
  const auto low = reinterpret_cast<__m128d>(__builtin_shufflevector(mask, mask, 0, 1));
  const auto high = reinterpret_cast<__m128d>(__builtin_shufflevector(mask, mask, 2, 3));
  return static_cast<unsigned>(_mm_movemask_pd(low) + 4 * (_mm_movemask_pd(high) & 1));
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4));
#endif
}

/// Two components that stand next to each other, and pairs side by side.
[[gnu::always_inline]] inline Pair pair_at(const double* first) noexcept {
  using Unaligned = double __attribute__((vector_size(16), aligned(8), may_alias));
  return *reinterpret_cast<const Unaligned*>(first);
}
[[gnu::always_inline]] inline Four beside(const Pair& low, const Pair& high) noexcept {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}

/// Sums over the fingers, thumb first, of one row and of two rows side by side.
[[gnu::always_inline]] inline Pair outer(const Four& row) noexcept {
  return __builtin_shufflevector(row, row, 0, 1) + __builtin_shufflevector(row, row, 2, 3);
}
[[gnu::always_inline]] inline double sum_of_fingers(const Four& row) noexcept {
  return (row[0] + row[2]) + row[1];
}
[[gnu::always_inline]] inline Pair sum_of_fingers(const Four& a, const Four& b) noexcept {
  const Pair thumb_and_index = __builtin_shufflevector(outer(a), outer(b), 0, 2);
  const Pair middle = __builtin_shufflevector(a, b, 1, 5);
  return thumb_and_index + middle;
}

}  // namespace

struct LaneKernels {
  using Rotations = Plan::Rotations;

  /// `along`: bit i = translation i is free.
  template <unsigned along, Rotations turning>
  [[gnu::always_inline]] static inline void step_of(const Plan& plan,
                                                    const FingerWrenches& wrench_C,
                                                    ObjectState& state) noexcept {
    const PlanLanes& lanes = plan.lanes_;
    static_assert(offsetof(Wrench, torque) == 3 * sizeof(double));  // t_x stands behind f_z
    const double* const thumb = wrench_C[0].force.data();
    const double* const index = wrench_C[1].force.data();
    const double* const middle = wrench_C[2].force.data();
    const Four xy = beside(pair_at(thumb), pair_at(index));
    const Four z = beside(pair_at(thumb + 2), pair_at(index + 2));
    const Four xy_mm = beside(pair_at(middle), pair_at(middle));
    const Four z_mm = beside(pair_at(middle + 2), pair_at(middle + 2));
    Four fx = __builtin_shufflevector(xy, xy_mm, 0, 4, 2, 6);
    Four fy = __builtin_shufflevector(xy, xy_mm, 1, 5, 3, 7);
    Four fz = __builtin_shufflevector(z, z_mm, 0, 4, 2, 6);

    const Four holds = lanes.friction * fz;
    const Four holds_squared = holds * holds;
    const Four tangential_squared = fx * fx + fy * fy;
    // What nearly every frame of a grasp is comes first: all press and none slides. The processor
    // learns that, and waits for no comparison.
    const Mask plain = (fz > lanes.presses_above) & (tangential_squared <= holds_squared) &
                       (holds_squared < kMost);
    if (in_every_lane(plain)) {
      state.contact = {true, true, true};
    } else {
      const Mask stays = fz > lanes.stays_above;
      const Mask usual =
          (holds_squared + tangential_squared < kMost) & ~(stays & (holds_squared <= kLeast));
      if (!in_every_lane(usual)) return plan.step_any(wrench_C, state);
      const unsigned set =
          set_of(fz > lanes.touches_above) | (set_of(state.contact) & set_of(stays));
      state.contact = kContact[set];
      Four kept;
      for (int f = 0; f < 4; ++f) kept[f] = std::sqrt(tangential_squared[f]);
      kept = holds / kept;
      kept = kept < 1.0 ? kept : Four{1.0, 1.0, 1.0, 1.0};
      const Mask& passes = lanes.passes[set];
      fx = only(passes, kept * fx);
      fy = only(passes, kept * fy);
      fz = only(passes, fz);
    }
    const auto row = [&](std::size_t r) __attribute__((always_inline)) {
      const auto& c = lanes.columns[r];
      return (c[0] * fx + c[1] * fy) + c[2] * fz;
    };

    constexpr bool kTurns = turning == Rotations::one_axis;
    if constexpr (turning == Rotations::three) {
      // The torque first: what it takes is read before the translations are written.
      constexpr std::size_t kFirst = std::popcount(along);
      const Pair about_xy = sum_of_fingers(row(kFirst), row(kFirst + 1));
      const Vec3 torque(about_xy[0], about_xy[1], sum_of_fingers(row(kFirst + 2)));
      move_lanes<along, kTurns>(plan, row, state);
      plan.turn_freely(plan.hold_s_, {Vec3::Zero(), torque}, state);
    } else {
      move_lanes<along, kTurns>(plan, row, state);
      if constexpr (kTurns) plan.set_attitude(state.angle_rad, state);
    }
  }

  /// One hold of every lane; `row` gives the products of a row of the grasp map by finger.
  template <unsigned along, bool turns, class Row>
  [[gnu::always_inline]] static inline void move_lanes(const Plan& plan, const Row& row,
                                                       ObjectState& state) noexcept {
    constexpr int kLanes = std::popcount(along) + (turns ? 1 : 0);
    if constexpr (kLanes >= 2) advance<along, 0>(plan, sum_of_fingers(row(0), row(1)), state);
    if constexpr (kLanes == 4) advance<along, 2>(plan, sum_of_fingers(row(2), row(3)), state);
    if constexpr (kLanes % 2 == 1)
      advance<along, kLanes - 1>(plan, sum_of_fingers(row(kLanes - 1)), state);
  }

  /// One hold of lane `first`, or of the pair that begins there, under these forces. A pair and a
  /// rest wait for their own last step alone.
  template <unsigned along, int first, class Numbers>
  [[gnu::always_inline]] static inline void advance(const Plan& plan, const Numbers& sum,
                                                    ObjectState& state) noexcept {
    constexpr bool kPair = sizeof(Numbers) > sizeof(double);
    constexpr bool kTranslates = first < std::popcount(along);
    const auto part = [](const auto& all) __attribute__((always_inline)) {
      if constexpr (kPair)
        return __builtin_shufflevector(all, all, first, first + 1);
      else
        return all[first];
    };
    const auto of = [&](auto get) __attribute__((always_inline)) {
      if constexpr (kPair)
        return Numbers{get(first), get(first + 1)};
      else
        return get(first);
    };
    const auto x = [&](int lane) __attribute__((always_inline))->double& {
      return lane < std::popcount(along) ? state.X_WO.p[axis_of(along, lane)] : state.angle_rad;
    };
    const auto v = [&](int lane) __attribute__((always_inline))->double& {
      return lane < std::popcount(along) ? state.v_WO_W[axis_of(along, lane)]
                                         : state.w_WO_W[plan.axis_];
    };
    const PlanLanes& a = plan.lanes_;
    Numbers force = sum;
    Numbers at = of(x);
    const Numbers speed = of(v);
    if constexpr (kTranslates) {
      force += part(a.weight);
      at -= part(a.anchor);
    }
    Numbers base = at;
    if (a.some_about_rest) [[unlikely]] {
      force *= part(a.force_share);
      if constexpr (kPair) {
        const PairMask rest = part(a.about_rest);
        base = reinterpret_cast<Pair>((rest & reinterpret_cast<PairMask>(force)) |
                                      (~rest & reinterpret_cast<PairMask>(at)));
      } else if (part(a.about_rest) != 0) {
        base = force;
      }
    }
    const Numbers off = force - part(a.position_share) * at;
    Numbers to = base + (part(a.x_of_v) * speed + part(a.x_of_off) * off);
    if constexpr (kTranslates) to = part(a.anchor) + to;
    const Numbers speed_to = part(a.v_of_v) * speed + part(a.v_of_off) * off;
    if constexpr (kPair) {
      v(first) = speed_to[0];
      v(first + 1) = speed_to[1];
      x(first) = to[0];
      x(first + 1) = to[1];
    } else {
      v(first) = speed_to;
      x(first) = to;
    }
  }
  static constexpr Eigen::Index axis_of(unsigned along, int lane) noexcept {
    for (; lane > 0; --lane) along &= along - 1;
    return std::countr_zero(along);
  }

  template <unsigned along, Rotations turning>
  static void narrow(const Plan& plan, const FingerWrenches& wrench_C,
                     ObjectState& state) noexcept {
    step_of<along, turning>(plan, wrench_C, state);
  }
#if defined(__x86_64__)
  template <unsigned along, Rotations turning>
  [[gnu::target("avx2")]] static void wide(const Plan& plan, const FingerWrenches& wrench_C,
                                           ObjectState& state) noexcept {
    step_of<along, turning>(plan, wrench_C, state);
  }
#endif

  template <Rotations turning>
  static void choose(unsigned along, PlanLanes& lanes) noexcept {
    [&]<unsigned... i>(std::integer_sequence<unsigned, i...>) {
      using Kernels = std::array<PlanLanes::Step*, 8>;
      static constexpr Kernels kNarrow{&narrow<i, turning>...};
      lanes.step = lanes.narrow = kNarrow[along];
#if defined(__x86_64__)
      static constexpr Kernels kWide{&wide<i, turning>...};
      if (__builtin_cpu_supports("avx2") != 0) lanes.step = kWide[along];
#endif
    }
    (std::make_integer_sequence<unsigned, 8>{});
  }
};

void Plan::compile_lanes() {
  bool limited = false;
  for (const bool limit : limited_) limited = limited || limit;
  if (contacts_ != kFingerCount || limited || torsion_ || coupled_ || force_follows_) return;
  if (!acts_[kAll]) return;
  for (std::size_t lane = 0; lane < PlanLanes::kFingerOfLane.size(); ++lane) {
    const auto l = static_cast<int>(lane);
    const Pressing& contact = pressing_[PlanLanes::kFingerOfLane[lane]];
    lanes_.friction[l] = contact.limit.tangential ? contact.limit.mu : 0.0;
    lanes_.touches_above[l] = contact.rule.least_N(false);
    lanes_.stays_above[l] = contact.rule.least_N(true);
    // Without friction, or with hardly any, no frame is plain, and the clamp that of step_any.
    lanes_.presses_above[l] =
        std::max(contact.rule.least_N(false), 1.1 * std::sqrt(kLeast) / lanes_.friction[l]);
    for (unsigned set = 0; set < kContact.size(); ++set) {
      const auto& on = kContact[set];
      const bool acts = acts_[unsigned{on[0]} + 2 * unsigned{on[1]} + 4 * unsigned{on[2]}];
      lanes_.passes[set][l] = acts && on[contact.finger] ? -1 : 0;
    }
    for (std::size_t r = 0; r < row_count_; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        lanes_.columns[r][c][l] =
            contact.moving(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c));
  }
  unsigned along = 0;
  for (std::size_t i = 0; i < axis_count_; ++i) along |= 1u << axes_[i];
  const std::size_t turns = rotations_ == Rotations::one_axis ? 1 : 0;
  for (std::size_t i = 0; i < axis_count_ + turns; ++i) {
    const auto lane = static_cast<int>(i);
    const bool linear = i < axis_count_;
    const LinearStep& step =
        linear ? steps_.linear[static_cast<std::size_t>(axes_[i])] : steps_.turn;
    lanes_.weight[lane] = linear ? weight_W_[axes_[i]] : 0.0;
    lanes_.anchor[lane] = linear ? anchor_m_[axes_[i]] : 0.0;
    lanes_.force_share[lane] = step.force_share;
    lanes_.position_share[lane] = step.position_share;
    lanes_.x_of_v[lane] = step.x_of_v;
    lanes_.x_of_off[lane] = step.x_of_off;
    lanes_.v_of_v[lane] = step.v_of_v;
    lanes_.v_of_off[lane] = step.v_of_off;
    lanes_.about_rest[lane] = step.about_rest ? -1 : 0;
    lanes_.some_about_rest = lanes_.some_about_rest || step.about_rest;
  }
  switch (rotations_) {
    case Rotations::none: LaneKernels::choose<Rotations::none>(along, lanes_); break;
    case Rotations::one_axis: LaneKernels::choose<Rotations::one_axis>(along, lanes_); break;
    case Rotations::three: LaneKernels::choose<Rotations::three>(along, lanes_); break;
  }
}

}  // namespace isograsp
