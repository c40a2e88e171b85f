// SPDX-License-Identifier: GPL-3.0-or-later
// The force target ahead of time, for the scrolling band of the patient's screen: the task itself
// is run once without forces, so preview and trial cannot differ.
#pragma once

#include <vector>

#include "tasks/task.hpp"

namespace isograsp {

struct TargetPreview {
  double period_s = 0.0;
  std::vector<double> target_N;  ///< value k is shown at task time k * period_s; empty: no target
  [[nodiscard]] bool empty() const noexcept { return target_N.empty(); }
  /// Linear between the values; the first before the start, the last after the end. @pre !empty()
  [[nodiscard]] double at(double task_time_s) const noexcept;
  [[nodiscard]] double end_s() const noexcept;
  [[nodiscard]] double most_N() const noexcept;
};

/// Empty for tasks whose target is not a function of time alone.
[[nodiscard]] TargetPreview preview_target(const TaskSpec& spec, const TaskContext& context);

}  // namespace isograsp
