// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_reader.hpp"

#include <algorithm>
#include <limits>

namespace isograsp::session {

HandFrame between(const HandFrame& first, const HandFrame& second, double share) noexcept {
  HandFrame hand = first;
  hand.confidence = std::min(first.confidence, second.confidence);
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    hand.joints[j] = first.joints[j] + share * (second.joints[j] - first.joints[j]);
  return hand;
}

HandReader::HandReader(HandDevice& device, Hand side, double period_s, Timestamp start) noexcept
    : device_(device), side_(side), period_s_(period_s), start_(start), seen_(start) {
  shown_.frame.side = side;
  shown_.frame.confidence = 0.0;
  shown_.frame.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

bool HandReader::next() noexcept {
  ++frame_;
  const Timestamp due = start_ + from_seconds(t_s());
  const bool goes_on = fill(due);
  shows_ = due - from_seconds(device_.info().period_s);
  while (count_ > 0 && waiting(0).stamp <= shows_) pass();
  if (!goes_on && count_ == 0) return false;
  show();
  return true;
}

bool HandReader::fill(Timestamp deadline) noexcept {
  HandSample row;
  for (;;) {
    switch (device_.read(deadline, row)) {
      case ReadStatus::finished: return false;
      case ReadStatus::timeout: return true;
      case ReadStatus::sample: break;
    }
    if (row.frame.side != side_) continue;
    if (count_ == kMostWaiting) pass();  // a tracker that is faster than any: the oldest goes
    queue_[(first_ + count_++) % kMostWaiting] = row;
  }
}

void HandReader::pass() noexcept {
  before_ = waiting(0);
  if (before_->frame.tracked) seen_ = before_->stamp;
  first_ = (first_ + 1) % kMostWaiting;
  --count_;
}

void HandReader::show() noexcept {
  const bool seen = before_ && before_->frame.tracked;
  const bool goes_on = seen && count_ > 0 && waiting(0).frame.tracked &&
                       to_seconds(waiting(0).stamp - before_->stamp) <= kLongestStep_s;
  if (goes_on) {
    const double step_s = to_seconds(waiting(0).stamp - before_->stamp);
    shown_.frame =
        between(before_->frame, waiting(0).frame, to_seconds(shows_ - before_->stamp) / step_s);
  } else if (seen) {
    shown_.frame = before_->frame;
  }
  shown_.known = shown_.known || seen;
  const double unseen_s = std::max(0.0, to_seconds(shows_ - seen_));
  // A row that comes late by half a period is no loss.
  constexpr double kLate = 0.5;
  shown_.held = !goes_on && !(seen && unseen_s <= kLate * device_.info().period_s);
  shown_.unseen_s = shown_.held ? unseen_s : 0.0;
  shown_.frame.tracked = !shown_.held;
  shown_.frame.t_s = t_s();
}

}  // namespace isograsp::session
