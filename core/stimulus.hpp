// SPDX-License-Identifier: GPL-3.0-or-later
// What a person in front of the device can see, and what their fingers answer. The only door
// between the screen and the hand: a person (real or virtual) knows the task through it alone.
#pragma once

#include <array>

#include "core/finger.hpp"
#include "core/spatial.hpp"

namespace isograsp {

/// The instruction on the patient's screen.
enum class Cue : std::uint8_t {
  hand_out,  ///< "Please take your hand out of the device"
  relax,     ///< hand in, no force
  squeeze,   ///< press as hard as you can
  follow,    ///< follow the force target
  move       ///< bring the object to the target
};

/// One picture of the patient's screen.
struct Stimulus {
  double t_s = 0.0;  ///< session time of the picture [s]
  Cue cue = Cue::hand_out;
  bool force_target_shown = false;
  double target_force_N = 0.0;
  double shown_force_N = 0.0;  ///< the force that the screen displays (grip)
  bool object_shown = false;   ///< object and target pose below are on the screen
  Pose object;
  Pose target;
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
