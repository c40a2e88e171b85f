// SPDX-License-Identifier: GPL-3.0-or-later
// The values of a study, read from the clinic's records: one per person and condition, and why one
// is missing. People carry the number of their place in the study file, never their code.
#pragma once

#include <string>
#include <vector>

#include "core/progress.hpp"
#include "core/text.hpp"
#include "reports/study/study_file.hpp"
#include "statistics/subject_table.hpp"

namespace isograsp::storage {
class SessionStore;
}

namespace isograsp::reports {

/// What a value is the mean of; without trials: why there is no value.
struct StudyCell {
  std::optional<double> value;  ///< mean over the sessions of their means over trials
  int sessions = 0;
  int trials = 0;
  Text reason;
};

struct StudyGroupData {
  std::string name;
  std::vector<std::string> subjects;          ///< "S01", counted through all groups
  std::vector<std::vector<StudyCell>> cells;  ///< [subject][condition]
  /// The values; NaN: none.
  [[nodiscard]] statistics::SubjectTable table() const;
};

struct StudyData {
  std::string unit;
  int measure_version = 1;
  std::vector<StudyGroupData> groups;
  /// How the values came about where they are not from sessions of a clinic; empty: they are.
  std::vector<Text> design;
  std::vector<Text> left_out;  ///< trials that do not count, how many and why
  /// What was computed again of these people, of all measures (renewed.hpp); empty: nothing.
  Text renewed;
};

/// Reads what `study` asks for. Of the trials of a task those count which may be compared with each
/// other (reports/findings/comparable.hpp); where there are several such sets, the one of most
/// people. Errors: bad_input for an unknown patient, for a trial that stands in two conditions, if
/// nobody has a value, if conditions have different units; failed if the watcher wants to stop;
/// whatever the database reports. `file`: of the study, for errors.
[[nodiscard]] Result<StudyData> gather_study(storage::SessionStore& store, const Study& study,
                                             const std::string& file,
                                             const Progress& progress = {});

}  // namespace isograsp::reports
