// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/target_preview.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

double TargetPreview::at(double task_time_s) const noexcept {
  const double last = static_cast<double>(target_N.size() - 1);
  const double place = std::clamp(task_time_s / period_s, 0.0, last);
  const auto before = static_cast<std::size_t>(place);
  const auto after = std::min(before + 1, target_N.size() - 1);
  return std::lerp(target_N[before], target_N[after], place - std::floor(place));
}

double TargetPreview::end_s() const noexcept {
  return period_s * static_cast<double>(target_N.size());
}

double TargetPreview::most_N() const noexcept {
  return empty() ? 0.0 : *std::max_element(target_N.begin(), target_N.end());
}

TargetPreview preview_target(const TaskSpec& spec, const TaskContext& context) {
  TargetPreview preview;
  preview.period_s = context.period_s;
  if (spec.aim() == nullptr) return preview;
  const auto task = make_task(spec, context);
  if (!task) return preview;
  const auto most = static_cast<std::size_t>(spec.duration().worst_s / context.period_s) + 2;
  preview.target_N.reserve(most);
  const TaskInput no_force;
  for (std::size_t k = 0; k < most; ++k) {
    const TaskView view = (*task)->step(no_force);
    if (view.phase == Phase::done) break;
    preview.target_N.push_back(view.target_force_N);
  }
  return preview;
}

}  // namespace isograsp
