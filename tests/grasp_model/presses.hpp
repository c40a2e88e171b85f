// SPDX-License-Identifier: GPL-3.0-or-later
// Finger forces for the tests of steps, the same on every machine.
#pragma once

#include <array>
#include <limits>
#include <random>

#include "core/spatial.hpp"
#include "hand/finger.hpp"

namespace isograsp::test {

/// Forces as people press: on and off, within the cone and beyond, with torques.
class Presses {
 public:
  explicit Presses(std::uint64_t seed = 11) : random_(seed) {}
  FingerWrenches next() {
    FingerWrenches forces;
    for (auto& wrench : forces) {
      wrench.force = Vec3(uniform(), uniform(), 2.0 * uniform() + 1.0);
      wrench.torque = 0.01 * Vec3(uniform(), uniform(), uniform());
    }
    return forces;
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53 * 2.0 - 1.0; }
  std::mt19937_64 random_;
};

/// Grasps that hold, slide, graze the thresholds and let go, and now and then numbers that no
/// sensor sends.
class HardPresses {
 public:
  explicit HardPresses(std::uint64_t seed = 12) : random_(seed) {}
  FingerWrenches next() {
    FingerWrenches forces;
    const double press_N = 2.0 * unit();
    for (auto& wrench : forces) {
      const double fz_N = unit() < 0.2 ? 0.6 * unit() - 0.1 : press_N;
      const double tangential_N = unit() < 0.2 ? 1.5 * fz_N : 0.5 * fz_N;
      wrench.force = Vec3(tangential_N * unit(), tangential_N * unit(), fz_N);
      if (unit() < 0.01)
        wrench.force[static_cast<Eigen::Index>(3.0 * unit())] =
            kOdd[static_cast<std::size_t>(unit() * static_cast<double>(kOdd.size()))];
    }
    return forces;
  }

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  static constexpr double kInf = std::numeric_limits<double>::infinity();
  static constexpr std::array kOdd{0.0,  -0.0,   5e-324, 1e-170, -1e-140, 1e-139,
                                   1e60, -1e139, 1e145,  kNaN,   kInf,    -kInf};
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  std::mt19937_64 random_;
};

}  // namespace isograsp::test
