// SPDX-License-Identifier: GPL-3.0-or-later
// How measures are called and printed: words for people, units for people.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

enum class Better : std::uint8_t { unknown, lower, higher, near_zero };

struct MeasureWords {
  Text title;                       ///< "Tracking error, relative"
  Better better = Better::unknown;  ///< empty if more is neither better nor worse
  bool clinical = false;            ///< all others belong to research exports
  bool censored = false;            ///< a trial without value took longer than was waited: its
                                    ///< session has no mean
  bool error_grows = true;          ///< its error is taken to grow with its mean
  bool below_zero = false;          ///< a worse or better value can lie below zero
};
/// Words for a measure, with those for its channel: "Maximum force above rest, thumb opening". An
/// unknown one is called by its own name.
[[nodiscard]] MeasureWords words_of(std::string_view name, std::string_view channel);
/// Names of all measures that have words here, in the order of the report.
[[nodiscard]] std::vector<std::string_view> worded_measures();

/// Stored unit -> printed unit: rad -> degrees, m -> mm; all else as it is.
struct PrintedUnit {
  std::string text;
  double factor = 1.0;
};
[[nodiscard]] PrintedUnit printed_unit(const std::string& unit);

/// Units that are words: "of 5", "blocks"; the others are the same everywhere.
[[nodiscard]] Text unit_words(const std::string& printed_unit);

/// Three significant digits in the printed unit, without the unit: "12.3", "0.185", "−4.20".
[[nodiscard]] std::string format_value(double value, const std::string& unit);
/// The same with an explicit sign.
[[nodiscard]] std::string format_change(double value, const std::string& unit);

/// Where the report shows a measure of a task (KindFacts::places).
struct Place {
  Prominence prominence = Prominence::none;
  int rank = 0;
};
[[nodiscard]] Place place_of(const std::optional<TaskSpec>& spec, std::string_view name,
                             std::string_view channel);

}  // namespace isograsp::tasks
