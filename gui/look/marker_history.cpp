// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/marker_history.hpp"

#include <algorithm>

namespace isograsp::gui {

namespace {

template <class Rows, class Seen>
std::optional<double> percent_of(const Rows& rows, Seen seen) {
  if (rows.empty()) return std::nullopt;
  constexpr double kPercent = 100.0;
  const auto count = std::count_if(rows.begin(), rows.end(), seen);
  return kPercent * static_cast<double>(count) / static_cast<double>(rows.size());
}

}  // namespace

void MarkerHistory::add(const session::ArmSnapshot& snapshot) {
  if (snapshot.frames == 0) return;
  const double t_s = snapshot.session_time_s;
  if (!rows_.empty()) {
    if (t_s == rows_.back().t_s) return;
    if (t_s < rows_.back().t_s) rows_.clear();  // another session
  }
  Row row;
  row.t_s = t_s;
  for (std::size_t m = 0; m < snapshot.marker_count; ++m)
    row.markers[m] = snapshot.markers_W[m].allFinite();
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    row.segments[s] = has_pose(snapshot.segments[s].state);
  rows_.push_back(row);
  while (rows_.front().t_s < t_s - length_s_) rows_.pop_front();
}

std::optional<double> MarkerHistory::marker_percent(std::size_t marker) const {
  return percent_of(rows_, [marker](const Row& row) { return row.markers[marker]; });
}

std::optional<double> MarkerHistory::segment_percent(ArmSegment segment) const {
  return percent_of(rows_, [segment](const Row& row) { return row.segments[index_of(segment)]; });
}

}  // namespace isograsp::gui
