// SPDX-License-Identifier: GPL-3.0-or-later
// Which of a patient's measures are worth a small picture over the sessions, and its points.
#pragma once

#include <QString>
#include <map>
#include <vector>

#include "gui/clinic/patient_course.hpp"
#include "reports/findings/patient_verdicts.hpp"

namespace isograsp::gui {

struct MeasureTrend {
  enum class Kind : std::uint8_t { assessed, practised, helped };
  struct Point {
    int session = 0;  ///< CourseSession::number
    int trial = 0;    ///< of the session
    Kind kind = Kind::assessed;
    double value = 0.0;  ///< in the printed unit
  };
  struct Mean {
    int session = 0;
    double value = 0.0;  ///< of the assessments of this session, printed unit
    int trials = 0;
  };
  QString title;   ///< "Tracking error, relative"
  QString task;    ///< "Grip force, sine · right hand"; begins with "SIMULATED" where it was
  QString unit;    ///< as printed
  QString last;    ///< newest value with its unit; a dash if there is none
  QString remark;  ///< verdict of change of a primary measure; empty: it is none
  /// Task, hand and measure, as a primary measure would name them.
  storage::PrimaryMeasure source;
  int task_version = 1;
  bool key = false;
  bool simulated = false;
  /// The trials differ in parameters, level or object; `task` says so. A change of the value may
  /// then come from the task instead of the patient.
  bool mixed = false;
  std::vector<Point> points;     ///< trials with a value, oldest first
  std::vector<Mean> means;       ///< sessions with an assessment, oldest first
  int without = 0;               ///< trials that have no value
  std::map<int, QString> dates;  ///< of the sessions that have a point, local
};

/// Key measures of all tasks first, then the others that the report draws; within these the task
/// of the newest trial first. Practice, helped trials and simulations are marked, never mixed in.
[[nodiscard]] std::vector<MeasureTrend> choose_trends(const PatientCourse& course);

/// "Improved (confirmed) · MDC95 2.1 N", "Cannot be judged yet: the baseline needs …".
[[nodiscard]] QString verdict_line(const reports::PatientVerdict& verdict);
/// Gives each verdict to the trend that it is about, and puts these trends first.
void add_verdicts(std::vector<MeasureTrend>& trends,
                  const std::vector<reports::PatientVerdict>& verdicts);

}  // namespace isograsp::gui
