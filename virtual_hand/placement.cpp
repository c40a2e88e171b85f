// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/placement.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::virtual_hand {

namespace {

constexpr double kTimeSlack_s = 1e-9;  // differences of times are rounded

void score_hold(std::span<const PlacementRow> rows, std::size_t trigger, std::size_t done,
                PlacementScore& score) {
  double distance = 0.0;
  double axis = 0.0;
  double geodesic = 0.0;
  for (std::size_t k = trigger; k < done; ++k) {
    const double weight_s = rows[k + 1].t_s - rows[k].t_s;
    distance += weight_s * (rows[k].X_WO.p - rows[k].X_WT.p).norm();
    axis += weight_s * main_axis_angle(rows[k].X_WO.q, rows[k].X_WT.q);
    geodesic += weight_s * angle_between(rows[k].X_WO.q, rows[k].X_WT.q);
  }
  score.completed = true;
  score.manipulation_s = rows[trigger].t_s - rows.front().t_s;
  score.done_s = rows[done].t_s - rows.front().t_s;
  const double held_s = rows[done].t_s - rows[trigger].t_s;
  score.hold_distance_m = distance / held_s;
  score.hold_axis_angle_rad = axis / held_s;
  score.hold_geodesic_rad = geodesic / held_s;
}

}  // namespace

double main_axis_angle(const Quat& a, const Quat& b) noexcept {
  const Vec3 of_a = a * Vec3::UnitZ();
  const Vec3 of_b = b * Vec3::UnitZ();
  return std::atan2(of_a.cross(of_b).norm(), std::abs(of_a.dot(of_b)));
}

bool PlacementWatch::within(const PlacementRow& row, double times) const noexcept {
  return (row.X_WO.p - row.X_WT.p).norm() <= times * rule_.distance_m &&
         main_axis_angle(row.X_WO.q, row.X_WT.q) <= times * rule_.angle_rad;
}

bool PlacementWatch::watch_drop(const PlacementRow& row) noexcept {
  bool dropped = false;
  if (row.held) {
    let_go_s_.reset();
  } else if (was_held_ && !row.supported) {
    let_go_s_ = row.t_s;
  } else if (let_go_s_ &&
             (row.supported || row.t_s - *let_go_s_ >= rule_.dropped_s - kTimeSlack_s)) {
    dropped = true;
    ++drops_;
    let_go_s_.reset();
  }
  was_held_ = row.held;
  return dropped;
}

bool PlacementWatch::add(const PlacementRow& row) noexcept {
  const bool dropped = watch_drop(row);
  if (there_s_ && !(row.held && within(row, rule_.stays_within))) there_s_.reset();
  done_ = there_s_ && row.t_s - *there_s_ >= rule_.hold_s - kTimeSlack_s;
  if (!there_s_ && row.held && within(row, 1.0)) there_s_ = row.t_s;
  return dropped;
}

double PlacementWatch::hold_fraction(double t_s) const noexcept {
  return there_s_ ? std::clamp((t_s - *there_s_) / rule_.hold_s, 0.0, 1.0) : 0.0;
}

PlacementScore score_placement(std::span<const PlacementRow> rows, const PlacementRule& rule) {
  PlacementScore score;
  PlacementWatch watch(rule);
  std::size_t trigger = 0;
  for (std::size_t k = 0; k < rows.size() && !score.completed; ++k) {
    watch.add(rows[k]);
    if (watch.there_since_s() == rows[k].t_s) trigger = k;
    if (watch.done()) score_hold(rows, trigger, k, score);
  }
  score.fails = watch.drops();
  return score;
}

}  // namespace isograsp::virtual_hand
