// SPDX-License-Identifier: GPL-3.0-or-later
// A number of each of four bodies, and what is true of each, a body a lane: in one wide register,
// or in two. No sum is fused with a product, so the bits are those of number by number. Inside
// grasp_model/batch/ only.
#pragma once

#include <cmath>
#include <cstddef>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace isograsp::so3 {

inline constexpr std::size_t kBodies = 4;
using Bodies = double __attribute__((vector_size(32)));
/// True: all bits of the lane are set.
using BodyMask = long long __attribute__((vector_size(32)));

inline constexpr BodyMask kEveryBody{-1, -1, -1, -1};

[[nodiscard, gnu::always_inline]] inline bool in_every_body(const BodyMask& mask) noexcept {
  using Pair = long long __attribute__((vector_size(16)));
  const Pair both =
      __builtin_shufflevector(mask, mask, 0, 1) & __builtin_shufflevector(mask, mask, 2, 3);
#if defined(__SSE2__)
  return _mm_movemask_pd(reinterpret_cast<__m128d>(both)) == 3;
#else
  return (both[0] & both[1]) != 0;
#endif
}
[[nodiscard, gnu::always_inline]] inline bool in_some_body(const BodyMask& mask) noexcept {
  return !in_every_body(~mask);
}
/// `values` where it is true, else zero.
[[nodiscard, gnu::always_inline]] inline Bodies only(const BodyMask& where,
                                                     const Bodies& values) noexcept {
  return reinterpret_cast<Bodies>(where & reinterpret_cast<BodyMask>(values));
}
[[nodiscard, gnu::always_inline]] inline Bodies roots(const Bodies& squares) noexcept {
  return Bodies{std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2]),
                std::sqrt(squares[3])};
}

}  // namespace isograsp::so3
