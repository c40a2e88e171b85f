// SPDX-License-Identifier: GPL-3.0-or-later
// The last seconds of the grip forces of both hands and of what was asked of them, as the live plot
// shows them [N].
#pragma once

#include <deque>

#include "gui/look/force_history.hpp"
#include "hand/hands.hpp"
#include "session/two_platforms/two_platforms_snapshot.hpp"

namespace isograsp::gui {

struct HandsPoint {
  double t_s = 0.0;           ///< session time
  OfHands<double> force_N;    ///< NaN: a finger has no sample
  OfHands<double> target_N;   ///< NaN: none of its own
  double target_sum_N = 0.0;  ///< NaN: none of both
  [[nodiscard]] double sum_N() const noexcept { return force_N.left + force_N.right; }
};

class HandsHistory {
 public:
  explicit HandsHistory(double length_s = 20.0) : length_s_(length_s) {}

  /// Takes the snapshot if it is a new frame; forgets what is older than the length.
  void add(const session::TwoPlatformsSnapshot& snapshot);
  [[nodiscard]] const std::deque<HandsPoint>& points() const noexcept { return points_; }
  /// Of the axis [N], as that of one hand.
  [[nodiscard]] AxisRange::Limits range() const;

 private:
  double length_s_;
  std::deque<HandsPoint> points_;
};

}  // namespace isograsp::gui
