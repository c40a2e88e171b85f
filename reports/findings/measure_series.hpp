// SPDX-License-Identifier: GPL-3.0-or-later
// One measure over the sessions of a patient: which trials stand in it, its baseline and change.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

/// One trial with all that decides whether it may be compared with another.
struct StoredTrial {
  std::size_t session = 0;
  const storage::SessionRecord* session_record = nullptr;
  storage::TrialRecord trial;
  std::vector<Measure> measures;
};

/// The assessments of a series: one for each day, oldest first. Days on which no value could be
/// computed are left out, but for the newest; days on which a censored time did not come are
/// failed.
[[nodiscard]] std::vector<AssessmentDay> assessment_days(
    const MeasureSeries& series, const std::vector<ReportSession>& sessions);

/// "1, 2, 5": their numbers; `which` are indices into `sessions`.
[[nodiscard]] std::string session_numbers(const std::set<std::size_t>& which,
                                          const std::vector<ReportSession>& sessions);

/// The series of the measure `like` over `entries`, oldest first. What has another version or unit
/// is left out and named in the notes of `section`.
[[nodiscard]] MeasureSeries make_series(const Measure& like,
                                        const std::vector<const StoredTrial*>& entries,
                                        const std::vector<ReportSession>& sessions,
                                        TaskSection& section);

}  // namespace isograsp::reports
