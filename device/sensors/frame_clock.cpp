// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/frame_clock.hpp"

#include <algorithm>

namespace isograsp {

namespace {

// One lost sample leaves a gap of two periods, give or take the sensor's clock error and the jitter
// of its stamps; without this margin half of these gaps would be bridged and half would not.
constexpr double kLongestGapPeriods = 2.0 * 1.1;

/// Straight line from `a` to `b` at the fraction s of the way. Exact at both ends.
Wrench interpolate(const Wrench& a, const Wrench& b, double s) noexcept {
  Wrench w;
  w.force = a.force + s * (b.force - a.force);
  w.torque = a.torque + s * (b.torque - a.torque);
  return w;
}

void put(FingerFrame& frame, std::size_t f, const Wrench& wrench_C, const RawCounts& raw_counts,
         std::uint8_t flags) noexcept {
  frame.wrench_C[f] = wrench_C;
  frame.raw_counts[f] = raw_counts;
  frame.flags[f] = flags;
}

}  // namespace

FrameClock::FrameClock(double frame_period_s, double sample_period_s, bool on_grid,
                       Timestamp start) noexcept
    : frame_period_s_(frame_period_s),
      sample_period_s_(sample_period_s),
      on_grid_(on_grid),
      start_(start) {}

Timestamp FrameClock::time_of(std::int64_t slot) const noexcept {
  return start_ + from_seconds(static_cast<double>(slot) / (1.0 / frame_period_s_));
}

std::int64_t FrameClock::nearest_slot(Timestamp stamp) const noexcept {
  return std::llround(to_seconds(stamp - start_) / frame_period_s_);
}

std::int64_t FrameClock::interval(Timestamp stamp) const noexcept {
  const std::int64_t nearest = nearest_slot(stamp);
  return stamp <= time_of(nearest) ? nearest : nearest + 1;
}

Timestamp FrameClock::deadline() const noexcept {
  const double wait_s =
      on_grid_ ? frame_period_s_ : std::max(2.0 * sample_period_s_, frame_period_s_);
  return slot_time() + from_seconds(wait_s);
}

void FrameClock::push(const SensorSample& sample) noexcept {
  Track& track = tracks_[index_of(sample.finger)];
  const bool too_late = on_grid_ ? nearest_slot(sample.stamp) < slot_
                                 : slot_ > 0 && sample.stamp <= time_of(slot_ - 1);
  if (too_late) ++late_;

  if (on_grid_) {
    if (too_late) return;
    const bool repeated =
        track.count > 0 && nearest_slot(sample.stamp) <= nearest_slot(track.last().stamp);
    if (!repeated && track.count < track.after.size()) track.after[track.count++] = sample;
    return;
  }

  if (!sample.valid) return;
  if (sample.stamp <= slot_time()) {
    if (!track.has_before || sample.stamp >= track.before.stamp) track.before = sample;
    track.has_before = true;
    return;
  }
  if (track.count > 0 && sample.stamp < track.last().stamp) return;
  // Between two grid points only the first and the last sample matter: a sensor much faster than
  // the grid does not fill the store.
  const bool inner =
      track.count >= 2 && interval(track.after[track.count - 2].stamp) == interval(sample.stamp);
  if (inner) {
    const std::uint8_t told = track.last().flags;  // an overload between grid points counts, too
    track.last() = sample;
    track.last().flags |= told;
  } else if (track.count < track.after.size()) {
    track.after[track.count++] = sample;
  }
}

bool FrameClock::settled(const Track& track) const noexcept {
  if (track.count > 0) return !on_grid_ || nearest_slot(track.after[0].stamp) >= slot_;
  return !on_grid_ && track.has_before && track.before.stamp == slot_time();
}

bool FrameClock::pop(Timestamp now, FingerFrame& frame) noexcept {
  const bool all_settled =
      std::all_of(tracks_.begin(), tracks_.end(), [this](const Track& t) { return settled(t); });
  if (!all_settled && now < deadline()) return false;

  frame.slot = slot_;
  frame.t_s = static_cast<double>(slot_) / (1.0 / frame_period_s_);
  for (std::size_t f = 0; f < kFingerCount; ++f) close(tracks_[f], frame, f);
  ++slot_;
  for (Track& track : tracks_) advance(track);
  return true;
}

void FrameClock::close(const Track& track, FingerFrame& frame, std::size_t f) const noexcept {
  put(frame, f, Wrench{}, RawCounts{}, bit(SampleFlag::missing));
  if (on_grid_) {
    if (track.count == 0) return;
    const SensorSample& sample = track.after[0];
    if (sample.valid && nearest_slot(sample.stamp) == slot_)
      put(frame, f, sample.wrench_C, sample.raw_counts, sample.flags);
    return;
  }
  if (!track.has_before) return;
  const SensorSample& a = track.before;
  if (a.stamp == slot_time()) {
    put(frame, f, a.wrench_C, a.raw_counts, a.flags);
    return;
  }
  if (track.count == 0) return;
  const SensorSample& b = track.after[0];
  const double gap_s = to_seconds(b.stamp - a.stamp);
  if (gap_s > kLongestGapPeriods * sample_period_s_) return;
  const double s = to_seconds(slot_time() - a.stamp) / gap_s;
  put(frame, f, interpolate(a.wrench_C, b.wrench_C, s), s <= 0.5 ? a.raw_counts : b.raw_counts,
      static_cast<std::uint8_t>(a.flags | b.flags));
}

void FrameClock::advance(Track& track) const noexcept {
  std::size_t passed = 0;
  if (on_grid_) {
    while (passed < track.count && nearest_slot(track.after[passed].stamp) < slot_) ++passed;
  } else {
    while (passed < track.count && track.after[passed].stamp <= slot_time()) ++passed;
    if (passed > 0) {
      track.before = track.after[passed - 1];
      track.has_before = true;
    }
  }
  if (passed == 0) return;
  const auto first = track.after.begin();
  std::move(first + static_cast<std::ptrdiff_t>(passed),
            first + static_cast<std::ptrdiff_t>(track.count), first);
  track.count -= passed;
}

}  // namespace isograsp
