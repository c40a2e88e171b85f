// SPDX-License-Identifier: GPL-3.0-or-later
// Handles the frames of a session: each one is received, used for a preparation or a trial,
// recorded and published. After construction everything here is real-time: no allocation, lock, log
// or exception.
#pragma once

#include <optional>

#include "core/ring.hpp"
#include "core/time.hpp"
#include "session/acquisition/apparatus.hpp"

namespace isograsp::session {

/// RecordItem::event_kind of a fault of the device, in a trial or between two.
inline constexpr const char* kFaultEvent = "fault";
/// … of a trial that stands still because the object has left the hand.
inline constexpr const char* kObjectLostEvent = "object_lost";

/// … of a trial in which the therapist lets an object go for the person.
inline constexpr const char* kLetGoEvent = "let_go";

/// What goes to the recorder, in order.
struct RecordItem {
  enum class Kind : std::uint8_t { begin, sample, end, event, prepared, finished };
  Kind kind = Kind::sample;
  TrialSetup* setup = nullptr;                                    ///< begin, end
  Preparation* preparation = nullptr;                             ///< prepared
  TrialRow row;                                                   ///< sample
  storage::TrialStatus status = storage::TrialStatus::completed;  ///< end
  Words reason = ""_text;                                         ///< end, event
  std::optional<Phrase<1>> where;                                 ///< event: ApparatusFault::where
  const char* event_kind = "";
  bool pauses = false;       ///< event: the trial stands still because of the device
  bool told_before = false;  ///< event: the fault has been recorded already
  double session_time_s = 0.0;
  double worst_lateness_s = 0.0;
  double worst_compute_s = 0.0;
  std::int64_t dropped = 0;  ///< end: samples of this trial without room
};

struct Command {
  enum class Kind : std::uint8_t { prepare, begin, pause, resume, let_go, clutch, abort };
  Kind kind = Kind::pause;
  TrialSetup* setup = nullptr;         ///< begin
  Preparation* preparation = nullptr;  ///< prepare
  Words reason = ""_text;              ///< abort
  bool held = false;                   ///< clutch
};

class Acquisition {
 public:
  /// `apparatus` was started on `clock`. `ring_s`: how much the ring to the recorder holds at
  /// least.
  Acquisition(Apparatus& apparatus, Clock& clock, double ring_s = 10.0);

  /// Waits for the next frame and does all of its work. False: the device has finished.
  [[nodiscard]] bool tick() noexcept;

  Ring<Command>& commands() noexcept { return commands_; }   ///< owner -> acquisition
  Ring<RecordItem>& records() noexcept { return records_; }  ///< acquisition -> recorder

 private:
  void obey(const Command& command) noexcept;
  void process() noexcept;
  void prepare() noexcept;
  /// Pauses or resumes the trial by what is seen.
  void guard(Reception::Sight sight) noexcept;
  /// Records a fault when it comes, whatever the stage is.
  void tell_fault() noexcept;
  void run_trial() noexcept;
  void begin_trial(TrialSetup& setup) noexcept;
  void end_trial(storage::TrialStatus status, Words reason) noexcept;
  void pause(PauseCause cause) noexcept;
  void resume() noexcept;
  void finish() noexcept;
  /// Sends item_ to the recorder; counts it if there is no room.
  void push(RecordItem::Kind kind) noexcept;
  void push_event(const char* kind, Words text,
                  std::optional<Phrase<1>> where = std::nullopt) noexcept;
  void publish(Timestamp frame_ready) noexcept;
  /// Counts period, lateness and work of the frame that was published last.
  void measure_timing() noexcept;

  Apparatus& apparatus_;
  Clock& clock_;
  double period_s_;
  Ring<Command> commands_;
  Ring<RecordItem> records_;

  Moment& now_;  ///< the state that is published
  Preparation* preparation_ = nullptr;
  int told_fault_ = 0;
  TrialSetup* trial_ = nullptr;
  std::int64_t trial_frames_ = 0;
  double last_compute_s_ = 0.0;
  double worst_lateness_s_ = 0.0;
  double worst_compute_s_ = 0.0;
  std::uint64_t dropped_before_trial_ = 0;
  Timing timing_;  ///< of the session
  std::optional<Timestamp> last_published_;
  RecordItem item_;  ///< kept from frame to frame: large for the stack
};

}  // namespace isograsp::session
