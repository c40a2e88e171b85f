// SPDX-License-Identifier: GPL-3.0-or-later
// The last seconds of the forces, as the live plot shows them. Normal forces, pressing +, [N].
#pragma once

#include <array>
#include <deque>

#include "session/platform/snapshot.hpp"

namespace isograsp::gui {

struct ForcePoint {
  double t_s = 0.0;                             ///< session time
  std::array<double, kFingerCount> normal_N{};  ///< NaN: no sample
  double target_N = 0.0;                        ///< NaN: no target shown
};

/// Limits of a force axis [N] that hold all values, on round numbers so that the axis rarely moves.
class AxisRange {
 public:
  struct Limits {
    double least_N = 0.0;
    double most_N = 0.0;
  };
  void include(double value_N) noexcept;  ///< NaN: nothing
  [[nodiscard]] Limits limits() const;

 private:
  double least_N_ = 0.0;
  double most_N_ = 0.0;
};

class ForceHistory {
 public:
  explicit ForceHistory(double length_s = 20.0) : length_s_(length_s) {}

  /// Takes the snapshot if it is a new frame; forgets what is older than the length.
  void add(const session::Snapshot& snapshot);
  void clear() { points_.clear(); }
  [[nodiscard]] const std::deque<ForcePoint>& points() const noexcept { return points_; }
  [[nodiscard]] double length_s() const noexcept { return length_s_; }
  /// Of an axis that holds all points.
  [[nodiscard]] AxisRange::Limits range() const;

 private:
  double length_s_;
  std::deque<ForcePoint> points_;
};

/// Where the letters of the curves stand on the axis [N]: at the ends of their curves, which are
/// `normal_N`, spread so that none covers another, and whole above the lower end of the axis.
/// `apart_N`: the height of a letter.
[[nodiscard]] std::array<double, kFingerCount> label_places(
    const std::array<double, kFingerCount>& normal_N, double apart_N, double axis_from_N);

}  // namespace isograsp::gui
