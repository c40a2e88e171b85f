// SPDX-License-Identifier: GPL-3.0-or-later
// Forces that number themselves: row k of finger f is n = k + 1000 f, fz = n counts of an RFT
// sensor, and every other axis follows from n. Whole counts only, so that values come back exactly.
#pragma once

#include <cmath>

#include "device/emulator/emulator.hpp"

namespace isograsp::test {

inline constexpr double kPlayRate_Hz = 100.0;

/// Contact frame.
[[nodiscard]] inline Wrench counting_wrench(std::size_t row, std::size_t finger) {
  const auto n = static_cast<double>(row + 1000 * finger);
  return {Vec3(std::floor(n / 2.0), -n, n) / 50.0, Vec3(n, -std::floor(n / 2.0), 7.0) / 2000.0};
}

[[nodiscard]] inline FingerPlay counting_play(std::size_t rows) {
  FingerPlay play;
  for (std::size_t k = 0; k < rows; ++k) {
    play.t_s.push_back(static_cast<double>(k) / kPlayRate_Hz);
    FingerWrenches wrenches;
    for (std::size_t f = 0; f < kFingerCount; ++f) wrenches[f] = counting_wrench(k, f);
    play.wrench_C.push_back(wrenches);
  }
  return play;
}

/// The row that a wrench of counting_play() came from.
[[nodiscard]] inline std::size_t row_of(const Wrench& wrench_C, std::size_t finger) {
  return static_cast<std::size_t>(std::lround(wrench_C.force.z() * 50.0)) - 1000 * finger;
}

}  // namespace isograsp::test
