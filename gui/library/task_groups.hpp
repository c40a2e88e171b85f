// SPDX-License-Identifier: GPL-3.0-or-later
// How tasks are listed: under which heading, in which order.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tasks/task_spec.hpp"

namespace isograsp::gui {

using tasks::TaskGroup;

// What a session does in this order, as far as the tasks are there.
[[nodiscard]] bool is_rest(const tasks::TaskSpec& spec);
/// The maximum of the whole grip: every other maximum, and a comfortable force, is one of the tasks
/// around it.
[[nodiscard]] bool is_grip_maximum(const tasks::TaskSpec& spec);
/// For recordings: nobody is asked for anything.
[[nodiscard]] bool is_free_handling(const tasks::TaskSpec& spec);

[[nodiscard]] Words words_of(TaskGroup group) noexcept;

/// A text whose order is that of names as people read them: "10 %" after "5 %", small letters like
/// large ones.
[[nodiscard]] std::string reading_order(const std::string& name);

/// In the order of the list: by group; rest and the maximum of the grip before all others of
/// theirs; then by name as people read it ("10 %" after "5 %", small letters like large ones).
void sort_for_list(std::vector<tasks::TaskSpec>& tasks);

}  // namespace isograsp::gui
