// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the database as the program sees them: patients by code, sessions, zeros, trials,
// events, ratings, measures over time. Format: docs/file_formats.md.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure.hpp"
#include "hand/finger.hpp"

namespace isograsp::storage {

using RowId = std::int64_t;

struct PatientRecord {
  RowId id = 0;
  std::string code;
  std::string created_utc;  ///< ISO 8601
  std::string uuid{};       ///< the same in every file; empty: formats 1 to 5
};

struct SessionRecord {
  RowId id = 0;
  RowId patient_id = 0;
  std::string started_utc;
  std::string ended_utc;  ///< empty: not closed
  Hand hand = Hand::right;
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
  std::array<std::string, kFingerCount> serial_numbers;  ///< of the sensors; empty: not told
  std::string operator_name;  ///< who runs the session, as they wish to be called; may be empty
  std::string realtime;       ///< what the acquisition thread was given; empty: not asked for
  RowId resumes_id = 0;       ///< the interrupted session whose protocol goes on here; 0: none
  std::string allowed;  ///< by the screening: "maximum", "comfortable", "none"; empty: not asked
  std::optional<double> ceiling_N = std::nullopt;  ///< no target exceeds it
  std::string calibration;  ///< how counts became forces, one line a finger; empty: no counts
  std::string uuid;         ///< the same in every file; given when it begins
};

/// Device empty, one second quiet: mean and SD per finger and axis.
struct InstrumentZeroRecord {
  RowId id = 0;
  RowId session_id = 0;
  double session_time_s = 0.0;
  std::array<Vec6, kFingerCount> mean;  ///< [N, N m]
  std::array<Vec6, kFingerCount> sd;    ///< [N, N m]: the empty noise
  std::string recorded_utc;             ///< ISO 8601
  std::string operator_name;            ///< who confirmed that the device is empty; may be empty
  /// Largest force component by which it differs from the last empty zero of the same device, in
  /// whichever session; nothing: there was none.
  std::optional<double> change_N = std::nullopt;
  bool change_confirmed = false;  ///< beyond the band: somebody said "serviced or remounted"
  /// The same from the zero before it in this session; nothing: it is the first.
  std::optional<double> drift_N = std::nullopt;
  bool drifted = false;  ///< beyond the limit; kept with the trials between the two
};

/// Hand in, relaxed: what each finger presses. Never subtracted from anything.
struct RestingForceRecord {
  RowId id = 0;
  RowId session_id = 0;
  RowId trial_id = 0;  ///< its signals
  double session_time_s = 0.0;
  std::string recorded_utc;
  std::string operator_name;
  double duration_s = 0.0;
  std::optional<double> since_strapping_s = std::nullopt;  ///< nothing: not known
  std::int64_t samples = 0;
  std::array<Vec6, kFingerCount> mean;  ///< [N, N m]
  std::array<Vec6, kFingerCount> sd;    ///< [N, N m]
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
  double maximum_force_N = 0.0;  ///< context given to the task; 0: none
  double resting_force_N = 0.0;
  RowId zero_id = 0;  ///< instrument zero in force; 0: none
  std::int64_t samples = 0;
  std::int64_t dropped = 0;  ///< samples that could not be recorded: incomplete if not 0
  double worst_lateness_s = 0.0;
  double worst_compute_s = 0.0;
  std::string health_json;  ///< device counters at the end
  std::string timing_json;  ///< histograms of period, lateness and compute time
  /// Contact thresholds that the object was moved with; nothing: no contact of that finger.
  std::array<std::optional<double>, kFingerCount> threshold_N{};
  /// Drift from the zero in force to the next empty zero; nothing: no zero followed.
  std::optional<double> zero_drift_N = std::nullopt;
  bool zero_drifted = false;  ///< beyond the limit: the forces of this trial are in doubt
  std::uint64_t seed = 0;     ///< of its sequences and waits; 0: not known (formats 1 and 2)
  /// Place in the protocol; nothing: chosen by hand.
  std::optional<TrialPlace> place = std::nullopt;
  bool helped = false;  ///< the therapist helped: no assessment, and no level follows from it
  /// Median age of what the patient's screen showed [s]; nothing: no screen, or not measured.
  std::optional<double> display_age_s = std::nullopt;
  /// Visual gain that the screen had: degrees of visual angle per newton; nothing: no force shown.
  std::optional<double> visual_gain_deg_per_N = std::nullopt;
  std::optional<double> viewing_distance_m = std::nullopt;  ///< for that angle
  std::vector<SignalGroup> groups;
  std::string uuid;  ///< the same in every file; given when it begins
  /// Of its signals (docs/file_formats.md), 64 hexadecimal digits; empty: still in blocks of a
  /// second.
  std::string signals_hash;
};

/// What a trial that has ended gives when its stored signals are scored now.
struct ScoredTrial {
  RowId trial_id = 0;
  std::vector<Measure> measures;
};

struct EventRecord {
  RowId trial_id = 0;  ///< 0: of the session
  double session_time_s = 0.0;
  std::string kind;  ///< "fault", "pause", "resume", "abort", "note"
  std::string text;
};

/// What the patient says after a block of work, 0 (none) to 10.
struct RatingRecord {
  RowId id = 0;
  RowId session_id = 0;
  RowId trial_id = 0;  ///< the last one before; 0: none
  double session_time_s = 0.0;
  std::string recorded_utc;
  int effort = 0;
  int pain = 0;
};

/// One row of a progress plot.
struct MeasurePoint {
  RowId session_id = 0;
  RowId trial_id = 0;
  int trial_number = 0;
  std::string started_utc;
  Hand hand = Hand::right;
  bool practice = false;
  bool helped = false;
  bool simulated = false;
  std::string task_name;
  int task_version = 1;
  Measure measure;
};

}  // namespace isograsp::storage
