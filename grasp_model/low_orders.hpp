// SPDX-License-Identifier: GPL-3.0-or-later
// Explicit Runge-Kutta steps of order 3 and 5, each with an embedded formula one order lower, in
// the form of dormand_prince.hpp.
// P. Bogacki, L. Shampine, A 3(2) pair of Runge-Kutta formulas, Appl. Math. Lett. 2 (1989): its
// first three stages; with these alone every formula of order 2 differs from that of order 3 by a
// multiple of k0 - 3 k1 + 2 k2.
// J. Cash, A. Karp, A variable order Runge-Kutta method, ACM Trans. Math. Softw. 16 (1990).
#pragma once

#include <array>

namespace isograsp::bogacki_shampine {

inline constexpr std::size_t kStages = 3;
inline constexpr std::array<std::size_t, 3> kWeighted{0, 1, 2};
inline constexpr std::array<double, 3> kTime{0.0, 0.5, 0.75};
inline constexpr std::array<double, 3> kWeight{2.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0};

template <class State, class Rate>
[[gnu::always_inline]] inline void stages(const State& y, typename State::Scalar h, const Rate& f,
                                          std::array<State, kStages>& k) {
  k[0] = f(0, y);
  k[1] = f(1, y + h * (0.5 * k[0]));
  k[2] = f(2, y + h * (0.75 * k[1]));
}
template <class State>
[[nodiscard, gnu::always_inline]] inline State increment(const std::array<State, kStages>& k) {
  return 2.0 / 9.0 * k[0] + 1.0 / 3.0 * k[1] + 4.0 / 9.0 * k[2];
}
/// Error of the embedded formula of order 2, per unit of h.
template <class State>
[[nodiscard, gnu::always_inline]] inline State error2(const std::array<State, kStages>& k) {
  return 1.0 / 9.0 * k[0] - 1.0 / 3.0 * k[1] + 2.0 / 9.0 * k[2];
}

}  // namespace isograsp::bogacki_shampine

namespace isograsp::cash_karp {

// clang-format off
inline constexpr std::size_t kStages = 6;
inline constexpr std::array<std::size_t, 4> kWeighted{0, 2, 3, 5};
inline constexpr std::array<double, 4> kTime{0.0, 0.3, 0.6, 0.875};
inline constexpr std::array<double, 4> kWeight{37.0 / 378.0, 250.0 / 621.0, 125.0 / 594.0, 512.0 / 1771.0};

template <class State, class Rate>
[[gnu::always_inline]] inline void stages(const State& y, typename State::Scalar h, const Rate& f, std::array<State, kStages>& k) {
  k[0] = f(0, y);
  k[1] = f(1, y + h * (0.2 * k[0]));
  k[2] = f(2, y + h * (3.0 / 40.0 * k[0] + 9.0 / 40.0 * k[1]));
  k[3] = f(3, y + h * (0.3 * k[0] - 0.9 * k[1] + 1.2 * k[2]));
  k[4] = f(4, y + h * (-11.0 / 54.0 * k[0] + 2.5 * k[1] - 70.0 / 27.0 * k[2] + 35.0 / 27.0 * k[3]));
  k[5] = f(5, y + h * (1631.0 / 55296.0 * k[0] + 175.0 / 512.0 * k[1] + 575.0 / 13824.0 * k[2] + 44275.0 / 110592.0 * k[3] + 253.0 / 4096.0 * k[4]));
}
template <class State>
[[nodiscard, gnu::always_inline]] inline State increment(const std::array<State, kStages>& k) {
  return 37.0 / 378.0 * k[0] + 250.0 / 621.0 * k[2] + 125.0 / 594.0 * k[3] + 512.0 / 1771.0 * k[5];
}
/// Error of the embedded formula of order 4, per unit of h.
template <class State>
[[nodiscard, gnu::always_inline]] inline State error4(const std::array<State, kStages>& k) {
  return (37.0 / 378.0 - 2825.0 / 27648.0) * k[0] + (250.0 / 621.0 - 18575.0 / 48384.0) * k[2] + (125.0 / 594.0 - 13525.0 / 55296.0) * k[3] - 277.0 / 14336.0 * k[4] + (512.0 / 1771.0 - 0.25) * k[5];
}
// clang-format on
/// What order 3 would have erred by, per unit of h: the second difference of the rates, at 0, 0.3,
/// 0.6.
template <class State>
[[nodiscard, gnu::always_inline]] inline State coarser(const std::array<State, kStages>& k) {
  return 1.2 * (k[0] - 2.0 * k[2] + k[3]);
}

}  // namespace isograsp::cash_karp
