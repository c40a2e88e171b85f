// SPDX-License-Identifier: GPL-3.0-or-later
// A frame that was seen at c on the tracker's clock and arrives at a was on its way for d = a - c +
// k, k unknown but constant. The smallest d so far is taken for the way without any waiting; it
// follows slowly, for clocks drift.
#include "device/hand/hand_times.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

namespace {

constexpr double kHandAhead_s = 1.0;    ///< of a tracker's clock, before it is not believed
constexpr double kHandDrift = 100e-6;   ///< of two clocks, at most
constexpr double kHandLateFor_s = 2.0;  ///< of frames that come too late: the clock stood still
constexpr double kUnknownPeriod_s = 0.01;

}  // namespace

std::optional<PlacedHand> HandTimes::place(double tracker_s, Timestamp arrival) noexcept {
  if (first_) {
    first_ = false;
    origin_ = arrival_ = arrival;
    tracker_s_ = zero_s_ = tracker_s;
    way_s_ = -tracker_s;
    jitter_s_ = 0.0;
    last_ = {0.0, arrival, 0, 0, false};
    return last_;
  }
  const double step_s = tracker_s - tracker_s_;
  if (step_s == 0.0) {
    last_.lost = 0;
    last_.stepped = false;
    return last_;
  }
  if (step_s < 0.0 && step_s > -kOverlap_s) return std::nullopt;
  const double passed_s = to_seconds(arrival - arrival_);
  const bool believed = step_s > 0.0 && step_s <= passed_s + kHandAhead_s;
  const double least_s = period_s_ > 0.0 ? period_s_ : kUnknownPeriod_s;
  if (!believed) zero_s_ = tracker_s - (last_.t_s + std::max(passed_s, least_s));
  const double t_s = tracker_s - zero_s_;
  if (!(t_s > last_.t_s)) return std::nullopt;  // less than a number of this size can tell
  const std::int64_t places =
      period_s_ > 0.0 ? std::max<std::int64_t>(1, std::llround((t_s - last_.t_s) / period_s_)) : 1;
  last_.t_s = t_s;
  last_.stamp = std::max(seen(tracker_s, arrival, !believed), last_.stamp + Timestamp{1});
  last_.number += places;
  last_.lost = static_cast<std::uint64_t>(places - 1);
  last_.stepped = !believed;
  tracker_s_ = tracker_s;
  arrival_ = arrival;
  return last_;
}

Timestamp HandTimes::seen(double tracker_s, Timestamp arrival, bool other_clock) noexcept {
  const double way_s = to_seconds(arrival - origin_) - tracker_s;
  const double passed_s = std::max(0.0, tracker_s - tracker_s_);
  late_s_ = way_s - way_s_ > kHandAhead_s ? late_s_ + passed_s : 0.0;
  if (way_s < way_s_ || other_clock || late_s_ > kHandLateFor_s) {
    way_s_ = way_s;
    late_s_ = 0.0;
  } else {
    way_s_ += std::min(way_s - way_s_, kHandDrift * passed_s);
  }
  jitter_s_ = way_s - way_s_;
  return arrival - from_seconds(*jitter_s_);
}

}  // namespace isograsp
