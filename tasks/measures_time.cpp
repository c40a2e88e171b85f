// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures_time.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>

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

}  // namespace

Computed lag(const UniformSamples& target, const UniformSamples& actual) {
  assert(target.values.size() == actual.values.size());
  constexpr double kMost_s = 1.5;
  constexpr double kLeastCorrelation = 0.35;
  constexpr double kRoundingSlack = 1e-9;
  const auto most =
      static_cast<std::ptrdiff_t>(std::floor(kMost_s / target.step_s * (1.0 + kRoundingSlack)));
  std::vector<std::optional<double>> r(static_cast<std::size_t>(2 * most + 1));
  std::optional<std::size_t> peak;
  for (std::size_t i = 0; i < r.size(); ++i) {
    r[i] = correlation(target.values, actual.values, static_cast<std::ptrdiff_t>(i) - most);
    if (r[i] && (!peak || *r[i] > *r[*peak])) peak = i;
  }
  if (!peak) return "target or actual does not vary";
  if (*r[*peak] < kLeastCorrelation) return "the correlation stays below 0.35";
  if (*peak == 0 || *peak + 1 == r.size() || !r[*peak - 1] || !r[*peak + 1])
    return "the correlation has no peak within 1.5 s";
  const double before = *r[*peak - 1];
  const double here = *r[*peak];
  const double after = *r[*peak + 1];
  const double bend = before - 2.0 * here + after;
  const double part = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
  const auto shift = static_cast<std::ptrdiff_t>(*peak) - most;
  return (static_cast<double>(shift) + part) * target.step_s;
}

std::optional<SineFit> fit_sine(std::span<const double> t_s, std::span<const double> x,
                                double frequency_Hz) {
  assert(t_s.size() == x.size());
  const double omega = 2.0 * std::numbers::pi * frequency_Hz;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Eigen::Vector3d row(1.0, std::sin(omega * t_s[k]), std::cos(omega * t_s[k]));
    normal += row * row.transpose();
    right += row * x[k];
  }
  constexpr double kLeastCondition = 1e-6;  // below: a short piece of a cycle is all there is
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success || solver.rcond() < kLeastCondition) return std::nullopt;
  const Eigen::Vector3d fitted = solver.solve(right);
  return SineFit{fitted[0], std::hypot(fitted[1], fitted[2]), std::atan2(fitted[2], fitted[1])};
}

Computed gain(std::span<const double> t_s, std::span<const double> target,
              std::span<const double> actual, double frequency_Hz) {
  constexpr double kRoundingSlack = 1e-6;
  const double step_s = t_s.size() < 2 ? 0.0 : t_s[1] - t_s[0];
  if (t_s.size() < 3 || (t_s.back() - t_s.front() + step_s) * frequency_Hz < 1.0 - kRoundingSlack)
    return "less than one whole cycle";
  const auto of_target = fit_sine(t_s, target, frequency_Hz);
  const auto of_actual = fit_sine(t_s, actual, frequency_Hz);
  if (!of_target || !of_actual) return "too few samples for a sine";
  constexpr double kNoSine = 1e-12;
  if (of_target->amplitude <= kNoSine * std::abs(of_target->offset))
    return "the target has no component at its frequency";
  return of_actual->amplitude / of_target->amplitude;
}

StepResponse step_response(std::span<const double> t_s, std::span<const double> y,
                           double final_value) {
  assert(t_s.size() == y.size() && !y.empty() && final_value != 0.0);
  const auto first_crossing = [&](double share) -> std::optional<double> {
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double here = y[k] / final_value;
      if (here < share) continue;
      if (k == 0) return t_s[0];
      const double before = y[k - 1] / final_value;
      return t_s[k - 1] + (share - before) / (here - before) * (t_s[k] - t_s[k - 1]);
    }
    return std::nullopt;
  };
  StepResponse response;
  response.t10_s = first_crossing(0.1);
  response.t63_s = first_crossing(1.0 - 1.0 / std::numbers::e);
  response.t90_s = first_crossing(0.9);
  if (response.t10_s && response.t90_s) response.rise10_90_s = *response.t90_s - *response.t10_s;
  constexpr double kSettled = 0.02;
  std::size_t settled_from = y.size();
  while (settled_from > 0 && std::abs(y[settled_from - 1] / final_value - 1.0) <= kSettled)
    --settled_from;
  if (settled_from < y.size()) response.settle2pct_s = t_s[settled_from];
  for (const double value : y)
    response.overshoot = std::max(response.overshoot, value / final_value - 1.0);
  return response;
}

}  // namespace isograsp
