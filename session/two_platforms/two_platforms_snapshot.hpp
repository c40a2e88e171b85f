// SPDX-License-Identifier: GPL-3.0-or-later
// What both screens show of a session on two platforms, one for each hand, copied out of the
// acquisition thread. SI units; wrenches of fingers in contact frames, after instrument zero.
#pragma once

#include <optional>

#include "device/sensors/force_device.hpp"
#include "hand/hands.hpp"
#include "hand/stimulus.hpp"
#include "session/acquisition/moment.hpp"
#include "tasks/task_view.hpp"

namespace isograsp::session {

/// One platform and the hand on it.
struct PlatformSide {
  DeviceHealth health;
  FingerFrame forces;  ///< newest frame; flags say what is held or missing
  /// Whose sensor has started anew since the zero was measured.
  std::optional<Finger> restarted;
  double grip_N = 0.0;  ///< min(thumb, index + middle), signed
  /// Sum of the fingers, signed, in the axes of the patient's view [N]; nothing: a finger has no
  /// value.
  std::optional<Vec3> push_W;
};

/// What one hand does to the object that both lift.
struct LiftingHand {
  Vec3 end_O = Vec3::Zero();  ///< where it presses, object axes
  double squeeze_N = 0.0;     ///< into the object, signed
  bool touches = false;
  bool slips = false;        ///< at the limit of friction
  double utilisation = 0.0;  ///< share of that limit, before the clamp
};
/// An object that both hands lift.
struct LiftedView {
  ObjectState object;
  Vec3 size_m = Vec3::Zero();
  OfHands<LiftingHand> of;
  Wrench F_O_W;  ///< by both hands, about its centre of mass
};

/// A hand that is a point on the screen.
struct CarryingHand {
  Vec3 p_W = Vec3::Zero();
  Vec3 bubble_W = Vec3::Zero();
  double excess = 0.0;     ///< beyond the edge of its bubble, over the force at the edge
  double squeeze_N = 0.0;  ///< towards the other hand, signed
};
/// An object that both hands, as points, take and carry.
struct CarriedView {
  ObjectState object;
  Vec3 size_m = Vec3::Zero();
  Vec3 half_size_m = Vec3::Zero();  ///< of the bubbles
  OfHands<CarryingHand> of;
  bool held = false;   ///< by both hands
  bool joint = false;  ///< the bubbles move as one
  bool clutch = false;
};

/// Copying it takes no memory from the heap. Published once per frame.
struct TwoPlatformsSnapshot : Moment {
  OfHands<PlatformSide> of;
  /// The newest sample of the right platform is later than that of the left by so much; nothing: a
  /// frame was closed because its time was up.
  std::optional<double> skew_s;
  tasks::SpecialView special;          ///< of the running trial's task, beside its progress
  std::optional<LiftedView> lifted;    ///< nothing: nothing is lifted in the trial
  std::optional<CarriedView> carried;  ///< nothing: nothing is carried in the trial
};

/// Net push of one hand in the axes of the patient's view: those of the platform, which for a left
/// hand is turned by pi about y (docs/conventions.md). Real-time safe.
[[nodiscard]] Vec3 push_in_view(Hand hand, const Vec3& force_P) noexcept;

/// What is on the patient's screen at this frame, decided here alone (screen_of() of a platform).
/// Real-time safe.
[[nodiscard]] Stimulus screen_of(const TwoPlatformsSnapshot& now) noexcept;

}  // namespace isograsp::session
