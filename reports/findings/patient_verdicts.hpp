// SPDX-License-Identifier: GPL-3.0-or-later
// The verdicts of one patient without the rest of the report: no signals are read. SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::reports {

struct PatientVerdict {
  storage::PrimaryMeasure primary;
  std::string unit;  ///< empty where nothing was assessed
  Source source = Source::device;
  int task_version = 1;
  std::vector<double> values;  ///< means of the sessions that have one, oldest first
  /// Nothing: no assessment yet.
  std::optional<ChangeVerdict> verdict;
};
/// In the order in which the primary measures were chosen; the same as in the report. Errors:
/// bad_input for an unknown patient; whatever the database reports. The thread of `store`.
[[nodiscard]] Result<std::vector<PatientVerdict>> gather_verdicts(storage::SessionStore& store,
                                                                  const std::string& code);

/// What can be made a primary measure of this patient: measures that the report draws and of which
/// more is better or worse, of every task and hand so far. Key measures come first.
[[nodiscard]] Result<std::vector<storage::PrimaryMeasure>> primary_choices(
    storage::SessionStore& store, const std::string& code);

}  // namespace isograsp::reports
