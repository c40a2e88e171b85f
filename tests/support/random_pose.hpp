// SPDX-License-Identifier: GPL-3.0-or-later
// Random places and attitudes.
#pragma once

#include <cmath>

#include "core/random.hpp"
#include "core/spatial.hpp"

namespace isograsp::test {

inline Vec3 random_vector(Random& random, double size) {
  const auto one = [&] { return size * (2.0 * random.uniform() - 1.0); };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}

inline Quat random_attitude(Random& random) {
  for (;;) {
    const Vec3 v = random_vector(random, 1.0);
    const double w = 2.0 * random.uniform() - 1.0;
    const double length = std::sqrt(v.squaredNorm() + w * w);
    if (length > 0.1 && length < 1.0)
      return Quat(w / length, v.x() / length, v.y() / length, v.z() / length);
  }
}

inline Pose random_pose(Random& random) {
  const Vec3 p = random_vector(random, 2.0);
  return {p, random_attitude(random)};
}

}  // namespace isograsp::test
