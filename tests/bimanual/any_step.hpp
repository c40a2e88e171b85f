// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of pads for tests: any grasp, and how its points slip.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "bimanual/pads/pad_step.hpp"
#include "core/random.hpp"
#include "tests/support/random_pose.hpp"

namespace isograsp::test::pads {

using namespace bimanual;

inline Vec3 velocity_at(const Vec6& v, const Vec3& arm) {
  return v.head<3>() + Vec3(v.tail<3>()).cross(arm);
}
inline Vec3 slip_at(const PadFace& face, const PadPoint& point, const std::vector<Vec6>& velocity) {
  return velocity_at(velocity[face.pad], point.p_pad) -
         velocity_at(velocity[face.object], point.p_object);
}
inline double largest(const std::vector<Vec6>& velocity) {
  double most = 1e-3;  // slower is standing still
  for (const Vec6& v : velocity) most = std::max(most, v.cwiseAbs().maxCoeff());
  return most;
}

/// One to four pads on something round, square or locked; fast, slow, thin, deep, without friction,
/// with points in a row.
inline PadStep any_step(Random& random, int kind, int most_points) {
  const auto uniform = [&](double a, double b) { return a + (b - a) * random.uniform(); };
  const auto direction = [&] { return Vec3(test::random_attitude(random) * Vec3::UnitX()); };
  PadStep step;
  const bool opposite = kind % 3 == 0, curved = kind % 2 == 1, in_a_row = kind % 4 == 1;
  const double fast = kind % 5 == 0 ? 0.01 : 1.0;
  const std::size_t pads = opposite ? 2 : 1 + static_cast<std::size_t>(4.0 * random.uniform());
  const double mass_kg = std::pow(10.0, uniform(-2.0, 0.5)), radius_m = uniform(0.005, 0.06);
  Mat6 body = Mat6::Identity() * mass_kg;
  for (int k = 3; k < 6; ++k) body(k, k) *= radius_m * radius_m * uniform(0.2, 0.6);
  constexpr double kLocked = 1e18;
  step.inertia.push_back(kind % 11 == 5 ? Mat6(kLocked * body) : body);
  const auto twist = [&](double v, double w) {
    Vec6 velocity;
    velocity << fast * test::random_vector(random, v), fast * test::random_vector(random, w);
    return velocity;
  };
  step.velocity_free.push_back(twist(0.3, 5.0));
  for (std::size_t pad = 1; pad <= pads; ++pad) {
    Mat6& give = step.inertia.emplace_back(Mat6::Identity());
    give.diagonal() << Vec3::Constant(6e-3 * uniform(0.5, 2.0)),
        Vec3::Constant(9e-7 * uniform(0.5, 2.0));
    step.velocity_free.push_back(twist(0.1, 2.0));
    PadFace& face = step.faces.emplace_back();
    face.pad = pad;
    face.friction = kind % 7 == 0 ? 0.0 : uniform(0.0, 1.3);
    face.stiffness_N_m3 = 4e7 * std::pow(10.0, uniform(-1.0, 1.0));
    const Vec3 normal = opposite ? Vec3(pad == 1 ? 1.0 : -1.0, 0.0, 0.0) : direction();
    const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
    const int count = 1 + static_cast<int>(most_points * random.uniform());
    const double tilt = uniform(0.0, 0.02), deep_m = uniform(-1e-5, 2e-4), half_m = 0.006;
    for (int i = 0; i < count; ++i) {
      const double x = uniform(-half_m, half_m), y = in_a_row ? 0.0 : uniform(-half_m, half_m);
      PadPoint point;
      point.p_pad = x * first + y * second;
      point.p_object = point.p_pad - radius_m * normal;
      point.normal = curved ? Vec3(-point.p_object.normalized()) : normal;
      point.area_m2 = 1e-4 / count * uniform(0.5, 2.0);
      point.penetration_free_m =
          deep_m + tilt * x - (curved ? (x * x + y * y) / (2.0 * radius_m) : 0.0);
      face.points.push_back(point);
    }
  }
  return step;
}

}  // namespace isograsp::test::pads
