// SPDX-License-Identifier: GPL-3.0-or-later
// One session of one patient with one device: zero, trials, pauses, faults, recording.
//
// Threads: the owner (GUI or command line) calls the functions below; two threads of the session
// acquire and record. With a virtual clock there are no threads: wait_for_news() and let_pass()
// drive everything, deterministically. Commands return at once; what came of them arrives as news.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/measure.hpp"
#include "core/result.hpp"
#include "session/acquisition/realtime.hpp"
#include "session/library/library.hpp"
#include "session/open_apparatus.hpp"
#include "session/platform/snapshot.hpp"
#include "session/platform/stored_preparations.hpp"
#include "session/resting.hpp"
#include "session/session_knowledge.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/references.hpp"
#include "tasks/task.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

struct HandSnapshot;          // session/tracked_hand/hand_snapshot.hpp
struct TwoPlatformsSnapshot;  // session/two_platforms/two_platforms_snapshot.hpp

/// What glibc's libm may choose its code by; stored beside results (docs/storage.md).
[[nodiscard]] std::string cpu_features();

struct SessionConfig {
  std::string database;  ///< path
  bool create_database =
      false;                 ///< make the file if it is absent; nothing is made if the device fails
  std::string patient_code;  ///< created in the database if new
  std::optional<Hand> hand = Hand::right;  ///< nothing: both, each on a platform
  std::string device_uri;                  ///< of both hands: two_platforms_uri()
  /// Which apparatus the tasks need ("platform"); a device that is another one is refused. Empty:
  /// any.
  std::string apparatus;
  std::string library;        ///< folder with scenes/ and tasks/
  std::string protocol_name;  ///< for the record; may be empty
  std::string protocol_text;
  std::string software_version;
  std::string started_utc;    ///< ISO 8601; empty: now (demonstration data lie in the past)
  std::string operator_name;  ///< who runs it; stored with zero and resting force; may be empty
  Realtime realtime = Realtime::prefer;  ///< of the acquisition thread; not in virtual time
  std::optional<tasks::Effort>
      allowed;                      ///< outcome of the screening for this hand; nothing: not asked
  std::optional<double> ceiling_N;  ///< no target may exceed it
  /// Of both hands: the affected side of a person of whom the database does not say it; refused
  /// where it says another one.
  std::optional<Hand> affected;
  OfHands<std::optional<double>> ceilings_N;    ///< of both hands: no target may ask one for more
  std::vector<storage::SessionAnswer> answers;  ///< what was asked before: screening, posture
  double settle_after_strapping_s = kSettleAfterStrapping_s;  ///< before a resting force
  std::optional<double> display_delay_s;  ///< of the patient's screen; nothing: not measured
  /// The clock of this computer may be behind the newest session of the file: somebody was asked
  /// and says that it is right. Without it such a session is refused (field "clock").
  bool clock_is_right = false;
  /// What a device URI opens; others in tests.
  std::span<const ApparatusRow> apparatuses = all_apparatuses();
  /// Set by somebody who wants the session to end: waiting ends at once, and what is closed then is
  /// closed in good order. May be null; outlives the session.
  const std::atomic<bool>* stop = nullptr;
  /// Goes on with the protocol that the patient's newest session with this hand has not finished.
  /// Refused if there is none, or if it began more than kLongestBreak_s ago. What its screening
  /// said holds on where `allowed`, `ceiling_N` or the passive ranges of `answers` say nothing.
  bool resume = false;
  bool virtual_time = false;  ///< simulated and replayed devices only
  /// The database is made for a moment and removed again (OpenMode::scratch); in virtual
  /// time only: nobody's data are recorded so.
  bool scratch_database = false;
};

/// What each finger pressed at rest, and what that suggests.
struct RestOutcome {
  RestRecord rest;
  Text words;
};

/// A trial ended and is durable.
struct TrialOutcome {
  storage::TrialRecord trial;
  std::vector<Measure> measures;
  Text reason;                                     ///< why it was not completed
  std::optional<RestOutcome> rest = std::nullopt;  ///< of a completed resting-force trial
  double worked_s = 0.0;                           ///< on the task's clock: without pauses
};

/// What the patient's screen showed in the running trial, as far as it is known.
struct ScreenShown {
  std::optional<double> age_s;  ///< median age of the pictures when they appeared
  std::optional<double> gain_deg_per_N;
  std::optional<double> distance_m;  ///< from the eyes to the screen
};

/// What happened since the owner looked last; exactly one of the members is set.
struct SessionNews {
  std::optional<PreparationOutcome> prepared;
  std::optional<TrialOutcome> trial;
  std::optional<Text> fault;     ///< the running trial was paused by the device: why
  std::optional<Error> failure;  ///< recording or device failed: the session cannot go on
};

class Session {
 public:
  /// Opens and starts the device, opens the database and writes the session's record: if a sensor
  /// does not answer, nothing is written.
  [[nodiscard]] static Result<std::unique_ptr<Session>> open(const SessionConfig& config);
  ~Session();  ///< close()
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// What is known so far; take_news() and wait_for_news() add to it. Owner thread.
  [[nodiscard]] const SessionKnowledge& known() const noexcept;
  /// Newest state, whatever is measured. Wait-free. Owner thread.
  [[nodiscard]] const Moment& moment() noexcept;
  /// The same with all that the platform shows; of another apparatus the moment alone, as the
  /// patient's screen says it. Where no zero is asked for, none is missing.
  [[nodiscard]] const Snapshot& snapshot() noexcept;
  /// Measures of the running trial so far, by the same functions as at its end; renewed every
  /// second.
  [[nodiscard]] std::vector<Measure> live_score() const;

  /// Instrument zero, or what the apparatus has in its place. Refused without the confirmation that
  /// the device is empty. News: PreparationOutcome.
  [[nodiscard]] Result<void> start_zero(const ZeroRequest& request);
  /// The hand was put in and strapped just now; a resting force may be measured a minute later.
  /// Without this call it is not known. Taken back by the next zero.
  void strapped();
  /// Time until a resting force may be measured [s]; 0: now, as far as is known.
  [[nodiscard]] double settling_s() noexcept;
  /// Prepares and starts a trial. Fails if one is running, if a sensor started anew after the zero
  /// was set (field "zero"), if the task lacks its context (maximum) or if a hand that is to rest
  /// was strapped less than a minute ago. News: TrialOutcome.
  /// `place`: in the session's protocol; nothing: chosen by hand.
  [[nodiscard]] Result<void> start_trial(const tasks::TaskSpec& spec, bool practice,
                                         std::optional<storage::TrialPlace> place = std::nullopt);
  /// The trial stands still until resume(); task clock and object freeze, recording goes on.
  void pause();
  void resume();
  /// Ends the trial; it is kept and marked aborted. `reason` is stored with it, in English.
  void abort(Words reason = "Stopped by the therapist."_text);
  /// A remark at this moment of the session, stored with it.
  void note(const std::string& text);
  /// Answers given while the session runs, e.g. how the patient sits; stored with it.
  [[nodiscard]] Result<void> answer(const std::vector<storage::SessionAnswer>& answers);
  /// What is known last when the trial ends is stored with it.
  void shown(const ScreenShown& screen);
  /// The therapist helps in the running trial or, if none runs, did in the last one: it is kept and
  /// marked, and neither references nor levels follow from it. False takes the mark away again.
  void mark_helped(bool helped = true);
  /// What the patient answers to a question about the last trial that ended, stored with it; again,
  /// it takes the place of what was said before. No number: they were asked and gave none.
  /// @pre the question is one of the trial's task, the number on its scale
  void answer_question(const std::string& question, std::optional<int> number);
  /// What the patient says of the work so far, 0 to 10 each; of the shoulder where the hand is
  /// carried to its targets.
  /// @return why work should stop now; nothing: it may go on.
  /// Corrected: the last rating was meant to be this. @pre there is one in this session
  enum class Said : std::uint8_t { anew, corrected };
  [[nodiscard]] std::optional<Text> rate(int effort, int pain,
                                         std::optional<int> shoulder_pain = std::nullopt,
                                         Said said = Said::anew);

  /// News since the last call, without waiting.
  [[nodiscard]] std::vector<SessionNews> take_news();
  /// Waits for news; in virtual time this is what makes time pass. Empty only if the device
  /// finished while nothing was running.
  [[nodiscard]] std::vector<SessionNews> wait_for_news();

  /// Lets time pass while nothing is asked (rests between trials).
  void let_pass(double duration_s);

  /// Ends a running trial as aborted, writes all that is pending and closes the session's record.
  void close();
  /// Why not all of the session is in its database, where it is and what to do; nothing: it is, as
  /// far as was written. After close(): all of it was read back.
  [[nodiscard]] std::optional<Error> failure() const;
  /// Somebody has set SessionConfig::stop.
  [[nodiscard]] bool is_to_stop() const noexcept;

 private:
  struct Parts;
  struct Opening;
  explicit Session(std::unique_ptr<Parts> parts);
  friend void let_go(Session& session);
  friend void hold_clutch(Session& session, bool held);
  friend void platforms_checked(Session& session, std::optional<bool> coupled) noexcept;
  friend std::string stored_until_utc(const Session& session);
  std::unique_ptr<Parts> parts_;
};

/// The object on the screen is let go for the tracked hand that holds it: its placement ends, is
/// marked helped and is no drop. Nothing happens where there is none. Owner thread.
void let_go(Session& session);

/// The pedal by which bubbles of hands that are points come along: pressed, or let go. Owner
/// thread.
void hold_clutch(Session& session, bool held);

/// Two empty platforms were checked: whether one moves the other; nothing: the check was left out.
/// Trials from now on have it beside their rows, and no shares where it does. Owner thread.
void platforms_checked(Session& session, std::optional<bool> coupled) noexcept;

/// Everything up to this moment is durable: in the database or, after a failure, where that says.
/// ISO 8601. Owner thread.
[[nodiscard]] std::string stored_until_utc(const Session& session);

/// Newest state with all that is known of an arm seen by markers; null: it is something else.
/// Wait-free. Owner thread.
[[nodiscard]] const ArmSnapshot* arm_of(Session& session) noexcept;
/// The same of a tracked hand.
[[nodiscard]] const HandSnapshot* hand_of(Session& session) noexcept;
/// The same of two platforms, one for each hand.
[[nodiscard]] const TwoPlatformsSnapshot* two_platforms_of(Session& session) noexcept;

}  // namespace isograsp::session
