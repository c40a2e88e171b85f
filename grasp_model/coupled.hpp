// SPDX-License-Identifier: GPL-3.0-or-later
// The exact step of translations whose springs or dampers stand at an angle to the world's axes:
// m x" + C x' + K x = F with F constant over the hold, by one matrix exponential. SI units.
#pragma once

#include <array>

#include "core/spatial.hpp"

namespace isograsp {

/// Translations of one body: free axes of the world, symmetric matrices.
struct CoupledAxes {
  double mass_kg = 0.0;           ///< 0: first order, C x' + K x = F
  Mat3 damping = Mat3::Zero();    ///< world axes [N s/m]
  Mat3 stiffness = Mat3::Zero();  ///< world axes [N/m]
  std::array<bool, 3> free{};
  /// The motion of some free axis acts on another one.
  [[nodiscard]] bool coupled() const noexcept;
};

/// As LinearStep, with matrices.
class CoupledStep {
 public:
  CoupledStep() = default;
  /// Not for the real-time path.
  CoupledStep(const CoupledAxes& axes, double hold_s);

  /// x from the springs' rest [m]; locked axes keep their bits if they rest there. Real-time safe.
  void advance(const Vec3& force, Vec3& x, Vec3& v) const noexcept {
    const Vec3 excess = force - stiffness_ * x;
    x += S_ * v + P_ * excess;
    v = Q_ * v + T_ * excess;
  }

 private:
  Mat3 stiffness_ = Mat3::Zero();
  Mat3 S_ = Mat3::Zero();  ///< position after unit start velocity
  Mat3 P_ = Mat3::Zero();  ///< position after unit force
  Mat3 Q_ = Mat3::Zero();  ///< velocity after unit start velocity
  Mat3 T_ = Mat3::Zero();  ///< velocity after unit force
};

}  // namespace isograsp
