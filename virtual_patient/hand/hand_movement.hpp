// SPDX-License-Identifier: GPL-3.0-or-later
// Movements of a hand with least jerk (Flash, Hogan 1985): the palm from pose to pose, the opening
// of the digits from width to width. SI units. Real-time safe.
#pragma once

#include <algorithm>

#include "core/spatial.hpp"
#include "virtual_patient/force_skill.hpp"

namespace isograsp::virtual_patient {

/// One after the other; a new one begins where the hand is.
template <class Place>
class HandMovement {
 public:
  void stand(const Place& at) noexcept { *this = {at, at, 0.0, 0.0}; }
  void go(const Place& to, double t_s, double duration_s) noexcept {
    *this = {at(t_s), to, t_s, duration_s};
  }
  [[nodiscard]] Place at(double t_s) const noexcept {
    if (t_s >= ends_s()) return to_;
    return between(from_, to_, least_jerk((t_s - begins_s_) / duration_s_));
  }
  [[nodiscard]] double ends_s() const noexcept { return begins_s_ + duration_s_; }
  [[nodiscard]] const Place& end() const noexcept { return to_; }

  HandMovement() = default;

 private:
  HandMovement(const Place& from, const Place& to, double begins_s, double duration_s) noexcept
      : from_(from), to_(to), begins_s_(begins_s), duration_s_(duration_s) {}
  static double between(double from, double to, double share) noexcept {
    return from + share * (to - from);
  }
  static Pose between(const Pose& from, const Pose& to, double share) noexcept {
    return {from.p + share * (to.p - from.p), from.q.slerp(share, to.q)};
  }

  Place from_{};
  Place to_{};
  double begins_s_ = 0.0;
  double duration_s_ = 0.0;
};

}  // namespace isograsp::virtual_patient
