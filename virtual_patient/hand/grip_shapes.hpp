// SPDX-License-Identifier: GPL-3.0-or-later
// How a hand holds something between thumb and fingers: angles of all digits for each width. SI
// units; frame P of the palm of a right hand (virtual_hand/hand_model.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "virtual_hand/hand_pose.hpp"

namespace isograsp::virtual_patient {

/// Who opposes the thumb.
enum class Grip : std::uint8_t {
  pinch,  ///< the index
  tripod  ///< index and middle, side by side
};

/// One posture. Frame G of the grip: origin in the middle between thumb and fingers, x from the
/// thumb to the fingers, y out of the back of the hand.
struct GripShape {
  std::array<virtual_hand::DigitAngles, kDigitCount> angles{};
  Vec3 p_PG = Vec3::Zero();
};

/// On the way from one to another, linearly.
[[nodiscard]] GripShape between(const GripShape& from, const GripShape& to, double share) noexcept;

class GripShapes {
 public:
  /// Looks for the postures; not for the real-time path. `hand`: taken as a right one.
  GripShapes(const virtual_hand::HandModel& hand, Grip grip);

  /// Between the skin of thumb and fingers: `gap_m`, within what this hand can do. Real-time safe.
  [[nodiscard]] GripShape at(double gap_m) const noexcept;
  [[nodiscard]] double widest_m() const noexcept { return widest_m_; }
  /// Attitude of G in P.
  [[nodiscard]] static Quat q_PG() noexcept;

  static constexpr double kLeast_m = -0.01;  ///< the tips meet within each other
  static constexpr double kStep_m = 0.005;
  static constexpr std::size_t kCount = 28;  ///< up to 125 mm

 private:
  std::array<GripShape, kCount> shapes_;
  double widest_m_ = 0.0;
};

}  // namespace isograsp::virtual_patient
