// SPDX-License-Identifier: GPL-3.0-or-later
// Inside the flow only: why no trial can begin at this moment.
#pragma once

#include "gui/rules/flow.hpp"

namespace isograsp::gui {

enum class Obstacle : std::uint8_t {
  none,
  no_device,
  recording_over,
  no_zero,
  zeroing,
  trial_runs,
  protocol_over,
  zero_again,
  not_strapped,
  settles,
  rests,
  pause_ends,
  no_task,
  task_lacks
};
[[nodiscard]] Obstacle obstacle_of(const FlowFacts& facts);

}  // namespace isograsp::gui
