// SPDX-License-Identifier: GPL-3.0-or-later
// The acquisition thread's work: samples -> frame -> zero -> wrench -> pose -> task -> snapshot.
// After construction everything here is real-time: no allocation, lock, log or exception.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "core/latest.hpp"
#include "core/ring.hpp"
#include "core/time.hpp"
#include "device/sensors/force_device.hpp"
#include "device/sensors/frame_reader.hpp"
#include "hand/stale.hpp"
#include "hand/stimulus.hpp"
#include "session/acquisition/snapshot.hpp"
#include "session/acquisition/trial_row.hpp"
#include "session/acquisition/zeroing.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp::session {

/// All that one trial needs, made ready by the owner; lives until the session ends.
struct TrialSetup {
  storage::TrialRecord record;
  tasks::TaskSpec spec;
  TrialConstants constants;
  std::unique_ptr<tasks::Task> task;
  std::optional<Plan> plan;  ///< none: a force task
  std::optional<double> since_strapping_s;
  Timing timing;  ///< filled while the trial runs, read after its end
};

/// RecordItem::event_kind of a fault of the device, in a trial or between two.
inline constexpr const char* kFaultEvent = "fault";

/// What goes to the recorder, in order.
struct RecordItem {
  enum class Kind : std::uint8_t { begin, sample, end, event, zero, finished };
  Kind kind = Kind::sample;
  TrialSetup* setup = nullptr;                                    ///< begin, end
  TrialRow row;                                                   ///< sample
  storage::TrialStatus status = storage::TrialStatus::completed;  ///< end
  const char* reason = "";                                        ///< end, event: static text
  const char* event_kind = "";
  bool pauses = false;       ///< event: the trial stands still because of the device
  bool told_before = false;  ///< event: the fault has been recorded already
  double session_time_s = 0.0;
  DeviceHealth health;  ///< end
  double worst_lateness_s = 0.0;
  double worst_compute_s = 0.0;
  std::int64_t dropped = 0;                 ///< end: samples of this trial without room
  Zeroing::Statistics zero;                 ///< zero
  std::optional<ZeroRefusal> zero_refusal;  ///< zero: nothing: it is in force
  std::optional<double> zero_change_N;      ///< zero: from the last one of the same device
  std::optional<double> zero_drift_N;       ///< zero: from the last one of this session
  bool change_confirmed = false;            ///< zero: beyond the band, as the operator confirmed
};

struct Command {
  enum class Kind : std::uint8_t { zero, begin, pause, resume, abort };
  Kind kind = Kind::zero;
  TrialSetup* setup = nullptr;  ///< begin
  const char* reason = "";      ///< abort: static text
  bool accept_changed = false;  ///< zero: the device was serviced or remounted
  double settle_s = 0.0;        ///< zero: time before the second that is measured
};

class Acquisition {
 public:
  struct Options {
    double ring_s = 10.0;           ///< how much the ring to the recorder holds at least
    bool resume_by_itself = false;  ///< recorded data: nobody is at the other end to be asked
    virtual_patient::VirtualPatient* viewer =
        nullptr;                         ///< a simulated person who watches the screen
    std::optional<SixAxes> last_zero{};  ///< of the same device in an earlier session
  };
  /// `device` is streaming on `clock` since `start`.
  Acquisition(ForceDevice& device, Clock& clock, Timestamp start, const Options& options);

  /// Waits for the next frame and does all of its work. False: the device has finished.
  [[nodiscard]] bool tick() noexcept;

  Ring<Command>& commands() noexcept { return commands_; }       ///< owner -> acquisition
  Ring<RecordItem>& records() noexcept { return records_; }      ///< acquisition -> recorder
  Latest<Snapshot>& snapshots() noexcept { return snapshots_; }  ///< acquisition -> owner

 private:
  void obey(const Command& command) noexcept;
  void process(FingerFrame& frame) noexcept;
  void add_to_zero(const FingerFrame& frame) noexcept;
  void subtract_zero(FingerFrame& frame) const noexcept;
  /// Applies the stale rule and pauses or resumes the trial by it.
  void guard(FingerFrame& frame) noexcept;
  /// Records a fault when it comes, whatever the stage is.
  void tell_fault() noexcept;
  /// Whether a sensor has started anew since the zero.
  void watch_restarts() noexcept;
  /// Counts how punctual the frame just published is.
  void measure_timing() noexcept;
  void run_trial(const FingerFrame& frame) noexcept;
  void begin_trial(TrialSetup& setup) noexcept;
  void end_trial(storage::TrialStatus status, const char* reason) noexcept;
  void pause(PauseCause cause) noexcept;
  void resume() noexcept;
  /// Sends item_ to the recorder; counts it if there is no room.
  void push(RecordItem::Kind kind) noexcept;
  void push_event(const char* kind, const char* text) noexcept;
  void publish(Timestamp frame_ready) noexcept;
  void show_to_viewer() noexcept;

  ForceDevice& device_;
  Clock& clock_;
  Options options_;
  FrameReader frames_;
  StaleRule stale_;
  Ring<Command> commands_;
  Ring<RecordItem> records_;
  Latest<Snapshot> snapshots_;

  Snapshot now_;  ///< the state that is published
  Zeroing zeroing_;
  double settle_s_ = 0.0;  ///< left before zeroing_ begins
  bool accept_changed_ = false;
  std::optional<SixAxes> zero_;  ///< in force; nothing: none yet
  using Restarts = std::array<std::uint64_t, kFingerCount>;
  Restarts restarts_before_zeroing_{};
  Restarts restarts_at_zero_{};  ///< of each sensor, when the zero in force was asked for
  DeviceFault told_fault_ = DeviceFault::none;
  std::optional<Finger> told_finger_;
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
