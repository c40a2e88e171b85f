// SPDX-License-Identifier: GPL-3.0-or-later
// How much was practised, week by week: active minutes, repetitions, and what the patient said of
// effort, pain and, where it was asked, shoulder pain. SI units.
#pragma once

#include <optional>
#include <vector>

#include "core/result.hpp"

namespace isograsp::storage {
class SessionStore;
}

namespace isograsp::reports {

struct PatientRecords;

struct DoseWeek {
  int week = 1;  ///< 1 begins with the patient's first session
  int sessions = 0;
  double active_s = 0.0;  ///< of all trials, practice and unfinished ones included
  int repetitions = 0;    ///< of completed trials
  std::optional<int> most_effort = std::nullopt;  ///< 0 … 10, of all ratings of the week
  std::optional<int> most_pain = std::nullopt;
  std::optional<int> most_shoulder_pain = std::nullopt;
};
struct PracticeDose {
  std::vector<DoseWeek> weeks;  ///< without gaps, oldest first
  int days = 0;                 ///< with a session
  double active_s = 0.0;
  int repetitions = 0;
};
/// Errors: whatever the database reports.
[[nodiscard]] Result<PracticeDose> dose_of(storage::SessionStore& store,
                                           const PatientRecords& records);

}  // namespace isograsp::reports
