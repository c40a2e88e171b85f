// SPDX-License-Identifier: GPL-3.0-or-later
// All sessions of a patient as they are stored, without the signals. Reading is for the worker.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::gui {

struct CourseTrial {
  storage::TrialRecord record;
  std::vector<Measure> measures;  ///< empty unless it was completed
};

struct CourseSession {
  int number = 0;  ///< 1 is the first session of this patient
  storage::SessionRecord record;
  std::vector<CourseTrial> trials;
};

struct PatientCourse {
  std::string code;
  std::vector<CourseSession> sessions;  ///< oldest first
  std::vector<storage::MeasurePoint>
      points;  ///< every measure of the completed trials, oldest first
};

/// Errors: bad_input for an unknown patient; whatever the database reports.
[[nodiscard]] Result<PatientCourse> read_course(storage::SessionStore& store,
                                                const std::string& code);

/// The trial is an assessment: completed, neither practice nor helped.
[[nodiscard]] bool is_assessment(const storage::TrialRecord& trial) noexcept;

/// The measure by which the trial is known at a glance; null: none.
[[nodiscard]] const Measure* key_measure(const CourseTrial& trial);
[[nodiscard]] const Measure* key_measure(const tasks::TaskSpec& task,
                                         const std::vector<Measure>& measures);

/// "SIMULATED", "RECORDED"; empty: measured by a device.
[[nodiscard]] QString source_mark(const storage::SessionRecord& session);
/// "1 trial", "7 trials".
[[nodiscard]] QString trials_words(int count);
/// "right hand".
[[nodiscard]] QString hand_words(std::optional<Hand> hand);  ///< nothing: both
/// "interrupted, kept, practice, helped": how it ended and what it does not count as.
[[nodiscard]] QString standing_words(const storage::TrialRecord& trial);

}  // namespace isograsp::gui
