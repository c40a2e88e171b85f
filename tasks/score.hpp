// SPDX-License-Identifier: GPL-3.0-or-later
// All measures of one trial, from its signals alone: the same call live, offline and in the report.
#pragma once

#include <vector>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

/// The measures of this task. Columns used (those a task needs, see docs/measures.md): t_s, phase,
/// sample_flags (non-zero: excluded), target_* and actual_* pairs, resting_force_N, finger forces.
/// Pure: same signals, same numbers, bit for bit.
[[nodiscard]] std::vector<Measure> score(const TaskSpec& spec, const Signals& signals);

/// Without a task: every pair target_X, actual_X, whole record, default parameters
/// (docs/measures.md).
[[nodiscard]] std::vector<Measure> score_pairs(const Signals& signals);

}  // namespace isograsp::tasks
