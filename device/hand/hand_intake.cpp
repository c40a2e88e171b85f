// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_intake.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "device/markers/marker_period.hpp"

namespace isograsp {

namespace {

/// Whether every joint that all trackers tell is there: all but the palm and four metacarpals.
bool is_whole(const HandFrame& frame) noexcept {
  if (!frame.joints[kWristJoint].allFinite()) return false;
  for (const Digit digit : {Digit::thumb, Digit::index, Digit::middle, Digit::ring, Digit::little})
    for (std::size_t end = 0; end < 4; ++end)
      if (!frame.joints[joint_of(digit, end)].allFinite()) return false;
  return true;
}

}  // namespace

HandFault HandReception::fault(Timestamp now) const noexcept {
  constexpr double kPeriods = 1.5;  // of slow cameras: one frame may be late by a half
  if (link != Link::open) return HandFault::connection_lost;
  if (now - last_frame > std::max(kPatience, from_seconds(kPeriods * period_s)))
    return HandFault::silence;
  if (frozen) return HandFault::frozen;
  if (other_from && other_last - *other_from > kPatience && now - other_last <= kPatience)
    return HandFault::other_hand;
  return damaged && now - *damaged < kRecent ? HandFault::damaged_samples : HandFault::none;
}

HandHealth HandReception::health(Timestamp now) const noexcept {
  HandHealth health;
  health.fault = fault(now);
  health.state = health.fault == HandFault::none ? DeviceState::streaming
                 : stops_hand(health.fault)      ? DeviceState::faulted
                                                 : DeviceState::degraded;
  health.counters = counters;
  health.jitter_s = jitter_s;
  return health;
}

void HandIntake::begin(Timestamp now, std::optional<double> period_s) noexcept {
  *this = HandIntake(side_);
  now_.last_frame = now;
  if (!period_s) return;
  now_.period_s = *period_s;
  times_.set_period(*period_s);
}

std::span<const HandSample> HandIntake::take(double tracker_s, std::span<const HandFrame> hands,
                                             Timestamp arrival) {
  const auto placed = times_.place(tracker_s, arrival);
  if (!placed) {
    late(arrival);
    return {};
  }
  HandCounters& counters = now_.counters;
  if (placed->number != number_) {
    number_ = placed->number;
    ++counters.frames;
    counters.lost += placed->lost;
    counters.clock_steps += placed->stepped ? 1 : 0;
    if (placed->lost > 0 || placed->stepped) now_.damaged = arrival;
    if (std::exchange(new_link_, false)) ++counters.restarts;
    look(*placed);
  }
  now_.last_frame = arrival;
  now_.jitter_s = times_.jitter_s();
  watch_side(hands, arrival);
  std::size_t given = 0;
  for (const HandFrame& hand : hands) {
    if (side_ && hand.side != *side_) {
      ++counters.other_side;
      continue;
    }
    Seen& seen = seen_[static_cast<std::size_t>(hand.side)];
    if (given == rows_.size() || placed->number <= seen.number) {
      late(arrival);
      continue;
    }
    seen.number = placed->number;
    HandSample& row = rows_[given++];
    row = {placed->stamp, placed->number, hand};
    row.frame.t_s = placed->t_s;
    if (row.frame.tracked && !is_whole(row.frame)) {
      row.frame.tracked = false;
      ++counters.incomplete;
      now_.damaged = arrival;
    }
    ++counters.rows;
    if (!row.frame.tracked) ++counters.untracked;
    watch_motion(row.frame, arrival);
  }
  return std::span(rows_).first(given);
}

void HandIntake::malformed(Timestamp now) noexcept {
  ++now_.counters.malformed;
  now_.damaged = now;
}
void HandIntake::late(Timestamp now) noexcept {
  ++now_.counters.late;
  now_.damaged = now;
}
void HandIntake::foreign(Timestamp now) noexcept {
  ++now_.counters.foreign;
  now_.damaged = now;
}

void HandIntake::link(HandReception::Link link) noexcept {
  using Link = HandReception::Link;
  if (link == Link::open && now_.link != Link::open) new_link_ = now_.counters.frames > 0;
  // Who has streamed once is lost, whatever keeps it from coming back.
  now_.link = link != Link::open && now_.counters.frames > 0 ? Link::lost : link;
}

void HandIntake::look(const PlacedHand& placed) {
  if (now_.period_s > 0.0) return;
  first_s_.push_back(placed.t_s);
  if (first_s_.size() < kLooks) return;
  now_.period_s = period_of(first_s_);
  times_.set_period(now_.period_s);
}

void HandIntake::watch_side(std::span<const HandFrame> hands, Timestamp arrival) noexcept {
  if (!side_) return;
  const auto shows = [&](bool chosen) {
    return std::any_of(hands.begin(), hands.end(), [&](const HandFrame& hand) {
      return hand.tracked && (hand.side == *side_) == chosen;
    });
  };
  if (shows(true)) {
    now_.other_from.reset();
  } else if (shows(false)) {
    if (!now_.other_from || arrival - now_.other_last > HandReception::kPatience)
      now_.other_from = arrival;
    now_.other_last = arrival;
  }
}

void HandIntake::watch_motion(const HandFrame& frame, Timestamp arrival) noexcept {
  constexpr int kRepeats = 3;  // of slow cameras
  Seen& seen = seen_[static_cast<std::size_t>(frame.side)];
  const bool same = frame.tracked && seen.repeats >= 0 &&
                    std::memcmp(&seen.joints, &frame.joints, sizeof frame.joints) == 0;
  if (same) {
    ++seen.repeats;
  } else {
    seen.joints = frame.joints;
    seen.same_from = arrival;
    seen.repeats = frame.tracked ? 0 : -1;
  }
  seen.frozen = seen.repeats >= kRepeats && arrival - seen.same_from > HandReception::kPatience;
  now_.frozen = seen_[0].frozen || seen_[1].frozen;
}

}  // namespace isograsp
