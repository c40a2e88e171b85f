// SPDX-License-Identifier: GPL-3.0-or-later
// The clinic's memory: patients by code, sessions, trials with their signals in blocks of one
// second, measures, events. One SQLite file (WAL, synchronous=FULL); format: docs/file_formats.md.
// A store is used by one thread at a time; several stores may be open on one file.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/finger.hpp"
#include "core/measure.hpp"
#include "core/result.hpp"
#include "core/signals.hpp"

namespace isograsp {

using RowId = std::int64_t;

/// Format of the files that this program writes (PRAGMA user_version).
inline constexpr int kDatabaseFormat = 3;

/// Patients are codes: letters, digits and '-', 2 to 32 characters, with at least one digit (a code
/// is generated; names, initials and dates are refused).
[[nodiscard]] Result<void> check_patient_code(const std::string& code);

struct PatientRecord {
  RowId id = 0;
  std::string code;
  std::string created_utc;  ///< ISO 8601
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
  std::string software_version;
  std::string cpu_features;  ///< libm picks code by CPU: results carry it
  std::uint64_t seed = 0;
  std::array<std::string, kFingerCount> serial_numbers;  ///< of the sensors; empty: not told
  std::string operator_name;  ///< who runs the session, as they wish to be called; may be empty
  std::string realtime;       ///< what the acquisition thread was given; empty: not asked for
  RowId resumes_id = 0;       ///< the interrupted session whose protocol goes on here; 0: none
  std::string allowed;  ///< by the screening: "maximum", "comfortable", "none"; empty: not asked
  std::optional<double> ceiling_N = std::nullopt;  ///< no target exceeds it
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
  std::vector<SignalGroup> groups;
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

class SessionStore {
 public:
  enum class Open { create, scratch, existing, read_only };
  /// create: makes the file if absent. A file that is not ours, newer than this program (unless
  /// read_only) or not writable is refused with the reason. Trials left running by a program that
  /// ended are marked interrupted, unless read_only or another program has the file open.
  /// scratch: like create, but nothing waits for the disk. For files that are removed by who made
  /// them; after a power cut they may be damaged.
  [[nodiscard]] static Result<std::unique_ptr<SessionStore>> open(const std::string& path,
                                                                  Open how);
  struct Migration {
    int from = kDatabaseFormat;  ///< format that the file had
    std::string copy;            ///< of the file as it was; empty: nothing was to be done
  };
  /// Brings a file to the format of this program, in one transaction, after a checked copy beside
  /// it was made. Refused while somebody records into the file.
  [[nodiscard]] static Result<Migration> migrate(const std::string& path);
  /// For reading: like `existing` where the file can be written, so that trials left running are
  /// marked; else read_only. Files of older formats are read as they are.
  [[nodiscard]] static Result<std::unique_ptr<SessionStore>> open_to_read(const std::string& path);
  virtual ~SessionStore() = default;

  [[nodiscard]] virtual const std::string& path() const noexcept = 0;

  // Writing. Each call is one transaction, durable when it returns (not in a scratch file).
  /// `created_utc`, `ended_utc`: ISO 8601; empty: now.
  [[nodiscard]] virtual Result<PatientRecord> add_patient(const std::string& code,
                                                          const std::string& created_utc = "") = 0;
  [[nodiscard]] virtual Result<RowId> begin_session(const SessionRecord& session) = 0;
  [[nodiscard]] virtual Result<void> end_session(RowId session,
                                                 const std::string& ended_utc = "") = 0;
  /// Its drift, if it has one, goes to all trials of the session since the zero before it.
  [[nodiscard]] virtual Result<RowId> add_zero(const InstrumentZeroRecord& zero) = 0;
  [[nodiscard]] virtual Result<RowId> add_resting_force(const RestingForceRecord& rest) = 0;
  /// Uses all fields but id, status, samples, dropped, worst_*, zero_drift* and *_json.
  [[nodiscard]] virtual Result<RowId> begin_trial(const TrialRecord& trial) = 0;
  /// Second number `second` of all groups at once; rows[g] is row-major, columns of group g. Blocks
  /// come in order; all but the last hold rate * 1 s rows.
  [[nodiscard]] virtual Result<void> append_blocks(RowId trial, int second,
                                                   std::span<const std::vector<double>> rows) = 0;
  /// Closes a trial: status, counters, health and timing of `end`, and its measures.
  [[nodiscard]] virtual Result<void> end_trial(const TrialRecord& end,
                                               std::span<const Measure> measures) = 0;
  [[nodiscard]] virtual Result<void> add_event(RowId session, const EventRecord& event) = 0;
  [[nodiscard]] virtual Result<RowId> add_rating(const RatingRecord& rating) = 0;
  /// Of a trial that has ended.
  [[nodiscard]] virtual Result<void> mark_helped(RowId trial, bool helped) = 0;

  // Reading.
  [[nodiscard]] virtual Result<std::vector<PatientRecord>> patients() = 0;
  [[nodiscard]] virtual Result<std::optional<PatientRecord>> find_patient(
      const std::string& code) = 0;
  [[nodiscard]] virtual Result<std::vector<SessionRecord>> sessions(RowId patient) = 0;
  [[nodiscard]] virtual Result<std::vector<TrialRecord>> trials(RowId session) = 0;
  [[nodiscard]] virtual Result<std::vector<Measure>> measures(RowId trial) = 0;
  [[nodiscard]] virtual Result<std::vector<EventRecord>> events(RowId session) = 0;
  [[nodiscard]] virtual Result<std::vector<InstrumentZeroRecord>> zeros(RowId session) = 0;
  /// The newest empty zero of the device of `session`, whichever session it was made in: same
  /// serial numbers, or same URI where not all sensors tell theirs. Simulated and real devices are
  /// never the same.
  [[nodiscard]] virtual Result<std::optional<InstrumentZeroRecord>> last_zero(
      const SessionRecord& session) = 0;
  [[nodiscard]] virtual Result<std::vector<RestingForceRecord>> resting_forces(RowId session) = 0;
  [[nodiscard]] virtual Result<std::vector<RatingRecord>> ratings(RowId session) = 0;
  /// All groups of a trial side by side, in the order of trial.groups. Fails on a damaged block,
  /// naming it.
  [[nodiscard]] virtual Result<Signals> signals(const TrialRecord& trial) = 0;
  /// Every measure of a patient's completed trials, oldest first.
  [[nodiscard]] virtual Result<std::vector<MeasurePoint>> progress(RowId patient) = 0;

  /// Adds all that another file of the same format holds, in its order, behind what is here.
  /// Refused, and nothing is added, if a patient of it has a code that is here already.
  [[nodiscard]] virtual Result<void> absorb(const std::string& other) = 0;

  // Care.
  /// integrity_check, foreign keys, every block readable. The list of problems; empty: sound.
  [[nodiscard]] virtual Result<std::vector<std::string>> check() = 0;
  /// Online copy into a new file, then checked.
  [[nodiscard]] virtual Result<void> backup(const std::string& to) = 0;
};

}  // namespace isograsp
