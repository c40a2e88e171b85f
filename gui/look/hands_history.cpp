// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/hands_history.hpp"

#include <limits>

namespace isograsp::gui {

void HandsHistory::add(const session::TwoPlatformsSnapshot& snapshot) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  if (snapshot.frames == 0) return;
  if (!points_.empty() && snapshot.session_time_s <= points_.back().t_s) return;
  const bool asked = snapshot.trial_number > 0;
  const tasks::TwoHandsView& task = snapshot.special.two_hands();
  HandsPoint point;
  point.t_s = snapshot.session_time_s;
  for (const Hand hand : kBothHands) {
    const session::PlatformSide& side = snapshot.of[hand];
    point.force_N[hand] = side.forces.any(SampleFlag::missing) ? kNothing : side.grip_N;
    point.target_N[hand] = asked ? task.of[hand].target_N.value_or(kNothing) : kNothing;
  }
  point.target_sum_N = asked ? task.target_sum_N.value_or(kNothing) : kNothing;
  points_.push_back(point);
  while (points_.front().t_s < point.t_s - length_s_) points_.pop_front();
}

AxisRange::Limits HandsHistory::range() const {
  AxisRange range;
  for (const HandsPoint& point : points_)
    for (const double value : {point.force_N.left, point.force_N.right, point.sum_N(),
                               point.target_N.left, point.target_N.right, point.target_sum_N})
      range.include(value);
  return range.limits();
}

}  // namespace isograsp::gui
