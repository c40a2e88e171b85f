// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts of tasks: which step of a session each stands for, and under which heading it is listed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tasks/task_spec.hpp"

namespace isograsp::gui {

/// What a task is to the flow of a session: the maximum is that of the grip alone, and most
/// kinds of tasks are simply others.
enum class TaskKind : std::uint8_t { rest, maximum, force_tracking, pose_targets, observe, other };

/// Only the maximum of the whole grip counts as
/// `maximum`: every other maximum, and a comfortable force, is one of the tasks around it.
[[nodiscard]] TaskKind kind_of(const tasks::TaskSpec& spec);

/// Headings of the list, in order.
enum class TaskGroup : std::uint8_t {
  rest_and_maximum,
  follow,
  hold_and_let_go,
  fingers_and_directions,
  object
};
[[nodiscard]] TaskGroup group_of(const tasks::TaskSpec& spec);
[[nodiscard]] std::string_view title_of(TaskGroup group) noexcept;

/// A text whose order is that of names as people read them: "10 %" after "5 %", small letters like
/// large ones.
[[nodiscard]] std::string reading_order(const std::string& name);

/// In the order of the list: by group; rest and the maximum of the grip before all others of
/// theirs; then by name as people read it ("10 %" after "5 %", small letters like large ones).
void sort_for_list(std::vector<tasks::TaskSpec>& tasks);

}  // namespace isograsp::gui
