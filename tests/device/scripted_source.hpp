// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers that press by a formula and remember when they were asked.
#pragma once

#include <cmath>

#include "hand/stimulus.hpp"

namespace isograsp::test {

class ScriptedSource final : public FingerSource {
 public:
  void see(const Stimulus&) noexcept override {}
  FingerWrenches press(double t_s) noexcept override {
    ++presses;
    if (t_s < latest_s) went_back = true;
    latest_s = t_s;
    FingerWrenches wrench_C;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const double fz_N = scale * (3.0 + static_cast<double>(f) + std::sin(3.0 * t_s));
      wrench_C[f].force = {0.1 * fz_N, -0.2 * fz_N, fz_N};
      wrench_C[f].torque = {0.0, 0.01 * fz_N, 0.001};
    }
    return wrench_C;
  }

  double scale = 1.0;
  int presses = 0;
  double latest_s = -1.0;
  bool went_back = false;
};

}  // namespace isograsp::test
