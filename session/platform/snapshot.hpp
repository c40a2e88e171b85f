// SPDX-License-Identifier: GPL-3.0-or-later
// What both screens show of a session on the platform: everything about one frame, copied out of
// the acquisition thread. SI units; wrenches of fingers in contact frames, after instrument zero.
#pragma once

#include <array>
#include <optional>

#include "device/sensors/force_device.hpp"
#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "hand/stimulus.hpp"
#include "session/acquisition/moment.hpp"
#include "tasks/task_view.hpp"

namespace isograsp::session {

/// What arm and trunk push: finger forces that only squeeze cancel in it. Frame P of the platform.
struct NetPush {
  bool known = false;  ///< false: a finger has no value
  Wrench wrench_P;     ///< [N, N m]
  /// |force| in % of the grip; nothing while the grip is below kLeastGripForPush_N.
  std::optional<double> share_of_grip_percent;
};
inline constexpr double kLeastGripForPush_N = 0.5;
/// From this net push on the therapist is told: the trial measures more than the hand.
inline constexpr double kRemarkablePush_percent = 20.0;
/// `forces` after zero, held values in place. Real-time safe.
[[nodiscard]] NetPush net_push(const Platform& platform, const FingerFrame& forces,
                               double grip_N) noexcept;

/// Copying it takes no memory from the heap. Published once per frame.
struct Snapshot : Moment {
  DeviceHealth health;
  FingerFrame forces;  ///< newest frame; flags say what is held or missing
  /// Whose sensor has started anew since the zero was measured: it is older than the restart and
  /// no trial should begin with it.
  std::optional<Finger> restarted;
  double grip_N = 0.0;  ///< min(thumb, index + middle), signed
  NetPush push;         ///< of the whole hand on the platform
  /// Where each pad presses on its support, x and y of C [m]; nothing below 2 N.
  std::array<std::optional<Eigen::Vector2d>, kFingerCount> centre_of_pressure{};

  tasks::SpecialView special;  ///< of the running trial's task, beside its progress
  bool has_object = false;
  ObjectState object;
  GraspWrench grasp;
};

/// What every picture of a platform says: the cue of its page and how far the task has come; before
/// and after trials that is all. Real-time safe.
[[nodiscard]] Stimulus page_of(const Moment& now) noexcept;

/// What is on the patient's screen at this frame, decided here alone: for whoever draws it when
/// they draw, for a simulated person in every frame. Real-time safe.
[[nodiscard]] Stimulus screen_of(const Snapshot& now) noexcept;

}  // namespace isograsp::session
