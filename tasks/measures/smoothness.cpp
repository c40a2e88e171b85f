// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/smoothness.hpp"

#include <cassert>
#include <cmath>

#include "kinematics/measures/smoothness.hpp"

namespace isograsp::tasks {

namespace {

statistics::Computed computed(const Valued& valued) {
  if (valued.value) return *valued.value;
  return valued.reason;
}

}  // namespace

statistics::UniformSamples speed_of(std::span<const statistics::UniformSamples> axes) {
  const std::size_t n = axes.front().values.size();
  const double step_s = axes.front().step_s;
  assert(n >= 2);
  statistics::UniformSamples speed{step_s, std::vector<double>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1;
    const std::size_t after = k + 1 == n ? k : k + 1;
    const double span_s = static_cast<double>(after - before) * step_s;
    double squares = 0.0;
    for (const statistics::UniformSamples& axis : axes) {
      const double v = (axis.values[after] - axis.values[before]) / span_s;
      squares += v * v;
    }
    speed.values[k] = std::sqrt(squares);
  }
  return speed;
}

statistics::UniformSamples rate_of(const statistics::UniformSamples& force) {
  return speed_of(std::span(&force, 1));
}

statistics::Computed sparc(const statistics::UniformSamples& speed) {
  return computed(spectral_arc_length(speed.values, speed.step_s));
}

statistics::Computed ldlj(const statistics::UniformSamples& speed) {
  return computed(log_dimensionless_jerk(speed.values, speed.step_s));
}

}  // namespace isograsp::tasks
