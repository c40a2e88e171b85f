// SPDX-License-Identifier: GPL-3.0-or-later
// r(shift): Pearson's r of target[k] and actual[k + shift] over the samples that both have.
//   lag = the shift of the largest r, moved to the top of the parabola through it and its
//   neighbours: step * (shift + (r_before - r_after) / (2 (r_before - 2 r + r_after)))
#include "tasks/measures/delay.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace isograsp::tasks {

namespace {

constexpr std::ptrdiff_t kLeastOverlap = 3;  // two points always correlate perfectly

/// Pearson r between target[k] and actual[k + shift] over the samples that both have.
std::optional<double> correlation_at(std::span<const double> target, std::span<const double> actual,
                                     std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(target.size());
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -shift);
  const std::ptrdiff_t count = std::min(n, n - shift) - first;
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

double mean_of(std::span<const double> x) {
  double sum = 0.0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

/// Four numbers at a time, wherever they lie.
using Four [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;
constexpr std::size_t kLanes = 24;  ///< shifts at a time: twelve vector registers hold them

/// sums[i] = sum(x[k] y[k + i]), i < kLanes. A loop over i would keep the sums in memory.
template <std::size_t... i>
[[gnu::always_inline]] inline void products_in(std::span<const double> x, const double* y,
                                               double* sums, std::index_sequence<i...>) {
  Four sum[sizeof...(i)]{};
  for (std::size_t k = 0; k < x.size(); ++k)
    ((sum[i] += x[k] * *reinterpret_cast<const Four*>(y + k + 4 * i)), ...);
  ((*reinterpret_cast<Four*>(sums + 4 * i) = sum[i]), ...);
}
using Quarters = std::make_index_sequence<kLanes / 4>;

void products_anywhere(std::span<const double> x, const double* y, double* sums) {
  products_in(x, y, sums, Quarters());
}

/// The same, rounded the same, for a processor that has registers of four numbers.
[[gnu::target("avx")]] void products_with_avx(std::span<const double> x, const double* y,
                                              double* sums) {
  products_in(x, y, sums, Quarters());
}

/// sum((x[k] - x_mean) (y[k + shift] - y_mean)) over the overlap, shifts from -most to most.
std::vector<double> cross_sums(std::span<const double> x, double x_mean, std::span<const double> y,
                               double y_mean, std::ptrdiff_t most) {
  const auto products = __builtin_cpu_supports("avx") != 0 ? products_with_avx : products_anywhere;
  const auto shifts = static_cast<std::size_t>(2 * most + 1);
  std::vector<double> centred(x.size());
  std::transform(x.begin(), x.end(), centred.begin(), [&](double value) { return value - x_mean; });
  std::vector<double> padded(y.size() + shifts + kLanes, 0.0);
  std::transform(y.begin(), y.end(), padded.begin() + most,
                 [&](double value) { return value - y_mean; });
  std::vector<double> sums(shifts + kLanes);
  for (std::size_t shift = 0; shift < shifts; shift += kLanes)
    products(centred, padded.data() + shift, sums.data() + shift);
  sums.resize(shifts);
  return sums;
}

struct Sums {
  double x = 0.0;
  double xx = 0.0;
};
/// Sums of x - mean and of its square over all values but the first 0, 1, ... most.
template <class Iterator>
std::vector<Sums> sums_without_first(Iterator first, Iterator last, double mean,
                                     std::ptrdiff_t most) {
  Sums rest;
  for (Iterator at = first; at != last; ++at) {
    rest.x += *at - mean;
    rest.xx += (*at - mean) * (*at - mean);
  }
  std::vector<Sums> sums{rest};
  for (; first != last && most > 0; ++first, --most) {
    rest.x -= *first - mean;
    rest.xx -= (*first - mean) * (*first - mean);
    sums.push_back(rest);
  }
  return sums;
}

/// correlation_at() of all shifts from -most to most at once, but rounded more coarsely; no value
/// where so little varies that only correlation_at() itself can tell.
std::vector<std::optional<double>> rough_correlations(std::span<const double> x,
                                                      std::span<const double> y,
                                                      std::ptrdiff_t most) {
  const double x_mean = mean_of(x);
  const double y_mean = mean_of(y);
  const auto xy = cross_sums(x, x_mean, y, y_mean, most);
  const auto x_without_first = sums_without_first(x.begin(), x.end(), x_mean, most);
  const auto x_without_last = sums_without_first(x.rbegin(), x.rend(), x_mean, most);
  const auto y_without_first = sums_without_first(y.begin(), y.end(), y_mean, most);
  const auto y_without_last = sums_without_first(y.rbegin(), y.rend(), y_mean, most);
  std::vector<std::optional<double>> r(xy.size());
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const auto lost = static_cast<std::size_t>(std::abs(shift));
    if (lost + kLeastOverlap > x.size()) continue;
    const Sums& of_x = shift < 0 ? x_without_first[lost] : x_without_last[lost];
    const Sums& of_y = shift < 0 ? y_without_last[lost] : y_without_first[lost];
    const auto n = static_cast<double>(x.size() - lost);
    const double xx = of_x.xx - of_x.x * of_x.x / n;
    const double yy = of_y.xx - of_y.x * of_y.x / n;
    constexpr double kCancelled = 1e-3;  // of the whole: below, three more digits are lost
    if (xx <= kCancelled * x_without_first[0].xx || yy <= kCancelled * y_without_first[0].xx)
      continue;
    const auto i = static_cast<std::size_t>(shift + most);
    r[i] = (xy[i] - of_x.x * of_y.x / n) / std::sqrt(xx * yy);
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

LagPeak lag_peak(const statistics::UniformSamples& target,
                 const statistics::UniformSamples& actual) {
  assert(target.values.size() == actual.values.size());
  const auto none = [](Words why) { return LagPeak{why, why}; };
  constexpr double kMost_s = 1.5;
  constexpr double kLeastCorrelation = 0.35;
  constexpr double kRoundingSlack = 1e-9;
  const auto most =
      static_cast<std::ptrdiff_t>(std::floor(kMost_s / target.step_s * (1.0 + kRoundingSlack)));
  if (!varies(target.values) || !varies(actual.values))
    return none("target or actual does not vary"_text);
  const auto exact = [&](std::ptrdiff_t shift) {
    return correlation_at(target.values, actual.values, shift);
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
  if (!here) return none("target or actual does not vary"_text);
  if (*here < kLeastCorrelation) return none("the correlation stays below 0.35"_text);
  constexpr Words kNoPeak = "the correlation has no peak within 1.5 s"_text;
  if (peak == -most || peak == most) return none(kNoPeak);
  const auto before = exact(peak - 1);
  const auto after = exact(peak + 1);
  if (!before || !after) return none(kNoPeak);
  const double bend = *before - 2.0 * *here + *after;
  const double part = bend < 0.0 ? 0.5 * (*before - *after) / bend : 0.0;
  return {(static_cast<double>(peak) + part) * target.step_s, *here};
}

statistics::Computed lag(const statistics::UniformSamples& target,
                         const statistics::UniformSamples& actual) {
  return lag_peak(target, actual).lag_s;
}

}  // namespace isograsp::tasks
