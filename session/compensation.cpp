// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/compensation.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::session {

namespace {

/// The first pressing after the strapping tells the place of a finger: noise of the moments, a few
/// millimetres at 2 N, averages out.
constexpr double kPlace_s = 0.5;
constexpr double kNow_s = 0.5;   ///< time constant of where a finger presses now
constexpr double kPush_s = 1.0;  ///< time constant of the push
/// Snapshots further apart than this count as this far apart: a gap has no larger weight.
constexpr double kLongestStep_s = 0.1;
constexpr double kSlipSeen_s = 2.0;  ///< long enough to read it

/// Share of a new value in a running average.
double weight(double step_s, double constant_s) {
  return 1.0 - std::exp(-step_s / constant_s);
}

}  // namespace

void Compensation::strapped() noexcept {
  pads_ = {};
  push_percent_.reset();
}

void Compensation::add(const Snapshot& snapshot) noexcept {
  if (snapshot.frames == 0) return;  // nothing has arrived
  const double step_s = newest_s_ ? snapshot.session_time_s - *newest_s_ : 0.0;
  if (newest_s_ && step_s <= 0.0) return;
  newest_s_ = snapshot.session_time_s;
  const double dt_s = std::min(step_s, kLongestStep_s);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (snapshot.stage == Stage::trial && snapshot.has_object && snapshot.grasp.slip[f])
      slip_seen_until_s_[f] = *newest_s_ + kSlipSeen_s;
    const auto& pressed = snapshot.centre_of_pressure[f];
    if (!pressed) continue;
    Pad& pad = pads_[f];
    if (pad.seen_s < kPlace_s) {
      pad.seen_s += dt_s;
      if (pad.seen_s > 0.0) pad.place += dt_s / pad.seen_s * (*pressed - pad.place);
      pad.now = pad.place;
    } else {
      pad.now += weight(dt_s, kNow_s) * (*pressed - pad.now);
    }
  }
  const auto& share = snapshot.push.share_of_grip_percent;
  if (!share)
    push_percent_.reset();
  else if (!push_percent_)
    push_percent_ = *share;
  else
    *push_percent_ += weight(dt_s, kPush_s) * (*share - *push_percent_);
}

std::optional<double> Compensation::pad_shift_m(Finger finger) const noexcept {
  const Pad& pad = pads_[index_of(finger)];
  if (pad.seen_s < kPlace_s) return std::nullopt;
  return (pad.now - pad.place).norm();
}

}  // namespace isograsp::session
