// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/smoothness.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace isograsp {

void fourier_transform(std::span<std::complex<double>> x) {
  const std::size_t n = x.size();
  assert(std::has_single_bit(n));
  for (std::size_t i = 1, j = 0; i < n; ++i) {  // bit-reversed order
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j |= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  // One table of exact-as-possible roots: repeated multiplication would lose digits.
  std::vector<std::complex<double>> root(n / 2);
  for (std::size_t k = 0; k < root.size(); ++k) {
    const double angle = -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    root[k] = {std::cos(angle), std::sin(angle)};
  }
  for (std::size_t length = 2; length <= n; length *= 2)
    for (std::size_t block = 0; block < n; block += length)
      for (std::size_t k = 0; k < length / 2; ++k) {
        const std::complex<double> w = root[k * (n / length)];
        const std::complex<double> b = x[block + k + length / 2];
        const std::complex<double> turned(w.real() * b.real() - w.imag() * b.imag(),
                                          w.real() * b.imag() + w.imag() * b.real());
        x[block + k + length / 2] = x[block + k] - turned;
        x[block + k] += turned;
      }
}

UniformSamples speed_of(std::span<const UniformSamples> axes) {
  const std::size_t n = axes.front().values.size();
  const double step_s = axes.front().step_s;
  assert(n >= 2);
  UniformSamples speed{step_s, std::vector<double>(n)};
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1;
    const std::size_t after = k + 1 == n ? k : k + 1;
    const double span_s = static_cast<double>(after - before) * step_s;
    double squares = 0.0;
    for (const UniformSamples& axis : axes) {
      const double v = (axis.values[after] - axis.values[before]) / span_s;
      squares += v * v;
    }
    speed.values[k] = std::sqrt(squares);
  }
  return speed;
}

Computed sparc(const UniformSamples& speed) {
  constexpr unsigned kPadding = 4;
  constexpr double kHighest_Hz = 10.0;
  constexpr double kLeastAmplitude = 0.05;
  const std::size_t n = speed.values.size();
  if (n < 2) return "fewer than two samples";
  const std::size_t length = std::bit_ceil(n) << kPadding;
  std::vector<std::complex<double>> spectrum(length);
  for (std::size_t k = 0; k < n; ++k) spectrum[k] = speed.values[k];
  fourier_transform(spectrum);
  const double line_Hz = 1.0 / (speed.step_s * static_cast<double>(length));
  std::vector<double> magnitude(length / 2 + 1);  // a speed is real: the rest mirrors it
  double largest = 0.0;
  for (std::size_t k = 0; k < magnitude.size(); ++k) {
    magnitude[k] = std::sqrt(std::norm(spectrum[k]));
    largest = std::max(largest, magnitude[k]);
  }
  if (!(largest > 0.0)) return "nothing moved";
  std::size_t first = magnitude.size();
  std::size_t last = 0;
  for (std::size_t k = 0; k < magnitude.size(); ++k) {
    magnitude[k] /= largest;
    if (static_cast<double>(k) * line_Hz > kHighest_Hz || magnitude[k] < kLeastAmplitude) continue;
    first = std::min(first, k);
    last = k;
  }
  if (first >= last) return "the spectrum has no range";
  const double scaled_line = 1.0 / static_cast<double>(last - first);
  double length_of_arc = 0.0;
  for (std::size_t k = first; k < last; ++k) {
    const double rise = magnitude[k + 1] - magnitude[k];
    length_of_arc += std::sqrt(scaled_line * scaled_line + rise * rise);
  }
  return -length_of_arc;
}

Computed ldlj(const UniformSamples& speed) {
  const auto& v = speed.values;
  if (v.size() < 3) return "fewer than three samples";
  double fastest = 0.0;
  for (const double value : v) fastest = std::max(fastest, std::abs(value));
  if (!(fastest > 0.0)) return "nothing moved";
  const double dt = speed.step_s;
  double squares = 0.0;
  for (std::size_t k = 1; k + 1 < v.size(); ++k) {
    const double jerk = (v[k + 1] - 2.0 * v[k] + v[k - 1]) / (dt * dt);
    squares += jerk * jerk;
  }
  if (!(squares > 0.0)) return "the speed never changes its slope";
  const double duration = static_cast<double>(v.size()) * dt;
  return -std::log(duration * duration * duration / (fastest * fastest) * squares * dt);
}

namespace {

constexpr std::size_t kTemplate = 2;  ///< m

double tolerance_of(std::span<const double> x) {
  constexpr double kShareOfSd = 0.2;
  const double n = static_cast<double>(x.size());
  double mean = 0.0;
  for (const double value : x) mean += value;
  mean /= n;
  double squares = 0.0;
  for (const double value : x) squares += (value - mean) * (value - mean);
  return kShareOfSd * std::sqrt(squares / n);
}

}  // namespace

TemplateMatches template_matches(std::span<const double> x) {
  TemplateMatches matches;
  if (x.size() <= kTemplate) return matches;
  const double r = tolerance_of(x);
  const std::size_t templates = x.size() - kTemplate;
  for (std::size_t i = 0; i < templates; ++i)
    for (std::size_t j = i + 1; j < templates; ++j) {
      if (std::abs(x[i] - x[j]) > r || std::abs(x[i + 1] - x[j + 1]) > r) continue;
      ++matches.shorter;
      if (std::abs(x[i + 2] - x[j + 2]) <= r) ++matches.longer;
    }
  return matches;
}

Computed sample_entropy(std::span<const double> x) {
  if (x.size() <= kTemplate + 1) return "fewer than four samples";
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  if (*least == *most) return "the signal does not vary";
  const TemplateMatches matches = template_matches(x);
  if (matches.shorter == 0 || matches.longer == 0) return "no templates match";
  return -std::log(static_cast<double>(matches.longer) / static_cast<double>(matches.shorter));
}

}  // namespace isograsp
