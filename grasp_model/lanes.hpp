// SPDX-License-Identifier: GPL-3.0-or-later
// Four numbers side by side, and what is true of each: in one wide register, or in two. No sum is
// fused with a product, so the bits are those of number by number. Inside grasp_model/ only.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace isograsp {

inline constexpr std::size_t kLaneCount = 4;
using Four = double __attribute__((vector_size(32)));
/// True: all bits of the lane are set.
using LaneMask = long long __attribute__((vector_size(32)));

inline constexpr LaneMask kEveryLane{-1, -1, -1, -1};

/// What is done for 0, 1, … count - 1, in straight code.
template <std::size_t count, class Do>
[[gnu::always_inline]] inline void unrolled(const Do& act) noexcept {
  [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
    (act(i), ...);
  }
  (std::make_index_sequence<count>{});
}

[[nodiscard, gnu::always_inline]] inline bool in_every_lane(const LaneMask& mask) noexcept {
  using Pair = long long __attribute__((vector_size(16)));
  const Pair both =
      __builtin_shufflevector(mask, mask, 0, 1) & __builtin_shufflevector(mask, mask, 2, 3);
#if defined(__SSE2__)
  return _mm_movemask_pd(reinterpret_cast<__m128d>(both)) == 3;
#else
  return (both[0] & both[1]) != 0;
#endif
}
[[nodiscard, gnu::always_inline]] inline bool in_some_lane(const LaneMask& mask) noexcept {
  return !in_every_lane(~mask);
}
/// `values` where it is true, else zero.
[[nodiscard, gnu::always_inline]] inline Four only(const LaneMask& where,
                                                   const Four& values) noexcept {
  return reinterpret_cast<Four>(where & reinterpret_cast<LaneMask>(values));
}
[[nodiscard, gnu::always_inline]] inline Four roots(const Four& squares) noexcept {
  return Four{std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]),
              std::sqrt(squares[3])};
}

}  // namespace isograsp
