// SPDX-License-Identifier: GPL-3.0-or-later
// Two sessions of a patient side by side; only comparable trials are compared.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "gui/clinic/patient_course.hpp"

namespace isograsp::gui {

/// A measure in one session: the mean over its assessments.
struct SessionMean {
  std::optional<double> value;  ///< in the stored unit
  int trials = 0;               ///< that have a value
  int without = 0;              ///< assessments whose measure has no value
  QString reason;               ///< why there is no mean
};

struct ComparedMeasure {
  QString task;   ///< "Grip force, sine"
  QString title;  ///< "Tracking error, relative"
  std::string unit;
  bool key = false;    ///< among the key measures of its task
  bool drawn = false;  ///< among those that the report draws
  SessionMean a;
  SessionMean b;
  std::optional<double> difference;  ///< b - a
};

struct SessionComparison {
  std::vector<ComparedMeasure> rows;  ///< tasks in the order of b, their key measures first
  std::vector<QString> left_out;  ///< what was done in both and is not compared, with the reason
};

/// Compared are assessments (completed, neither practice nor helped) of the same task, version and
/// parameters, by the same version of a measure. Sessions of different hands or sources, or with
/// another frame rate or device delay, have nothing to compare. A measure that counts how long
/// something took has no mean if a trial ended without it: a mean of the others would hide the
/// failure.
[[nodiscard]] SessionComparison compare_sessions(const CourseSession& a, const CourseSession& b);

}  // namespace isograsp::gui
