// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/delay.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>

#include "tasks/measures/smoothness.hpp"

namespace isograsp {

namespace {

/// Pearson r between target[k] and actual[k + shift] over the samples that both have.
std::optional<double> correlation(std::span<const double> target, std::span<const double> actual,
                                  std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(target.size());
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -shift);
  const std::ptrdiff_t count = std::min(n, n - shift) - first;
  constexpr std::ptrdiff_t kLeastOverlap = 3;  // two points always correlate perfectly
  if (count < kLeastOverlap) return std::nullopt;
  const double* const x = target.data() + first;
  const double* const y = actual.data() + first + shift;
  double x_mean = 0.0;
  double y_mean = 0.0;
  double x_most = 0.0;
  double y_most = 0.0;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    x_mean += x[k];
    y_mean += y[k];
    x_most = std::max(x_most, std::abs(x[k]));
    y_most = std::max(y_most, std::abs(y[k]));
  }
  x_mean /= static_cast<double>(count);
  y_mean /= static_cast<double>(count);
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    xx += (x[k] - x_mean) * (x[k] - x_mean);
    yy += (y[k] - y_mean) * (y[k] - y_mean);
    xy += (x[k] - x_mean) * (y[k] - y_mean);
  }
  // A constant signal leaves only the rounding of its mean: about n eps^2 max^2.
  constexpr double kConstant = 1e-26;
  const double n_count = static_cast<double>(count);
  if (xx <= kConstant * n_count * x_most * x_most || yy <= kConstant * n_count * y_most * y_most)
    return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

/// sum(x[k] y[k + shift]) for every shift of up to `most` either way, by blocks in the spectrum.
std::vector<double> cross_sums(std::span<const double> x, std::span<const double> y,
                               std::ptrdiff_t most) {
  const auto n = static_cast<std::ptrdiff_t>(x.size());
  // Each block of x meets `most` more samples of y on both sides. Eight times as long a transform
  // spends most of itself on the block.
  const std::size_t length = std::bit_ceil(static_cast<std::size_t>(8 * most + 1));
  const std::ptrdiff_t block = static_cast<std::ptrdiff_t>(length) - 2 * most;
  std::vector<std::complex<double>> spectrum(length);
  std::vector<std::complex<double>> both(length);
  for (std::ptrdiff_t first = 0; first < n; first += block) {
    // One transform for two real signals: x in the real part, y in the imaginary one.
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(length); ++i) {
      const std::ptrdiff_t of_x = first + i;
      const std::ptrdiff_t of_y = first + i - most;
      both[static_cast<std::size_t>(i)] = {
          i < block && of_x < n ? x[static_cast<std::size_t>(of_x)] : 0.0,
          of_y >= 0 && of_y < n ? y[static_cast<std::size_t>(of_y)] : 0.0};
    }
    fourier_transform(both);
    for (std::size_t k = 0; k < length; ++k) {
      const std::complex<double> a = both[k];
      const std::complex<double> b = std::conj(both[(length - k) & (length - 1)]);
      // X = (a + b) / 2, Y = (a - b) / 2i; conjugated product of X and Y, then conjugated again so
      // that the forward transform serves as the inverse.
      const std::complex<double> sum = a + b;
      const std::complex<double> difference = a - b;
      const double re = sum.real() * difference.imag() - sum.imag() * difference.real();
      const double im = sum.real() * difference.real() + sum.imag() * difference.imag();
      spectrum[k] += std::complex<double>(re, im);
    }
  }
  fourier_transform(spectrum);
  std::vector<double> sums(static_cast<std::size_t>(2 * most + 1));
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = spectrum[i].real() / (4.0 * static_cast<double>(length));
  return sums;
}

/// Sums over the first k samples, of x and of its square.
struct RunningSums {
  std::vector<double> x;
  std::vector<double> xx;
  explicit RunningSums(std::span<const double> values) : x{0.0}, xx{0.0} {
    x.reserve(values.size() + 1);
    xx.reserve(values.size() + 1);
    for (const double value : values) {
      x.push_back(x.back() + value);
      xx.push_back(xx.back() + value * value);
    }
  }
};

std::vector<double> centred(std::span<const double> x) {
  double mean = 0.0;
  for (const double value : x) mean += value;
  mean /= static_cast<double>(x.size());
  std::vector<double> rest(x.begin(), x.end());
  for (double& value : rest) value -= mean;
  return rest;
}

/// correlation() of all shifts from -most to most at once, but rounded more coarsely; no value
/// where so little varies that only correlation() itself can tell.
std::vector<std::optional<double>> rough_correlations(std::span<const double> target,
                                                      std::span<const double> actual,
                                                      std::ptrdiff_t most) {
  const std::vector<double> x = centred(target);
  const std::vector<double> y = centred(actual);
  const std::vector<double> xy = cross_sums(x, y, most);
  const RunningSums of_x(x);
  const RunningSums of_y(y);
  const auto n = static_cast<std::ptrdiff_t>(x.size());
  std::vector<std::optional<double>> r(xy.size());
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const std::ptrdiff_t overlap = std::min(n, n - shift) - std::max<std::ptrdiff_t>(0, -shift);
    if (overlap <= 0) continue;
    const auto from_x = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -shift));
    const auto from_y = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, shift));
    const auto count = static_cast<std::size_t>(overlap);
    const double n_count = static_cast<double>(overlap);
    const double x_sum = of_x.x[from_x + count] - of_x.x[from_x];
    const double y_sum = of_y.x[from_y + count] - of_y.x[from_y];
    const double xx = of_x.xx[from_x + count] - of_x.xx[from_x] - x_sum * x_sum / n_count;
    const double yy = of_y.xx[from_y + count] - of_y.xx[from_y] - y_sum * y_sum / n_count;
    constexpr double kCancelled = 1e-3;  // of the whole: less has lost three more digits
    if (xx <= kCancelled * of_x.xx.back() || yy <= kCancelled * of_y.xx.back()) continue;
    const auto i = static_cast<std::size_t>(shift + most);
    r[i] = (xy[i] - x_sum * y_sum / n_count) / std::sqrt(xx * yy);
  }
  return r;
}

double rough_maximum(const std::vector<std::optional<double>>& r) {
  double highest = -1.0;
  for (const auto& value : r)
    if (value) highest = std::max(highest, *value);
  return highest;
}

bool varies(std::span<const double> x) {
  return std::any_of(x.begin(), x.end(), [&](double value) { return value != x.front(); });
}

}  // namespace

Computed lag(const UniformSamples& target, const UniformSamples& actual) {
  assert(target.values.size() == actual.values.size());
  constexpr double kMost_s = 1.5;
  constexpr double kLeastCorrelation = 0.35;
  constexpr double kRoundingSlack = 1e-9;
  const auto most =
      static_cast<std::ptrdiff_t>(std::floor(kMost_s / target.step_s * (1.0 + kRoundingSlack)));
  if (!varies(target.values) || !varies(actual.values)) return "target or actual does not vary";
  const auto exact = [&](std::ptrdiff_t shift) {
    return correlation(target.values, actual.values, shift);
  };
  // The rough values only say where to look: what is compared and returned is exact.
  constexpr double kRough = 1e-10;  // above the error of the rough values
  const auto rough = rough_correlations(target.values, actual.values, most);
  const double highest = rough_maximum(rough);
  std::optional<double> here;
  std::ptrdiff_t peak = 0;
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const auto& guess = rough[static_cast<std::size_t>(shift + most)];
    if (guess && *guess < highest - kRough) continue;
    const auto r = exact(shift);
    if (!r || (here && *r <= *here)) continue;
    here = r;
    peak = shift;
  }
  if (!here) return "target or actual does not vary";
  if (*here < kLeastCorrelation) return "the correlation stays below 0.35";
  constexpr const char* kNoPeak = "the correlation has no peak within 1.5 s";
  if (peak == -most || peak == most) return kNoPeak;
  const auto before = exact(peak - 1);
  const auto after = exact(peak + 1);
  if (!before || !after) return kNoPeak;
  const double bend = *before - 2.0 * *here + *after;
  const double part = bend < 0.0 ? 0.5 * (*before - *after) / bend : 0.0;
  return (static_cast<double>(peak) + part) * target.step_s;
}

}  // namespace isograsp
