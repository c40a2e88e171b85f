// SPDX-License-Identifier: GPL-3.0-or-later
// M: spectrum of the speed v divided by its first line; from the first to the last line of at most
// 10 Hz with M >= 0.05 are n steps:
//   SPARC = -sum sqrt(1 / n^2 + (M_(k + 1) - M_k)^2)
//   jerk_k = (v_(k + 1) - 2 v_k + v_(k - 1)) / dt^2
//   LDLJ = -ln(duration^3 / (largest v)^2 * sum jerk^2 dt)
#include "tasks/measures/smoothness.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "core/fourier.hpp"

namespace isograsp::tasks {

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
  constexpr unsigned kPadding = 4;
  constexpr double kHighest_Hz = 10.0;
  constexpr double kLeastAmplitude = 0.05;
  const std::size_t n = speed.values.size();
  if (n < 2) return "fewer than two samples"_text;
  const std::size_t length = std::bit_ceil(n) << kPadding;
  const double line_Hz = 1.0 / (speed.step_s * static_cast<double>(length));
  constexpr double kRoundingSlack = 1e-9;  // a line at 10 Hz belongs to the range
  const double highest_Hz = kHighest_Hz * (1.0 + kRoundingSlack);
  const double lines = std::min(highest_Hz / line_Hz + 1.0, 0.5 * static_cast<double>(length));
  std::vector<double> magnitude =
      low_magnitudes(speed.values, length, static_cast<std::size_t>(lines));
  const double largest = magnitude.front();  // of a signal that is never negative
  if (!(largest > 0.0)) return "nothing moved"_text;
  std::size_t first = magnitude.size();
  std::size_t last = 0;
  for (std::size_t k = 0; k < magnitude.size(); ++k) {
    magnitude[k] /= largest;
    if (static_cast<double>(k) * line_Hz > highest_Hz || magnitude[k] < kLeastAmplitude) continue;
    first = std::min(first, k);
    last = k;
  }
  if (first >= last) return "the spectrum has no range"_text;
  const double scaled_line = 1.0 / static_cast<double>(last - first);
  double length_of_arc = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    const double rise = magnitude[k + 1] - magnitude[k];
    length_of_arc += std::sqrt(scaled_line * scaled_line + rise * rise);
  }
  return -length_of_arc;
}

statistics::Computed ldlj(const statistics::UniformSamples& speed) {
  const auto& v = speed.values;
  if (v.size() < 3) return "fewer than three samples"_text;
  double fastest = 0.0;
  for (const double value : v) fastest = std::max(fastest, std::abs(value));
  if (!(fastest > 0.0)) return "nothing moved"_text;
  const double dt = speed.step_s;
  double squares = 0.0;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) {
    const double jerk = (v[k + 1] - 2.0 * v[k] + v[k - 1]) / (dt * dt);
    squares += jerk * jerk;
  }
  if (!(squares > 0.0)) return "the speed never changes its slope"_text;
  const double duration = static_cast<double>(v.size()) * dt;
  return -std::log(duration * duration * duration / (fastest * fastest) * squares * dt);
}

}  // namespace isograsp::tasks
