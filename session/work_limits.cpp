// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/work_limits.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isograsp::session {

void WorkLimits::begin(bool numb_skin) {
  *this = {};
  numb_skin_ = numb_skin;
}

void WorkLimits::tried(std::span<const Measure> measures) {
  without_last_ = maxima_;
  helped_ = false;
  for (const auto& measure : measures) {
    if (measure.name != "maximum_force" || !measure.value) continue;
    auto& maximum = maxima_[measure.channel];
    maximum.last_N = *measure.value;
    maximum.best_N = std::max(maximum.best_N, maximum.last_N);
  }
}

void WorkLimits::helped(bool helped) {
  if (std::exchange(helped_, helped) != helped) std::swap(maxima_, without_last_);
}

bool WorkLimits::straps_due(double session_time_s) const noexcept {
  return numb_skin_ && straps_s_ && session_time_s - *straps_s_ >= kStrapsLookedAtEvery_s;
}

std::optional<Text> WorkLimits::reason_to_stop() const {
  for (const auto& [channel, maximum] : maxima_) {
    if (maximum.best_N <= 0.0 || maximum.last_N > (1.0 - kMostForceLost) * maximum.best_N) continue;
    const double lost = 1.0 - maximum.last_N / maximum.best_N;
    return "The maximum has fallen by %1 % in this session: stop the work of this hand for today."_text(
        std::lround(100.0 * lost));
  }
  if (work_s_ >= kMostWork_s)
    return "%1 minutes of work are done: end the session for today."_text(
        std::lround(work_s_ / 60.0));
  return std::nullopt;
}

}  // namespace isograsp::session
