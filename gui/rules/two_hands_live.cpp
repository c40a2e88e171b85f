// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/two_hands_live.hpp"

#include <algorithm>
#include <cmath>

#include "tasks/measures/coordination/two_hands.hpp"

namespace isograsp::gui {

namespace {

constexpr double kMeanOver_s = 1.0;

std::optional<double> mean_N(const HandsHistory& history, Hand hand) {
  const auto& points = history.points();
  if (points.empty()) return std::nullopt;
  double sum_N = 0.0;
  int count = 0;
  for (auto point = points.rbegin();
       point != points.rend() && point->t_s > points.back().t_s - kMeanOver_s; ++point) {
    if (std::isnan(point->force_N[hand])) continue;
    sum_N += point->force_N[hand];
    ++count;
  }
  return count == 0 ? std::nullopt : std::optional(sum_N / count);
}

}  // namespace

HandsLive hands_live(const HandsHistory& history, const tasks::TwoHandsReferences& references) {
  HandsLive live;
  for (const Hand hand : kBothHands) {
    const auto force_N = mean_N(history, hand);
    const auto& rest_N = references.of[hand].resting_N;
    if (force_N && rest_N) live.above_rest_N[hand] = *force_N - *rest_N;
  }
  if (!references.affected || !live.above_rest_N.left || !live.above_rest_N.right) return live;
  const Hand affected = *references.affected;
  const Hand other = other_than(affected);
  const double affected_N = *live.above_rest_N[affected];
  const double other_N = *live.above_rest_N[other];
  if (std::max(0.0, affected_N) + std::max(0.0, other_N) < kLeastShared_N) return live;
  live.share_affected_percent = tasks::hand_share(affected_N, other_N).affected_percent.value;
  const double most_affected_N = references.of[affected].maximum_N.value_or(0.0);
  const double most_other_N = references.of[other].maximum_N.value_or(0.0);
  if (!(most_affected_N > 0.0) || !(most_other_N > 0.0)) return live;
  live.effort_share_affected_percent =
      tasks::effort_share(affected_N, other_N, most_affected_N, most_other_N).value;
  return live;
}

}  // namespace isograsp::gui
