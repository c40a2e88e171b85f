// SPDX-License-Identifier: GPL-3.0-or-later
// What the kinds of tasks are called in task files.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

/// In the order of TaskSpec::kind.
inline constexpr std::array<std::string_view, std::variant_size_v<decltype(TaskSpec::kind)>>
    kTaskKinds{"rest",
               "maximum",
               "force_tracking",
               "pose_targets",
               "observe",
               "directional_maxima",
               "steadiness",
               "step_response",
               "grip_release",
               "force_sense",
               "fatigue",
               "individuation",
               "force_direction",
               "pose_tracking",
               "pick_place",
               "recorded"};

[[nodiscard]] inline std::string_view kind_name(const TaskSpec& spec) {
  return kTaskKinds[spec.kind.index()];
}

}  // namespace isograsp::tasks
