// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/butterworth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp {

LowPass2 butterworth2(double rate_Hz, double cutoff_Hz) noexcept {
  // H(s) = 1 / (s^2 + sqrt2 s + 1), s = (1 - z^-1) / (w (1 + z^-1)), w = tan(pi fc / fs)
  const double w = std::tan(std::numbers::pi * cutoff_Hz / rate_Hz);
  const double a0 = 1.0 + std::numbers::sqrt2 * w + w * w;
  LowPass2 filter;
  filter.b0 = w * w / a0;
  filter.b1 = 2.0 * filter.b0;
  filter.b2 = filter.b0;
  filter.a1 = 2.0 * (w * w - 1.0) / a0;
  filter.a2 = (1.0 - std::numbers::sqrt2 * w + w * w) / a0;
  return filter;
}

namespace {

/// In place, in the order of the iterators.
template <class Iterator>
void run(const LowPass2& filter, Iterator first, Iterator last) {
  if (first == last) return;
  double x1 = *first;
  double x2 = x1;
  double y1 = x1;  // the gain of a constant is one
  double y2 = x1;
  for (; first != last; ++first) {
    const double x = *first;
    const double y =
        filter.b0 * x + filter.b1 * x1 + filter.b2 * x2 - filter.a1 * y1 - filter.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    *first = y;
  }
}

/// Samples until the slowest part of a filter's start has died away.
std::size_t memory_of(const LowPass2& filter, std::size_t most) {
  constexpr double kForgotten = 1e-6;  // of the start: far below the resolution of any sensor
  const double decay = std::sqrt(std::max(filter.a2, 0.0));  // complex poles: |z|^2 = a2
  if (decay >= 1.0) return most;
  if (decay <= 0.0) return 0;
  const double samples = std::ceil(std::log(kForgotten) / std::log(decay));
  return samples < static_cast<double>(most) ? static_cast<std::size_t>(samples) : most;
}

}  // namespace

std::vector<double> filtered(const LowPass2& filter, std::span<const double> x) {
  std::vector<double> y(x.begin(), x.end());
  run(filter, y.begin(), y.end());
  return y;
}

std::vector<double> filtered_zero_phase(const LowPass2& filter, std::span<const double> x) {
  if (x.empty()) return {};
  const std::size_t n = x.size();
  const std::size_t margin = memory_of(filter, n - 1);
  std::vector<double> y;
  y.reserve(n + 2 * margin);
  for (std::size_t k = margin; k > 0; --k) y.push_back(2.0 * x[0] - x[k]);
  y.insert(y.end(), x.begin(), x.end());
  for (std::size_t k = 1; k <= margin; ++k) y.push_back(2.0 * x[n - 1] - x[n - 1 - k]);
  run(filter, y.begin(), y.end());
  run(filter, y.rbegin(), y.rend());
  const auto first = y.begin() + static_cast<std::ptrdiff_t>(margin);
  return {first, first + static_cast<std::ptrdiff_t>(n)};
}

}  // namespace isograsp
