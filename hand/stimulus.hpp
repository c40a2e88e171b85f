// SPDX-License-Identifier: GPL-3.0-or-later
// What a person in front of the device can see, and what their fingers answer. A virtual person
// gets to know the task through this alone.
#pragma once

#include <array>

#include "core/spatial.hpp"
#include "hand/cue.hpp"
#include "hand/finger.hpp"
#include "hand/force_channel.hpp"

namespace isograsp {

/// Forces asked of single digits, contact frames [N]; `shown[f]`: there is one for finger f.
struct DigitTargets {
  std::array<bool, kFingerCount> shown{};
  std::array<Vec3, kFingerCount> force_C{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  [[nodiscard]] bool any() const noexcept { return shown[0] || shown[1] || shown[2]; }
};

/// One picture of the patient's screen.
struct Stimulus {
  double t_s = 0.0;  ///< session time of the picture [s]
  Cue cue = Cue::hand_out;
  ForceChannel channel;  ///< which force the cue is about
  bool force_target_shown = false;
  double target_force_N = 0.0;
  bool force_shown = true;     ///< false: feedback is off, the next value is not on the screen
  double shown_force_N = 0.0;  ///< the force of the channel
  DigitTargets digit_targets;
  bool object_shown = false;  ///< object and target pose below are on the screen
  Pose X_WO;
  Pose X_WT;
  std::array<bool, kFingerCount> contact{};  ///< virtual finger touches (drawn green)
};

/// A source of finger forces that reacts to what it sees. One thread uses it.
class FingerSource {
 public:
  virtual ~FingerSource() = default;
  /// A new picture; called once per frame with increasing time. Real-time safe.
  virtual void see(const Stimulus& stimulus) noexcept = 0;
  /// The wrenches [N, N m] of the fingertips on the contacts at time t_s, contact frames. Called
  /// with non-decreasing time, at 1 kHz by the simulated device. Real-time safe.
  [[nodiscard]] virtual FingerWrenches press(double t_s) noexcept = 0;
};

}  // namespace isograsp
