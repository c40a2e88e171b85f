// SPDX-License-Identifier: GPL-3.0-or-later
// Has the object left the hand? It has if it is further from the back of the hand than in the start
// posture by more than a limit, for a while. Real-time safe.
#pragma once

#include <cstdint>

#include "core/spatial.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp::session {

class HeldObject {
 public:
  static constexpr double kFurther_m =
      0.08;                              ///< than in the start posture: no grasp reaches so far
  static constexpr double kFor_s = 0.2;  ///< seen so: longer than a marker is wrong for

  /// A trial begins. `start_m`: from the back of the hand to the object in the start posture.
  void begin(double start_m, double period_s) noexcept;
  /// Nothing is asked of the object.
  void end() noexcept { watching_ = false; }
  /// A frame; missing_pose(): not seen, which says neither that it is held nor that it is not.
  void see(const Pose& X_WD, const Pose& X_WO) noexcept;
  /// It has left the hand and was not seen in it since. An object that was never seen in the hand
  /// in this trial has not left it.
  [[nodiscard]] bool is_lost() const noexcept { return watching_ && lost_; }

 private:
  bool watching_ = false;
  bool was_held_ = false;
  bool lost_ = false;
  double limit_m_ = 0.0;
  std::int64_t needed_ = 1;  ///< frames on end in which it is seen far away
  std::int64_t away_ = 0;
};

}  // namespace isograsp::session
