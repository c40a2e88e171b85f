// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/hand_live.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::gui {

std::optional<GraspLive> grasp_live(const session::HandSnapshot& now) noexcept {
  const tasks::HandView& task = now.special.hand();
  const hand_world::GraspState& grasp = now.grasp;
  if (!grasp.object_there || task.object < 0) return std::nullopt;
  GraspLive live;
  if (std::isfinite(now.release_N)) live.release_N = now.release_N;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const hand_world::DigitGrasp& digit = grasp.digits[d];
    // One that presses does not pull.
    live.digits[d] = {digit.state, std::max(0.0, digit.pull_N), std::nullopt};
    if (digit.state == virtual_hand::DigitState::attached && live.release_N)
      live.digits[d].share = std::clamp(digit.pull_N / *live.release_N, 0.0, 1.0);
  }
  const virtual_hand::GraspChoice& choice = grasp.choice;
  if (choice.digits != 0) {
    live.criteria[0] = CriterionLive{choice.G_min, choice.G_min_limit};
    if (choice.H_min_limit > 0.0)
      live.criteria[1] = CriterionLive{choice.H_min, choice.H_min_limit};
    live.criteria[2] = CriterionLive{choice.H_det, choice.H_det_limit};
  }
  live.feasible = choice.feasible;
  live.tracked_gap_m = grasp.tracked_gap_m;
  live.level = task.assistance;
  live.placement = task.placement;
  live.fails = task.fails;
  live.eased = task.eased;
  live.let_go_asked = task.let_go_asked;
  live.helped = task.helped;
  return live;
}

void TrackerWatch::add(const session::HandSnapshot& now) {
  const double t_s = now.session_time_s;
  if (now.frames == 0 || (!rows_.empty() && t_s <= rows_.back().t_s)) return;
  if (seen_ && now.hand.held) ++gaps_;
  seen_ = !now.hand.held;
  rows_.push_back({t_s, now.health.counters});
  // The last row of the time before stays: what came since is counted from it.
  while (rows_.size() > 2 && rows_[1].t_s <= t_s - kLength_s) rows_.pop_front();
}

std::optional<double> TrackerWatch::rate_Hz() const {
  constexpr double kLeast_s = 1.0;  // a few rows tell no rate
  if (rows_.empty() || rows_.back().t_s - rows_.front().t_s < kLeast_s) return std::nullopt;
  const Row& first = rows_.front();
  const Row& last = rows_.back();
  return static_cast<double>(last.count.rows - first.count.rows) / (last.t_s - first.t_s);
}

std::optional<double> TrackerWatch::lost_percent() const {
  if (!rate_Hz()) return std::nullopt;
  const HandCounters& first = rows_.front().count;
  const HandCounters& last = rows_.back().count;
  const auto came = static_cast<double>(last.rows - first.rows);
  const auto missing = static_cast<double>(last.lost - first.lost);
  const auto unseen = static_cast<double>(last.untracked - first.untracked);
  constexpr double kPercent = 100.0;
  if (came + missing == 0.0) return kPercent;
  return kPercent * (unseen + missing) / (came + missing);
}

}  // namespace isograsp::gui
