// SPDX-License-Identifier: GPL-3.0-or-later
// One drink from a glass, as markers show it, without noise.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/measures/drinking.hpp"

namespace isograsp::test {

/// Share of a minimum-jerk movement from `from_s` that takes one second.
inline double gone(double t_s, double from_s) {
  const double s = std::clamp(t_s - from_s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

inline const Vec3 kEdge(0.0, 0.0, 0.0);  // of the table: where the hand lies
inline const Vec3 kGlassPlace(0.0, 0.3, 0.0);
inline const Vec3 kDrinkingPlace(0.0, 0.15, 0.32);
inline const Vec3 kMouth(0.0, 0.11, 0.35);  // 50 mm from there

/// Reach from 0.5 s, carry from 1.8 s, drink until 4 s, put back, return from 5.3 s: one second
/// each. At 100 Hz until 7 s.
inline DrinkingMarkers healthy_drinking() {
  DrinkingMarkers markers;
  for (int k = 0; k <= 700; ++k) {
    const double t_s = k * 0.01;
    const double reach = gone(t_s, 0.5) - gone(t_s, 5.3);
    const double carried = gone(t_s, 1.8) - gone(t_s, 4.0);
    markers.t_s.push_back(t_s);
    const Vec3 glass = kGlassPlace + carried * (kDrinkingPlace - kGlassPlace);
    markers.glass.push_back(glass);
    markers.hand.push_back(kEdge + reach * (kGlassPlace - kEdge) + (glass - kGlassPlace));
    markers.face.push_back(kMouth);
    markers.trunk.push_back(Vec3(0.0, -0.2 + 0.04 * reach, 0.2));
    const double elbow = (90.0 + 60.0 * reach) * std::numbers::pi / 180.0;
    markers.shoulder.push_back(Vec3(-0.2, -0.2, 0.2));
    markers.elbow.push_back(Vec3(-0.2, -0.2, -0.1));
    markers.wrist.push_back(markers.elbow.back() +
                            0.25 * Vec3(0.0, std::sin(elbow), std::cos(elbow)));
  }
  return markers;
}

}  // namespace isograsp::test
