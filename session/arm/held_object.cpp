// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/held_object.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::session {

void HeldObject::begin(double start_m, double period_s) noexcept {
  *this = {};
  watching_ = true;
  limit_m_ = start_m + kFurther_m;
  constexpr double kRounding = 1e-6;  // of a frame
  needed_ = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(kFor_s / period_s - kRounding)));
}

void HeldObject::see(const Pose& X_WD, const Pose& X_WO) noexcept {
  if (!watching_ || is_missing(X_WD) || is_missing(X_WO)) return;
  if ((X_WO.p - X_WD.p).norm() <= limit_m_) {
    was_held_ = true;
    lost_ = false;
    away_ = 0;
    return;
  }
  if (was_held_ && ++away_ >= needed_) lost_ = true;
}

}  // namespace isograsp::session
