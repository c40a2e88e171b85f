// SPDX-License-Identifier: GPL-3.0-or-later
// All measures of one trial, from its signals alone: the same call live, offline and in the report.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "core/measure.hpp"
#include "core/signals.hpp"
#include "hand/hands.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

class Record;
enum class Phase : std::uint8_t;

/// The measures of this task. Columns used (those a task needs, see docs/measures.md): t_s, phase,
/// sample_flags (non-zero: excluded), target_* and actual_* pairs, resting_force_N, finger forces.
/// Pure: same signals, same numbers, bit for bit.
[[nodiscard]] std::vector<Measure> score(const TaskSpec& spec, const Signals& signals);

/// Without a task: every pair target_X, actual_X, whole record, default parameters
/// (docs/measures.md).
[[nodiscard]] std::vector<Measure> score_pairs(const Signals& signals);

/// Whose record of two hands it is, and what each of them can do.
struct TwoHandsContext {
  std::optional<Hand> affected = Hand::left;      ///< nothing: not known, both or neither
  OfHands<std::optional<double>> maximum_N = {};  ///< of each hand alone; nothing: not known
  /// Taken off the forces before they are compared. Nothing: they are taken as they stand; nothing
  /// of a hand: it was not measured, and there are no shares.
  std::optional<OfHands<std::optional<double>>> resting_N = std::nullopt;
  /// The platforms move each other: there are no shares.
  bool coupled = false;
};

/// Two hands that press at the same time: `left_force_N`, `right_force_N`, and where they are there
/// `target_sum_force_N`, `target_left_force_N`, `target_right_force_N` and the pushes
/// `left_push_x_N` … `right_push_z_N`. Whole record (docs/measures.md, Two hands). Empty: a column
/// of force is missing. @pre maxima are above zero
[[nodiscard]] std::vector<Measure> score_two_hands(const Signals& signals,
                                                   const TwoHandsContext& context);

// Inside tasks/ only.
/// The same over the rows of `phases`; none: the whole record. @pre both forces are columns of it
[[nodiscard]] std::vector<Measure> score_hands(const Record& record, const TwoHandsContext& context,
                                               std::initializer_list<Phase> phases);
/// What a trial of a session stores beside its signals: affected side, maxima, resting forces, and
/// whether its platforms move each other.
[[nodiscard]] TwoHandsContext hands_context(const Record& record);

}  // namespace isograsp::tasks
