// SPDX-License-Identifier: GPL-3.0-or-later
// What a task of a tracked hand must ask before its results may be an assessment, and how many
// virtual objects a protocol may ask a hand to place.
#pragma once

#include <vector>

#include "core/result.hpp"
#include "tasks/protocol.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::session {

/// Refused (field "assistance"): a task with help, or one that becomes easier after fails, is
/// training. Trials at a level that follows success are none anyway; every other task passes.
[[nodiscard]] Result<void> check_hand_assessment(const tasks::TaskSpec& spec);

/// Refuses steps that are assessments and must not be one, placements without an entry test before
/// them, more placements than a session may have, and bouts without a rest between them. `tasks`:
/// of each step. Protocols without virtual objects pass.
[[nodiscard]] Result<void> check_hand_rules(const tasks::ProtocolSpec& protocol,
                                            const std::vector<std::vector<tasks::TaskSpec>>& tasks);

}  // namespace isograsp::session
