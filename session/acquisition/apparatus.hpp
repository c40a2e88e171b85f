// SPDX-License-Identifier: GPL-3.0-or-later
// What patients are measured with: a platform of force sensors, cameras that see an arm, …. The
// acquisition (acquisition.hpp) is the same for all of them; what is special is behind this
// interface. Order of calls: start() -> next()… -> stop().
//
// Threads: the owner's functions before the session's threads begin, after their end or where
// noted; the others belong to the acquisition thread and are real-time safe (no allocation, lock,
// log or exception).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "session/acquisition/moment.hpp"
#include "session/acquisition/trial_row.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

/// What is fixed once it was started.
struct ApparatusInfo {
  std::string_view kind;   ///< which apparatus: "platform"; tasks say what they need
  Text description;        ///< one line for people, e.g. "Robotous RFT on can0"
  bool simulated = false;  ///< values come from software: reports carry a watermark
  bool recorded = false;   ///< values come from a file: nobody can be asked, no zero is needed
  double period_s = 0.01;  ///< of the grid of frames
  double delay_s = 0.0;    ///< known delay from the body to the stamp
  std::vector<std::string> provenance;  ///< where recorded data come from, what was overridden
  /// A camera looks at the person: it is not opened before a lawful basis is on record.
  bool watches_person = false;
};

/// Refuses an apparatus that is not of the kind `needed`; empty: any will do.
[[nodiscard]] Result<void> check_apparatus(std::string_view needed, const ApparatusInfo& info);

/// What a session asks for before the work, in this order.
enum class PreparationStep : std::uint8_t {
  zero,           ///< instrument zero of the empty device
  rest,           ///< the hand at rest in it
  start_posture,  ///< the arm, held still
  hand_entry      ///< the tracked hand: at rest, then opened and closed
};

/// How a frame was received.
struct Reception {
  enum class Sight : std::uint8_t {
    clear,     ///< all that matters is there, or stands in for a moment
    occluded,  ///< the device works and does not see what it measures
    let_go,    ///< it sees that the object has left the hand: no failure, and no time passes
    lost       ///< samples do not come any more
  };
  bool gap = false;  ///< a part of it is missing
  Sight sight = Sight::clear;
};

/// What is wrong with the device; two faults are the same if their numbers are.
struct ApparatusFault {
  int number = 0;         ///< 0: nothing
  Words words = ""_text;  ///< for people, with what to do
  /// Of which part, where there are several of a kind: words in which the others stand.
  std::optional<Phrase<1>> where = std::nullopt;
};

/// A preparation is asked for.
struct ZeroRequest {
  /// The operator has confirmed it. Without it nothing is measured: muscle tone would become zero.
  bool device_is_empty = false;
  /// The operator has confirmed that the device was serviced or remounted: this zero may lie
  /// outside the band round the last one. Kept with the zero where it made the difference.
  bool accept_changed = false;
  double settle_s = 0.0;  ///< before the second that is measured: a simulated hand leaves
};

/// What came of a preparation.
struct PreparationOutcome {
  std::string name;  ///< of its events: "zero", "zero refused"
  bool accepted = false;
  Text reason;                ///< why not, in words for the therapist
  bool only_changed = false;  ///< refused, but ZeroRequest::accept_changed would allow it
  Text remark;                ///< accepted, but this is to be known; may be empty
  /// As it is stored if it is accepted; the recorder adds session, time and who.
  storage::PreparationRecord record;
};

/// Something that is measured before the work: the empty device, a hand at rest. Made by the owner,
/// filled on the acquisition thread, read by the recorder after its end.
class Preparation {
 public:
  virtual ~Preparation() = default;
  /// Recorder thread, after its end.
  [[nodiscard]] virtual PreparationOutcome outcome() const = 0;
};

/// All that one trial needs, made ready by the owner; lives until the session ends.
class TrialSetup {
 public:
  virtual ~TrialSetup() = default;
  /// The groups of columns that are recorded; those of Apparatus::write() in this trial.
  [[nodiscard]] virtual std::vector<storage::SignalGroup> columns() const = 0;
  /// Of the device when the trial ended, as JSON. Recorder thread.
  [[nodiscard]] virtual std::string health_json() const = 0;

  storage::TrialRecord record;
  tasks::TaskSpec spec;
  std::unique_ptr<tasks::Task> task;
  std::optional<double> since_strapping_s;
  Timing timing;  ///< filled while the trial runs, read after its end
};

class Apparatus {
 public:
  virtual ~Apparatus() = default;

  // The owner's.
  [[nodiscard]] virtual const ApparatusInfo& info() const noexcept = 0;
  [[nodiscard]] virtual std::span<const PreparationStep> steps() const noexcept = 0;
  /// Begins to stream on `clock`, which outlives it; session time begins now.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  virtual void stop() noexcept = 0;
  /// Writes what is special about it into the record of a session.
  virtual void describe(storage::SessionRecord& session) const = 0;
  // While threads run.
  /// Whether a trial may begin; the error says what is to be prepared anew.
  [[nodiscard]] virtual Result<void> ready() = 0;
  [[nodiscard]] virtual Result<std::unique_ptr<Preparation>> make_preparation(
      const ZeroRequest& request) = 0;
  /// Task, columns and what the record says of them; the session adds its own. Refused like
  /// tasks::make_task(), or where what the task needs cannot be read.
  [[nodiscard]] virtual Result<std::unique_ptr<TrialSetup>> make_trial(
      const tasks::TaskSpec& spec, const tasks::TaskContext& context) = 0;
  /// What was published last.
  [[nodiscard]] virtual const Moment& newest() noexcept = 0;

  // Every frame, in this order.
  /// Waits for the next frame and writes its session time into now(); false: no frame will come.
  [[nodiscard]] virtual bool next() noexcept = 0;
  /// Adds the frame to a preparation that runs, and its progress to now(); true: it has ended.
  [[nodiscard]] virtual bool measure(Preparation& preparation) noexcept = 0;
  /// Computes its values: less the zero, with substitutes for missing parts.
  [[nodiscard]] virtual Reception receive() noexcept = 0;
  /// One step of the task of the running trial, unless it is paused; its progress goes to now().
  virtual void step() noexcept = 0;
  /// Fills `row`, which is empty, with one value per column of the running trial.
  virtual void write(const RowFrame& frame, TrialRow& row) noexcept = 0;
  /// Moves what moves until the next frame, such as an object.
  virtual void move() noexcept = 0;
  /// Publishes now() together with the state of the apparatus.
  virtual void publish() noexcept = 0;
  /// Shows a simulated person what a patient would see.
  virtual void show() noexcept = 0;

  // When it is asked for, or happens.
  virtual void begin(Preparation& preparation) noexcept = 0;
  virtual void begin(TrialSetup& trial) noexcept = 0;
  virtual void end(TrialSetup& trial) noexcept = 0;
  /// The therapist lets what is held in the running trial go for the person; false: nothing is, or
  /// it is no object of the screen.
  [[nodiscard]] virtual bool let_go() noexcept { return false; }

  // Of the newest frame.
  /// The acquisition writes here what it knows.
  [[nodiscard]] virtual Moment& now() noexcept = 0;
  [[nodiscard]] virtual ApparatusFault fault() const noexcept = 0;
  /// From the instant of the frame to now.
  [[nodiscard]] virtual double lateness_s() const noexcept = 0;
  /// From the arrival of the sample that completed it to now; nothing: its time was up.
  [[nodiscard]] virtual std::optional<double> latency_s() const noexcept = 0;
};

}  // namespace isograsp::session
