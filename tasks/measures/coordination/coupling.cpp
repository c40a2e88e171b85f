// SPDX-License-Identifier: GPL-3.0-or-later
// x: load, y: grip, both about their means; r(shift): Pearson's r of x[k] and y[k + shift].
//   slope = sum x y / sum x^2,  correlation = largest r(shift) within 0.5 s
//   lag = its shift, moved to the top of the parabola through it and its neighbours
//   safety margin = 100 sum w (1 - needed / grip) / sum w, where there is grip
#include "tasks/measures/coordination/coupling.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "statistics/weighted.hpp"

namespace isograsp::tasks {

namespace {

/// A signal about its mean, with the running sums that give mean and variance of any stretch.
class Centred {
 public:
  explicit Centred(const std::vector<double>& x) : value_(x), sum_(1, 0.0), squares_(1, 0.0) {
    double mean = 0.0;
    for (const double v : x) mean += v / static_cast<double>(x.size());
    for (double& v : value_) {
      v -= mean;
      sum_.push_back(sum_.back() + v);
      squares_.push_back(squares_.back() + v * v);
    }
    offset_ = mean;
  }
  [[nodiscard]] const double* from(std::size_t first) const { return value_.data() + first; }
  [[nodiscard]] double sum(std::size_t first, std::size_t count) const {
    return sum_[first + count] - sum_[first];
  }
  /// Sum of squares about the mean of the stretch; 0 if that is only rounding.
  [[nodiscard]] double variation(std::size_t first, std::size_t count) const {
    const double total = sum(first, count);
    const double about_mean =
        squares_[first + count] - squares_[first] - total * total / static_cast<double>(count);
    // Running sums round by about n eps of the whole; removing the mean by eps of the mean.
    constexpr double kRounding = 1e-12;
    constexpr double kConstant = 1e-26;
    const double floor =
        kRounding * squares_.back() + kConstant * static_cast<double>(count) * offset_ * offset_;
    return about_mean > floor ? about_mean : 0.0;
  }

 private:
  std::vector<double> value_;
  std::vector<double> sum_;
  std::vector<double> squares_;
  double offset_ = 0.0;
};

double sum_of_products(const double* x, const double* y, std::size_t count) {
  std::array<double, 4> sum{};  // four sums run side by side: faster than one
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4)
    for (std::size_t i = 0; i < 4; ++i) sum[i] += x[k + i] * y[k + i];
  for (; k < count; ++k) sum[0] += x[k] * y[k];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace

std::vector<double> opposing_mean(std::span<const double> thumb_N,
                                  std::span<const double> fingers_N) {
  assert(thumb_N.size() == fingers_N.size());
  std::vector<double> grip_N(thumb_N.size());
  for (std::size_t k = 0; k < grip_N.size(); ++k) grip_N[k] = 0.5 * (thumb_N[k] + fingers_N[k]);
  return grip_N;
}

Coupling grip_load_coupling(const statistics::UniformSamples& grip,
                            const statistics::UniformSamples& load) {
  assert(grip.values.size() == load.values.size());
  constexpr double kMost_s = 0.5;
  constexpr double kRoundingSlack = 1e-9;
  const std::size_t n = load.values.size();
  const auto most =
      static_cast<std::ptrdiff_t>(std::floor(kMost_s / load.step_s * (1.0 + kRoundingSlack)));
  constexpr Words too_short = "shorter than the lags that are tried"_text;
  if (n < static_cast<std::size_t>(2 * most + 3)) return {too_short, too_short, too_short};
  const Centred x(load.values);
  const Centred y(grip.values);
  constexpr Words constant = "grip or load does not vary"_text;
  if (!(x.variation(0, n) > 0.0 && y.variation(0, n) > 0.0)) return {constant, constant, constant};
  Coupling coupling;
  coupling.slope = sum_of_products(x.from(0), y.from(0), n) / x.variation(0, n);
  std::vector<double> r;
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    const auto of_load = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, -shift));
    const auto of_grip = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, shift));
    const std::size_t count = n - std::max(of_load, of_grip);
    const double varied = x.variation(of_load, count) * y.variation(of_grip, count);
    const double product =
        sum_of_products(x.from(of_load), y.from(of_grip), count) -
        x.sum(of_load, count) * y.sum(of_grip, count) / static_cast<double>(count);
    r.push_back(varied > 0.0 ? product / std::sqrt(varied) : -1.0);
  }
  const auto peak = std::max_element(r.begin(), r.end());
  coupling.correlation = *peak;
  if (peak == r.begin() || peak + 1 == r.end()) {
    coupling.lag_s = "the correlation has no peak within 0.5 s"_text;
    return coupling;
  }
  const double bend = peak[-1] - 2.0 * peak[0] + peak[1];
  const double part = bend < 0.0 ? 0.5 * (peak[-1] - peak[1]) / bend : 0.0;
  coupling.lag_s = (static_cast<double>(peak - r.begin() - most) + part) * load.step_s;
  return coupling;
}

statistics::Computed safety_margin(std::span<const double> grip_N, std::span<const double> needed_N,
                                   std::span<const double> weight) {
  assert(grip_N.size() == needed_N.size() && grip_N.size() == weight.size());
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    if (!(grip_N[k] > 0.0)) continue;
    sum += weight[k] * (1.0 - needed_N[k] / grip_N[k]);
    total += weight[k];
  }
  if (!(total > 0.0)) return "there was no grip"_text;
  return 100.0 * sum / total;
}

namespace {

/// Weighted mean and variance of the population; nothing without weight.
struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  /// Rounding alone makes about eps mean^2.
  [[nodiscard]] bool vary() const { return variance > 1e-24 * mean * mean && variance > 0.0; }
};
std::optional<Moments> moments_of(std::span<const double> x, std::span<const double> weight) {
  const statistics::Computed mean =
      statistics::weighted_mean_of(weight, [&](std::size_t k) { return x[k]; });
  if (!mean.value) return std::nullopt;
  const statistics::Computed variance = statistics::weighted_mean_of(
      weight, [&](std::size_t k) { return std::pow(x[k] - *mean.value, 2); });
  return Moments{*mean.value, *variance.value};
}

}  // namespace

statistics::Computed correlation(std::span<const double> x, std::span<const double> y,
                                 std::span<const double> weight) {
  const auto a = moments_of(x, weight);
  const auto b = moments_of(y, weight);
  if (!a || !b) return "no samples"_text;
  if (!a->vary() || !b->vary()) return "a signal does not vary"_text;
  const statistics::Computed together = statistics::weighted_mean_of(
      weight, [&](std::size_t k) { return (x[k] - a->mean) * (y[k] - b->mean); });
  return std::clamp(*together.value / std::sqrt(a->variance * b->variance), -1.0, 1.0);
}

statistics::Computed variation(std::span<const double> x, std::span<const double> weight) {
  const auto of = moments_of(x, weight);
  if (!of) return "no samples"_text;
  if (!(of->mean > 0.0)) return "the mean is not positive"_text;
  return 100.0 * std::sqrt(of->variance) / of->mean;
}

}  // namespace isograsp::tasks
