// SPDX-License-Identifier: GPL-3.0-or-later
// What both screens show: everything about one frame, copied out of the acquisition thread.
// SI units; wrenches of fingers in contact frames, after instrument zero.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "device/sensors/force_device.hpp"
#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "session/acquisition/timing.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

enum class Stage : std::uint8_t {
  idle,     ///< streaming, nothing asked of the patient
  zeroing,  ///< instrument zero in progress: the device must be empty
  trial,    ///< a trial is recorded
  paused,   ///< a trial stands still; see Snapshot::pause_cause
  finished  ///< the device will give no more frames
};
[[nodiscard]] std::string_view name_of(Stage stage) noexcept;

enum class PauseCause : std::uint8_t { none, therapist, missing_samples, device_fault };
/// One plain sentence: why the trial stands still and what to do. Static text.
[[nodiscard]] const char* describe(PauseCause cause) noexcept;

/// What arm and trunk push: finger forces that only squeeze cancel in it. Frame P of the platform.
struct NetPush {
  bool known = false;  ///< false: a finger has no value
  Wrench wrench_P;     ///< [N, N m]
  /// |force| in % of the grip; nothing while the grip is below kLeastGripForPush_N.
  std::optional<double> share_of_grip_percent;
};
inline constexpr double kLeastGripForPush_N = 0.5;
/// From here on it is remarked on: the trial measures more than the hand.
inline constexpr double kRemarkablePush_percent = 20.0;
/// `forces` after zero, held values in place. Real-time safe.
[[nodiscard]] NetPush net_push(const Platform& platform, const FingerFrame& forces,
                               double grip_N) noexcept;

/// Copying it takes no memory from the heap. Published once per frame.
struct Snapshot {
  std::int64_t frames = 0;      ///< frames so far; 0: nothing has arrived yet
  double session_time_s = 0.0;  ///< since the device was started
  Timestamp published{0};       ///< on the session's clock: its age tells live from stale
  Stage stage = Stage::idle;
  PauseCause pause_cause = PauseCause::none;

  DeviceHealth health;
  FingerFrame forces;   ///< newest frame; flags say what is held or missing
  bool zeroed = false;  ///< an instrument zero is in force
  /// Whose sensor has started anew since that zero was measured: it is older than the restart and
  /// no trial should begin with it.
  std::optional<Finger> restarted;
  double zero_progress = 0.0;  ///< 0 … 1 while zeroing
  double grip_N = 0.0;         ///< min(thumb, index + middle), signed
  NetPush push;                ///< of the whole hand on the platform
  /// Where each pad presses on its support, x and y of C [m]; nothing below 2 N.
  std::array<std::optional<Eigen::Vector2d>, kFingerCount> centre_of_pressure{};

  int trial_number = 0;  ///< of the running trial; 0: none
  tasks::TaskView task;  ///< of the running trial
  bool has_object = false;
  ObjectState object;
  GraspWrench grasp;

  double lateness_s = 0.0;             ///< grid instant -> published
  double compute_s = 0.0;              ///< newest sample in hand -> published
  TimingSummary timing;                ///< of the session so far; renewed every second
  std::uint64_t frames_with_gap = 0;   ///< frames with a held or missing finger
  std::uint64_t recorder_dropped = 0;  ///< samples that found the recorder's ring full
};

}  // namespace isograsp::session
