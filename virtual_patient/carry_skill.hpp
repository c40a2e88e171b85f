// SPDX-License-Identifier: GPL-3.0-or-later
// One of two hands that are points on the screen and carry an object between them: it brings its
// bubble beside the object, squeezes when the other one is there too, and pushes where the object
// is to go. It knows by handling how its force moves its point; all else it sees. World axes of the
// screen; SI units.
#pragma once

#include <array>

#include "hand/hands.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// What a hand learns of points and bubbles by handling them.
struct CarryKnown {
  Hand hand = Hand::left;
  double at_edge_N = 1.0;  ///< brings the point to the edge of its bubble
  double rate_m_s = 0.1;   ///< of the bubble, pressed twice as hard
  double rate_exponent = 1.0;
  bool clutch = false;   ///< bubbles move by the clutch alone
  bool pinch = false;    ///< what is held moves with both points; else pads have to press
  double depth_m = 0.0;  ///< without pinch: so far into the object they hold it firmly
  /// Axes of the contact of each finger on the screen.
  std::array<Mat3, kFingerCount> R_WC{Mat3::Identity(), Mat3::Identity(), Mat3::Identity()};
};

class CarrySkill {
 public:
  CarrySkill(const PatientTraits& traits, const CarryKnown& known) noexcept;

  /// It begins at time t_s.
  void begin(double t_s) noexcept;
  /// A perceived picture, in the order of time, at time t_s of the person. Real-time safe.
  void perceive(const Stimulus& picture, double t_s) noexcept;
  /// The forces wanted at time t_s. Real-time safe.
  [[nodiscard]] FingerForces wanted(double t_s) noexcept;

  /// The point has come as far as its bubble reaches, and further it is to go.
  [[nodiscard]] bool wants_clutch() const noexcept { return stretched_; }
  /// Nothing has to be done before the other hand has done its part.
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  /// The clutch is held and the hand has relaxed.
  [[nodiscard]] bool relaxed() const noexcept { return relaxed_; }

 private:
  [[nodiscard]] Vec3 free_hand(const ShownCarry& seen) noexcept;
  [[nodiscard]] Vec3 pinching_hand(const ShownCarry& seen) noexcept;
  [[nodiscard]] Vec3 pressing_hand(const ShownCarry& seen) noexcept;
  /// In shares of the force at the edge: what brings the point by `way_m` from the middle of its
  /// bubble, or moves the bubble towards there, beside a `squeeze` across.
  [[nodiscard]] Vec3 toward(const Vec3& way_m, const Vec3& half_size_m, double squeeze) noexcept;
  /// Beyond the edge, so that the bubble goes this way in the time of an approach.
  [[nodiscard]] double excess_for(double way_m) const noexcept;
  [[nodiscard]] double side() const noexcept { return known_.hand == Hand::left ? -1.0 : 1.0; }

  CarryKnown known_;
  double tone_N_;
  bool closing_ = false;
  bool far_ = false;  ///< the bubble does not reach there
  bool stretched_ = false;
  bool waits_ = false;
  bool relaxed_ = false;
  Vec3 aim_ = Vec3::Zero();   ///< in shares of the force at the edge
  Vec3 push_ = Vec3::Zero();  ///< likewise, smoothed
  double pushed_s_ = 0.0;
  double still_s_ = 0.0;  ///< since when the aim stands
  double seen_s_ = 0.0;
};

}  // namespace isograsp::virtual_patient
