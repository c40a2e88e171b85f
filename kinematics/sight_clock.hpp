// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of a task that shows where an object is to be: while the object is out of sight it
// stands still. Missing rows count for 50 ms, the last pose stands in for them; when the next pose
// comes later than that, what is above 50 ms is a pause. Real-time: nothing here allocates.
#pragma once

#include <algorithm>
#include <cstdint>

#include "kinematics/pose_series.hpp"

namespace isograsp {

/// What a row is for such a task.
enum class Sight : std::uint8_t {
  hidden,  ///< nothing is known: the row does not count
  first,   ///< the object is seen for the first time: the clock starts
  seen,
  held,  ///< the last pose stands in
  again  ///< seen after a pause
};

class SightClock {
 public:
  /// One row, in order of time [s].
  Sight step(double t_s, bool object_seen) noexcept {
    const bool away = t_s - last_seen_s_ > kLongestStandIn_s + kMarkerTimeSlack_s;
    if (!object_seen) return started_ && !away ? Sight::held : Sight::hidden;
    const Sight sight = !started_ ? Sight::first : away ? Sight::again : Sight::seen;
    if (sight == Sight::first) first_s_ = t_s;
    if (sight == Sight::again) pauses_s_ += t_s - last_seen_s_ - kLongestStandIn_s;
    started_ = true;
    last_seen_s_ = t_s;
    return sight;
  }

  [[nodiscard]] bool started() const noexcept { return started_; }
  [[nodiscard]] double pauses_s() const noexcept { return pauses_s_; }
  /// The clock at a time of the record; it stands still 50 ms after the last pose.
  [[nodiscard]] double at(double t_s) const noexcept {
    return std::min(t_s, last_seen_s_ + kLongestStandIn_s) - pauses_s_;
  }
  /// … since it started; 0 before.
  [[nodiscard]] double elapsed_s(double t_s) const noexcept {
    return started_ ? at(t_s) - first_s_ : 0.0;
  }

 private:
  bool started_ = false;
  double first_s_ = 0.0;
  double last_seen_s_ = 0.0;
  double pauses_s_ = 0.0;
};

}  // namespace isograsp
