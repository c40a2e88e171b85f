// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/arm/movement_plan.hpp"

#include <algorithm>

#include "virtual_patient/force_skill.hpp"

namespace isograsp::virtual_patient {

void MovementPlan::stand(const Joints& q) noexcept {
  before_ = end_ = q;
  count_ = 0;
  began_s_ = ends_s_ = kNever_s;
}

void MovementPlan::add(const Joints& way, const Joints& lag, double start_s,
                       double duration_s) noexcept {
  // The oldest make room: those over for long, and one in any case if there are too many.
  std::size_t gone = 0;
  while (gone < count_ && parts_[gone].ends_s < start_s - kLookBack_s)
    before_ += parts_[gone++].way;
  if (count_ - gone == kMostParts) before_ += parts_[gone++].way;
  std::move(parts_.begin() + static_cast<std::ptrdiff_t>(gone),
            parts_.begin() + static_cast<std::ptrdiff_t>(count_), parts_.begin());
  count_ -= gone;
  const double ends_s = start_s + duration_s * (1.0 + lag.maxCoeff());
  parts_[count_++] = {way, lag, start_s, duration_s, ends_s};
  end_ += way;
  began_s_ = start_s;
  ends_s_ = std::max(ends_s_, ends_s);
}

Joints MovementPlan::at(double t_s) const noexcept {
  Joints q = before_;
  for (std::size_t i = 0; i < count_; ++i) {
    const Part& part = parts_[i];
    const double u = (t_s - part.start_s) / part.duration_s;
    for (int k = 0; k < kJoints; ++k) q[k] += part.way[k] * least_jerk(u - part.lag[k]);
  }
  return q;
}

}  // namespace isograsp::virtual_patient
