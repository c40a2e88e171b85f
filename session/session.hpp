// SPDX-License-Identifier: GPL-3.0-or-later
// One session of one patient with one device: zero, trials, pauses, faults, recording.
//
// Threads: the owner (GUI or command line) calls the functions below; two threads of the session
// acquire and record. With a virtual clock there are no threads: wait_for_news() and let_pass()
// drive everything, deterministically. Commands return at once; what came of them arrives as news.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "session/snapshot.hpp"
#include "storage/session_store.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp {

struct SessionConfig {
  std::string database;  ///< path
  bool create_database =
      false;                 ///< make the file if it is absent; nothing is made if the device fails
  std::string patient_code;  ///< created in the database if new
  Hand hand = Hand::right;
  std::string device_uri;
  std::string library;        ///< folder with scenes/ and tasks/
  std::string protocol_name;  ///< for the record; may be empty
  std::string protocol_text;
  std::string software_version;
  std::string started_utc;    ///< ISO 8601; empty: now (demonstration data lie in the past)
  bool virtual_time = false;  ///< simulated and replayed devices only
};

/// The instrument zero ended.
struct ZeroOutcome {
  bool accepted = false;
  std::string reason;  ///< why not, in words for the therapist
  InstrumentZeroRecord zero;
};

/// A trial ended and is durable.
struct TrialOutcome {
  TrialRecord trial;
  std::vector<Measure> measures;
  std::string reason;  ///< why it was not completed
};

/// What happened since the owner looked last; exactly one of the members is set.
struct SessionNews {
  std::optional<ZeroOutcome> zero;
  std::optional<TrialOutcome> trial;
  std::optional<std::string> fault;    ///< the running trial was paused by the device: why
  std::optional<std::string> failure;  ///< recording or device failed: the session cannot go on
};

class Session {
 public:
  /// Opens device and database, writes the session's record and starts to stream.
  [[nodiscard]] static Result<std::unique_ptr<Session>> open(const SessionConfig& config);
  ~Session();  ///< close()
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  [[nodiscard]] const DeviceInfo& device() const noexcept;
  [[nodiscard]] const SessionRecord& record() const noexcept;
  /// The code was not in the database before this session.
  [[nodiscard]] bool patient_is_new() const noexcept;
  /// Newest state. Wait-free. Owner thread.
  [[nodiscard]] const Snapshot& snapshot() noexcept;
  /// Measures of the running trial so far, by the same functions as at its end; renewed every
  /// second.
  [[nodiscard]] std::vector<Measure> live_score() const;

  /// Instrument zero: the operator confirms that the device is empty. News: ZeroOutcome.
  [[nodiscard]] Result<void> start_zero();
  /// Prepares and starts a trial. Fails if one is running or the task lacks its context (maximum).
  /// News: TrialOutcome.
  [[nodiscard]] Result<void> start_trial(const TaskSpec& spec, bool practice);
  /// The trial stands still until resume(); task clock and object freeze, recording goes on.
  void pause();
  void resume();
  /// Ends the trial; it is kept and marked aborted. `reason` is static text, stored with it.
  void abort(const char* reason = "Stopped by the therapist.");
  /// A remark at this moment of the session, stored with it.
  void note(const std::string& text);

  /// Context for tasks from this session's trials so far [N]; 0: not measured yet.
  [[nodiscard]] double maximum_force_N() const noexcept;
  [[nodiscard]] double resting_force_N() const noexcept;

  /// News since the last call, without waiting.
  [[nodiscard]] std::vector<SessionNews> take_news();
  /// Waits for news; in virtual time this is what makes time pass. Empty only if the device
  /// finished while nothing was running.
  [[nodiscard]] std::vector<SessionNews> wait_for_news();

  /// Lets time pass while nothing is asked (rests between trials).
  void let_pass(double duration_s);

  /// Ends a running trial as aborted, writes all that is pending and closes the session's record.
  void close();

 private:
  struct Parts;
  explicit Session(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Finds NAME(.toml) beside `beside` (a file; may be empty) or in LIBRARY/FOLDER and returns its
/// path.
[[nodiscard]] Result<std::string> find_in_library(const std::string& library,
                                                  const std::string& folder,
                                                  const std::string& name,
                                                  const std::string& beside = "");

}  // namespace isograsp
