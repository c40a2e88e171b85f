// SPDX-License-Identifier: GPL-3.0-or-later
// The state of a session at one frame, the same for every apparatus, which publishes it together
// with its own.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/text.hpp"
#include "core/time.hpp"
#include "session/acquisition/timing.hpp"
#include "tasks/task_progress.hpp"

namespace isograsp::session {

enum class Stage : std::uint8_t {
  idle,     ///< streaming, nothing asked of the patient
  zeroing,  ///< a preparation is measured: an instrument zero (the device must be empty), …
  trial,    ///< a trial is recorded
  paused,   ///< a trial stands still; see Moment::pause_cause
  finished  ///< the device will give no more frames
};
[[nodiscard]] std::string_view name_of(Stage stage) noexcept;

/// `occluded`: what is measured is out of sight, which happens often with cameras; `object_lost`:
/// what the person held has left the hand. The trial goes on by itself when it is seen, or held,
/// again. The others are resumed by the therapist.
enum class PauseCause : std::uint8_t {
  none,
  therapist,
  missing_samples,
  device_fault,
  occluded,
  object_lost
};
[[nodiscard]] constexpr bool goes_on_by_itself(PauseCause cause) noexcept {
  return cause == PauseCause::occluded || cause == PauseCause::object_lost;
}
/// One plain sentence: why the trial stands still and what to do. Static text.
[[nodiscard]] Words words_of(PauseCause cause) noexcept;
/// The device is in the way, and the therapist is asked.
[[nodiscard]] constexpr bool is_fault(PauseCause cause) noexcept {
  return cause == PauseCause::missing_samples || cause == PauseCause::device_fault;
}

/// Copying it takes no memory from the heap.
struct Moment {
  std::int64_t frames = 0;      ///< frames so far; 0: nothing has arrived yet
  double session_time_s = 0.0;  ///< since the device was started
  Timestamp published{0};       ///< on the session's clock: its age tells live from stale
  Stage stage = Stage::idle;
  PauseCause pause_cause = PauseCause::none;
  bool clutch_held = false;    ///< a pedal that a person may hold beside what the device measures
  double zero_progress = 0.0;  ///< 0 … 1 while zeroing
  bool zeroed = false;         ///< a zero that was measured in this session is in force

  int trial_number = 0;      ///< of the running trial; 0: none
  tasks::TaskProgress task;  ///< of the running trial

  double lateness_s = 0.0;             ///< grid instant -> published
  double compute_s = 0.0;              ///< newest sample in hand -> published
  TimingSummary timing;                ///< of the session so far; renewed every second
  std::uint64_t frames_with_gap = 0;   ///< frames of which a part was missing
  std::uint64_t recorder_dropped = 0;  ///< samples that found the recorder's ring full
};

}  // namespace isograsp::session
