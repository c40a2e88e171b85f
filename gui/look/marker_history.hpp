// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the last seconds each marker, and each segment of an arm, was seen.
#pragma once

#include <bitset>
#include <deque>
#include <optional>

#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class MarkerHistory {
 public:
  explicit MarkerHistory(double length_s = 10.0) : length_s_(length_s) {}

  /// Takes the snapshot if it is a new frame; forgets what is older than the length.
  void add(const session::ArmSnapshot& snapshot);
  [[nodiscard]] double length_s() const noexcept { return length_s_; }
  /// Of the snapshots in that time; nothing: there was none.
  [[nodiscard]] std::optional<double> marker_percent(std::size_t marker) const;
  [[nodiscard]] std::optional<double> segment_percent(ArmSegment segment) const;

 private:
  struct Row {
    double t_s = 0.0;
    std::bitset<session::ArmRig::kMostMarkers> markers;
    std::bitset<kArmSegmentCount> segments;
  };
  double length_s_;
  std::deque<Row> rows_;
};

}  // namespace isograsp::gui
