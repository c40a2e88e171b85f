// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/force_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace isograsp::gui {

namespace {
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// The smallest of 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 15 … that is not below `value`.
double round_up(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * decade) return step * decade;
  return 10.0 * decade;
}
}  // namespace

void ForceHistory::add(const session::Snapshot& snapshot) {
  if (snapshot.frames == 0) return;
  if (!points_.empty()) {
    if (snapshot.session_time_s == points_.back().t_s) return;
    if (snapshot.session_time_s < points_.back().t_s) points_.clear();  // another session
  }
  ForcePoint point;
  point.t_s = snapshot.session_time_s;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const bool missing = (snapshot.forces.flags[f] & bit(SampleFlag::missing)) != 0;
    point.normal_N[f] = missing ? kNothing : snapshot.forces.wrench_C[f].force.z();
  }
  const bool shown = snapshot.trial_number > 0 && snapshot.special.force().force_target_shown;
  point.target_N = shown ? snapshot.special.force().target_force_N : kNothing;
  points_.push_back(point);
  while (points_.front().t_s < point.t_s - length_s_) points_.pop_front();
}

void AxisRange::include(double value_N) noexcept {
  if (std::isnan(value_N)) return;
  least_N_ = std::min(least_N_, value_N);
  most_N_ = std::max(most_N_, value_N);
}

AxisRange::Limits ForceHistory::range() const {
  AxisRange range;
  for (const auto& point : points_) {
    for (const double value : point.normal_N) range.include(value);
    range.include(point.target_N);
  }
  return range.limits();
}

AxisRange::Limits AxisRange::limits() const {
  // Room above the curve, and never so close that sensor noise fills the plot.
  constexpr double kLeastTop_N = 5.0;
  constexpr double kRoom = 1.05;
  Limits limits;
  limits.most_N = round_up(std::max(kLeastTop_N, most_N_ * kRoom));
  const double bottom = limits.most_N / 10.0;
  limits.least_N = least_N_ < -bottom ? -round_up(-least_N_ * kRoom) : -bottom;
  return limits;
}

std::array<double, kFingerCount> label_places(const std::array<double, kFingerCount>& normal_N,
                                              double apart_N, double axis_from_N) {
  std::array<std::size_t, kFingerCount> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::array<double, kFingerCount> place{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    place[f] = std::isnan(normal_N[f]) ? 0.0 : normal_N[f];
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return place[a] < place[b]; });
  double pushed_N = 0.0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const double free = std::max(place[order[k]], place[order[k - 1]] + apart_N);
    pushed_N += free - place[order[k]];
    place[order[k]] = free;
  }
  for (double& one : place) one -= pushed_N / kFingerCount;
  const double lift_N = std::max(0.0, axis_from_N + apart_N / 2.0 - place[order.front()]);
  for (double& one : place) one += lift_N;
  return place;
}

}  // namespace isograsp::gui
