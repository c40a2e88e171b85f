// SPDX-License-Identifier: GPL-3.0-or-later
// What a progress report says, before anybody decides how it looks: PDF and HTML are written from
// the same content. SI units, radians; times of day in UTC.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/finger.hpp"
#include "core/measure.hpp"
#include "core/signals.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp {

/// Where forces came from. Results of different sources are never compared.
enum class Source : std::uint8_t { device, simulated, recorded };
[[nodiscard]] std::string_view name_of(Source source) noexcept;

struct ReportSession {
  int number = 0;    ///< 1 is the first session of this patient
  std::string date;  ///< YYYY-MM-DD
  int day = 0;       ///< days since the first session
  Hand hand = Hand::right;
  Source source = Source::device;
  std::string device;      ///< in words
  std::string provenance;  ///< of a recording; one line each
};

/// All completed trials of one session, practice and helped ones left out.
struct SessionValue {
  std::size_t session = 0;     ///< index into ReportContent::sessions
  std::vector<double> trials;  ///< in the order of the trials
  int without_value = 0;       ///< trials whose measure could not be computed
  std::optional<double> mean;  ///< none if a trial has no value: failures must not drop out of it
  bool first_day = false;      ///< the first assessment day of the task: drawn hollow
};

/// One measure over the sessions; all values have the same task parameters and measure version.
struct MeasureSeries {
  std::string name;  ///< as stored
  std::string channel;
  std::string unit;
  int version = 1;
  bool primary = false;  ///< receives a verdict; at most four per patient
  bool key = false;      ///< stands in the table at a glance
  std::vector<SessionValue> values;
  std::optional<double> baseline;
  std::string baseline_basis;  ///< what the baseline is the mean of
  std::optional<double> last;  ///< mean of the last session with a mean
  std::optional<double> change;
  std::string verdict;  ///< empty: shown without
};

/// The newest completed trial of a task, with what is needed to draw it.
struct LastTrial {
  std::size_t session = 0;
  int number = 0;
  Signals curves;                 ///< t_s, phase, target_* and actual_*
  std::vector<Measure> measures;  ///< as stored
  std::string problem;            ///< why the signals cannot be shown
};

/// One task with one hand: sessions that may be compared with each other.
struct TaskSection {
  std::string task;
  int version = 1;
  Hand hand = Hand::right;
  Source source = Source::device;
  std::optional<TaskSpec> spec;  ///< none: the stored task file cannot be read
  std::vector<MeasureSeries> series;
  std::optional<LastTrial> last;
  std::vector<std::string> notes;  ///< what was left out and why
};

struct QualityLine {
  std::string label;
  std::string text;
  bool attention = false;  ///< limits what the results mean
};

struct ReportContent {
  std::string code;
  std::string software_version;
  std::vector<ReportSession> sessions;  ///< oldest first
  std::vector<TaskSection> sections;
  std::vector<QualityLine> quality;  ///< of the last session
  bool simulated = false;            ///< any session is
  bool recorded = false;
};

}  // namespace isograsp
