// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/placement.hpp"

#include <cmath>

namespace isograsp::virtual_hand {

namespace {

constexpr double kTimeSlack_s = 1e-9;  // differences of times are rounded

bool within(const PlacementRow& row, const PlacementRule& rule, double times) noexcept {
  return (row.X_WO.p - row.X_WT.p).norm() <= times * rule.distance_m &&
         main_axis_angle(row.X_WO.q, row.X_WT.q) <= times * rule.angle_rad;
}

/// Counts drops row by row.
class Drops {
 public:
  explicit Drops(double dropped_s) noexcept : dropped_s_(dropped_s) {}
  void add(const PlacementRow& row) noexcept {
    if (row.held) {
      let_go_s_.reset();
    } else if (was_held_ && !row.supported) {
      let_go_s_ = row.t_s;
    } else if (let_go_s_ && (row.supported || row.t_s - *let_go_s_ >= dropped_s_ - kTimeSlack_s)) {
      ++count_;
      let_go_s_.reset();
    }
    was_held_ = row.held;
  }
  [[nodiscard]] int count() const noexcept { return count_; }

 private:
  double dropped_s_;
  bool was_held_ = false;
  std::optional<double> let_go_s_;
  int count_ = 0;
};

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
  const double held_s = rows[done].t_s - rows[trigger].t_s;
  score.completed = true;
  score.manipulation_s = rows[trigger].t_s - rows.front().t_s;
  score.done_s = rows[done].t_s - rows.front().t_s;
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

PlacementScore score_placement(std::span<const PlacementRow> rows, const PlacementRule& rule) {
  PlacementScore score;
  Drops drops(rule.dropped_s);
  std::optional<std::size_t> trigger;
  for (std::size_t k = 0; k < rows.size() && !score.completed; ++k) {
    const PlacementRow& row = rows[k];
    drops.add(row);
    if (trigger && !(row.held && within(row, rule, rule.stays_within))) trigger.reset();
    if (trigger && row.t_s - rows[*trigger].t_s >= rule.hold_s - kTimeSlack_s)
      score_hold(rows, *trigger, k, score);
    if (!trigger && row.held && within(row, rule, 1.0)) trigger = k;
  }
  score.fails = drops.count();
  return score;
}

}  // namespace isograsp::virtual_hand
