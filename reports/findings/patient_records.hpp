// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is stored of one patient but signals, in the order of time. Results are in the
// versions of this program (renewed.hpp).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/progress.hpp"
#include "reports/findings/measure_series.hpp"

namespace isograsp::reports {

/// Which sessions of the patient a report is about, both counted from 1; no last: up to the newest.
struct ReportScope {
  int first = 1;
  std::optional<int> last = {};
  friend bool operator==(const ReportScope&, const ReportScope&) = default;
};

struct PatientRecords {
  storage::PatientRecord patient;
  storage::PatientProfile profile;
  std::vector<storage::PrimaryMeasure> primaries;
  std::vector<storage::SessionRecord> sessions;  ///< oldest first
  std::vector<ReportSession> shown;              ///< the same for the report
  std::vector<StoredTrial> trials;               ///< point into `sessions`; oldest first
  int first_number = 1;     ///< of the first of these sessions, among all that are stored
  int sessions_stored = 0;  ///< more, if only some were asked for
  /// Results that were computed again with a newer version, of so many trials, now or earlier
  /// (renewed.hpp); trials that were read and scored now for it; and trials that would have to be
  /// but whose signals cannot be read.
  int renewed_results = 0;
  int renewed_trials = 0;
  int scored_again = 0;
  int not_renewed_trials = 0;
};
/// Errors: bad_input for an unknown patient; failed, if the watcher wants to stop (asked between
/// sessions, with the share done); whatever the database reports. The thread of `store`.
[[nodiscard]] Result<PatientRecords> read_patient(storage::SessionStore& store,
                                                  const std::string& code,
                                                  const Progress& progress = {},
                                                  const ReportScope& scope = {});

/// The trials of each task and hand up to the newest one that counts. They point into `records`.
using TrialsOfTasks =
    std::map<std::pair<std::optional<Hand>, std::string>, std::vector<const StoredTrial*>>;
[[nodiscard]] TrialsOfTasks sort_by_task(const PatientRecords& records);

}  // namespace isograsp::reports
