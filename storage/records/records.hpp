// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the database as the program sees them: patients by code, sessions, zeros, trials,
// events, ratings, measures over time. Format: docs/file_formats.md.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure.hpp"
#include "hand/hands.hpp"

namespace isograsp::storage {

using RowId = std::int64_t;

/// Numbers that only some kinds of session know, by names that carry the unit: `maximum_force_N`.
using References = std::map<std::string, double, std::less<>>;
/// Nothing: not known.
[[nodiscard]] std::optional<double> value_of(const References& references, std::string_view name);
/// Nothing takes the name away.
void set_value(References& references, std::string_view name, std::optional<double> value);

struct PatientRecord {
  RowId id = 0;
  std::string code;
  std::string created_utc;  ///< ISO 8601
  std::string uuid{};       ///< the same in every file; empty: formats 1 to 5
  bool operator==(const PatientRecord&) const = default;
};

struct SensorRecord {
  std::string name;           ///< what it stands at or looks at
  std::string serial_number;  ///< empty: not told
  bool operator==(const SensorRecord&) const = default;
};

struct SessionRecord {
  RowId id = 0;
  RowId patient_id = 0;
  std::string started_utc;
  std::string ended_utc;                   ///< empty: not closed
  std::optional<Hand> hand = Hand::right;  ///< nothing: both of them
  std::string device_uri;
  std::string device_description;
  bool simulated = false;
  bool recorded = false;   ///< a replayed recording
  std::string provenance;  ///< where recorded data come from, one line each
  std::string protocol_name;
  std::string protocol_text;
  double rate_Hz = 100.0;
  double device_delay_s = 0.0;
  /// Of the patient's screen, as the answers of the session say it; nothing: not measured. Read
  /// only.
  std::optional<double> display_delay_s = std::nullopt;
  std::string software_version;
  std::string cpu_features;  ///< libm picks code by CPU: results carry it
  std::uint64_t seed = 0;
  std::vector<SensorRecord> sensors;  ///< in their order; empty: none told its serial number
  std::string operator_name;  ///< who runs the session, as they wish to be called; may be empty
  std::string realtime;       ///< what the acquisition thread was given; empty: not asked for
  std::optional<RowId> resumes_id;  ///< the interrupted session whose protocol goes on here
  std::string allowed;    ///< by the screening: "maximum", "comfortable", "none"; empty: not asked
  References references;  ///< "ceiling_N": no target exceeds it
  std::string calibration;  ///< how counts became values, one line a sensor; empty: no counts
  std::string uuid;         ///< the same in every file; given when it begins
  bool operator==(const SessionRecord&) const = default;
};

/// Something that was measured before trials and that they rest on (the zero of an empty device, a
/// still posture, the size of a hand), or beside one (the force at rest): mean and spread of
/// columns.
struct PreparationRecord {
  RowId id = 0;
  RowId session_id = 0;
  std::string kind;               ///< such as "instrument_zero"
  std::optional<RowId> trial_id;  ///< the trial that holds its signals
  double session_time_s = 0.0;
  std::string recorded_utc;   ///< ISO 8601
  std::string operator_name;  ///< who confirmed what it needs; may be empty
  std::optional<std::int64_t> samples = std::nullopt;  ///< nothing: not told
  std::vector<std::string> columns;                    ///< with units
  std::vector<double> mean;                            ///< of each column
  std::vector<double> sd;
  /// What it is compared with, and more: "change_N" from the last one of the same device in
  /// whichever session, "drift_N" from the one before in this session, "duration_s".
  References references;
  bool change_confirmed = false;  ///< too large a change: somebody said why it is right
  bool drifted = false;  ///< beyond the limit: what was measured since the one before is in doubt
  bool operator==(const PreparationRecord&) const = default;
};

enum class TrialStatus : std::uint8_t {
  running,  ///< being recorded
  completed,
  aborted,     ///< by the therapist; kept, marked
  interrupted  ///< the program ended while recording: whole up to the last full second
};
[[nodiscard]] std::string_view name_of(TrialStatus status) noexcept;

/// A group of columns that is stored together.
struct SignalGroup {
  std::string name;                  ///< "force", "raw", "object", "task", "timing"
  std::vector<std::string> columns;  ///< with units
  bool operator==(const SignalGroup&) const = default;
};

/// Where in a protocol a trial belongs.
struct TrialPlace {
  int step = 0;  ///< of the protocol
  int task = 0;  ///< of the step
  friend bool operator==(const TrialPlace&, const TrialPlace&) = default;
};

struct TrialRecord {
  RowId id = 0;
  RowId session_id = 0;
  int number = 0;  ///< 1, 2, … within the session
  std::string task_name;
  int task_version = 1;
  std::string task_text;   ///< the task file as it was
  std::string scene_text;  ///< empty: no object
  bool practice = false;
  double session_time_s = 0.0;  ///< when it began
  TrialStatus status = TrialStatus::running;
  /// What the task was given ("maximum_force_N") and, with the end, what the screen had
  /// ("visual_gain_deg_per_N": degrees of visual angle per newton).
  References references;
  std::vector<RowId> preparations;  ///< in force, by number
  std::int64_t samples = 0;
  std::int64_t dropped = 0;  ///< samples that could not be recorded: incomplete if not 0
  double worst_lateness_s = 0.0;
  double worst_compute_s = 0.0;
  std::string health_json;  ///< device counters at the end
  std::string timing_json;  ///< histograms of period, lateness and compute time
  /// What the next preparations of the same kinds showed since: "drift_N". Read only.
  References drift;
  bool drifted = false;    ///< beyond the limit: the signals of this trial are in doubt. Read only
  std::uint64_t seed = 0;  ///< of its sequences and waits; 0: not known (formats 1 and 2)
  /// Place in the protocol; nothing: chosen by hand.
  std::optional<TrialPlace> place = std::nullopt;
  bool helped = false;  ///< the therapist helped: no assessment, and no level follows from it
  /// Median age of what the patient's screen showed [s]; nothing: no screen, or not measured.
  std::optional<double> display_age_s = std::nullopt;
  std::optional<double> viewing_distance_m = std::nullopt;  ///< from the eyes to that screen
  std::vector<SignalGroup> groups;
  std::string uuid;  ///< the same in every file; given when it begins
  /// Of its signals (docs/file_formats.md), 64 hexadecimal digits; empty: still in blocks of a
  /// second.
  std::string signals_hash;
  bool operator==(const TrialRecord&) const = default;
};

/// What a trial that has ended gives when its stored signals are scored now.
struct ScoredTrial {
  RowId trial_id = 0;
  std::vector<Measure> measures;
};

/// EventRecord::kind of a number beside a rating.
inline constexpr const char* kShoulderPainEvent = "shoulder_pain";

/// … and of what a rating was before it was corrected, with what it became.
inline constexpr const char* kCorrectionEvent = "correction";

struct EventRecord {
  std::optional<RowId> trial_id;  ///< nothing: of the session
  double session_time_s = 0.0;
  std::string kind;  ///< "fault", "pause", "resume", "abort", "note"
  std::string text;
  bool operator==(const EventRecord&) const = default;
};

/// Where an event belongs, in words that are the same in every file.
struct EventPlace {
  std::string patient_code;
  std::string session_uuid;
  std::string trial_uuid{};  ///< empty: of the session
};

/// What the patient says after a block of work, 0 (none) to 10.
struct RatingRecord {
  RowId id = 0;
  RowId session_id = 0;
  std::optional<RowId> trial_id;  ///< the last one before
  double session_time_s = 0.0;
  std::string recorded_utc;
  int effort = 0;
  int pain = 0;
  /// Of a tracked hand, which is carried to its targets; nothing: not asked. Kept as an event of
  /// the session at the same time, kShoulderPainEvent.
  std::optional<int> shoulder_pain = std::nullopt;
  bool operator==(const RatingRecord&) const = default;
};

/// One row of a progress plot.
struct MeasurePoint {
  RowId session_id = 0;
  RowId trial_id = 0;
  int trial_number = 0;
  std::string started_utc;
  std::optional<Hand> hand = Hand::right;  ///< nothing: both
  bool practice = false;
  bool helped = false;
  bool simulated = false;
  std::string task_name;
  int task_version = 1;
  Measure measure;
};

}  // namespace isograsp::storage
