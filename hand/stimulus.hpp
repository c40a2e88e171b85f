// SPDX-License-Identifier: GPL-3.0-or-later
// What a person in front of the device can see, and what their fingers answer. The only door
// between the screen and the hand: a person (real or virtual) knows the task through it alone.
#pragma once

#include <array>
#include <string_view>

#include "core/spatial.hpp"
#include "hand/finger.hpp"
#include "hand/force_channel.hpp"

namespace isograsp {

/// The instruction on the patient's screen. Each is about the force of Stimulus::channel.
enum class Cue : std::uint8_t {
  hand_out,   ///< "Please take your hand out of the device"
  relax,      ///< hand in, no force
  squeeze,    ///< as hard as you can, in the direction of the channel
  press,      ///< comfortably, and hold it
  follow,     ///< follow the force target, or hold it where the own force is not shown
  reproduce,  ///< the force held before, from memory
  let_go,     ///< now, as fast as you can
  move        ///< bring the object to the target
};
inline constexpr std::size_t kCueCount = 8;
[[nodiscard]] constexpr std::string_view name_of(Cue cue) noexcept {
  constexpr std::array<std::string_view, kCueCount> kNames{
      "hand out", "relax", "squeeze", "press", "follow", "reproduce", "let go", "move"};
  return kNames[static_cast<std::size_t>(cue)];
}

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
