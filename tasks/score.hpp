// SPDX-License-Identifier: GPL-3.0-or-later
// All measures of one trial, from its signals alone: the same call live, offline and in the report.
#pragma once

#include <optional>
#include <vector>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "hand/finger.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

/// The measures of this task. Columns used (those a task needs, see docs/measures.md): t_s, phase,
/// sample_flags (non-zero: excluded), target_* and actual_* pairs, resting_force_N, finger forces.
/// Pure: same signals, same numbers, bit for bit.
[[nodiscard]] std::vector<Measure> score(const TaskSpec& spec, const Signals& signals);

/// Without a task: every pair target_X, actual_X, whole record, default parameters
/// (docs/measures.md).
[[nodiscard]] std::vector<Measure> score_pairs(const Signals& signals);

/// Whose record of two hands it is, and what each of them can do.
struct TwoHandsContext {
  Hand affected = Hand::left;
  std::optional<double> maximum_left_N = std::nullopt;
  std::optional<double> maximum_right_N = std::nullopt;
};

/// Two hands that press at the same time: `left_force_N`, `right_force_N`, and where they are there
/// `target_sum_force_N`, `target_left_force_N`, `target_right_force_N` and the pushes
/// `left_push_x_N` … `right_push_z_N`. Whole record (docs/measures.md, Two hands). Empty: a column
/// of force is missing. @pre maxima are above zero
[[nodiscard]] std::vector<Measure> score_two_hands(const Signals& signals,
                                                   const TwoHandsContext& context);

}  // namespace isograsp::tasks
