// SPDX-License-Identifier: GPL-3.0-or-later
// A patient's stored measures, sorted into series that may be looked at together.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// One measure of one task (of one version) and hand over all trials, oldest first. Simulated and
/// real trials are never in one series.
struct HistorySeries {
  QString title;  ///< "Grip force, sine (right): Tracking error, relative"
  QString unit;   ///< as printed
  std::vector<storage::MeasurePoint> points;
};

/// In the order of the newest task first, its key measures first.
[[nodiscard]] std::vector<HistorySeries> sort_history(
    const std::vector<storage::MeasurePoint>& points);

/// What an earlier trial must equal to be set beside a trial of this session.
struct TrialLike {
  storage::RowId session_id = 0;
  std::string task_name;
  int task_version = 1;
  std::optional<Hand> hand;  ///< nothing: both
  bool simulated = false;
};
/// The measure in the newest trial of an earlier session, neither practice nor helped; null: there
/// is none.
[[nodiscard]] const storage::MeasurePoint* last_time(const std::vector<HistorySeries>& history,
                                                     const TrialLike& like, const Measure& measure);

}  // namespace isograsp::gui
