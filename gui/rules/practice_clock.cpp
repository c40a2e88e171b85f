// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/practice_clock.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::gui {

void PracticeClock::add(const session::ArmSnapshot& now, bool practising) {
  const bool running = now.stage == session::Stage::trial || now.stage == session::Stage::paused;
  if (!practising || !running) return;
  if (now.trial_number != trial_) {
    trial_ = now.trial_number;
    past_s_ += trial_s_;
    trial_s_ = 0.0;
    target_ = -1;
  }
  trial_s_ = std::max(trial_s_, now.task.task_time_s);
  if (now.task.target_index != target_) {
    target_ = now.task.target_index;
    cue_s_ = now.task.task_time_s;
    matched_ = false;
  }
  if (matched_ || target_ < 0 || !now.special.arm().matched) return;
  matched_ = true;
  movements_ += 1;
  before_s_ = last_s_;
  last_s_ = now.task.task_time_s - cue_s_;
}

double PracticeClock::bout_s() const noexcept {
  return total_s() - kBout_s * (bout() - 1);
}

int PracticeClock::bout() const noexcept {
  return static_cast<int>(std::floor(total_s() / kBout_s)) + 1;
}

std::optional<double> PracticeClock::difference() const noexcept {
  if (!before_s_ || !last_s_) return std::nullopt;
  const double longer_s = std::max(*before_s_, *last_s_);
  if (!(longer_s > 0.0)) return std::nullopt;
  return std::abs(*before_s_ - *last_s_) / longer_s;
}

bool PracticeClock::enough_later() const noexcept {
  const auto apart = difference();
  return movements_ >= kMostMovements || (apart && *apart < kSameTime);
}

}  // namespace isograsp::gui
