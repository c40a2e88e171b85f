// SPDX-License-Identifier: GPL-3.0-or-later
// What all measures share: a number or the reason why there is none, and time grids.
// Measures are pure functions: same samples, same bits. Formulas and sources: docs/measures.md.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/text.hpp"

namespace isograsp::statistics {

/// The value of a measure, or why it has none.
struct Computed {
  Computed(double number) : value(number) {}      // NOLINT: a number is a result
  Computed(Text why) : reason(std::move(why)) {}  // NOLINT: so is a reason
  Computed(Words why) : reason(why) {}            // NOLINT
  std::optional<double> value;
  Text reason;
};

/// The time to an event, or the time waited for it if it did not come: right-censored.
struct EventTime {
  Computed time_s;
  std::optional<double> longer_than_s;  ///< set exactly when the event did not come
};

/// Times are sums and differences of grid times, each of them rounded: within this they are equal
/// [s]. Every comparison of times in a measure goes through the three functions below, so that no
/// row is won or lost by the last bit of a time.
inline constexpr double kTimeSlack_s = 1e-6;
[[nodiscard]] inline bool is_earlier(double a_s, double b_s) {
  return a_s < b_s - kTimeSlack_s;
}
/// First row that begins at `when_s` or later; t_s.size() if there is none. @pre times increase
[[nodiscard]] std::size_t first_row_from(std::span<const double> t_s, double when_s);
/// Rows [first, end).
struct RowRange {
  std::size_t first = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t count() const noexcept { return end - first; }
};
/// The rows that begin in [from_s, to_s). @pre times increase, from_s <= to_s
[[nodiscard]] RowRange rows_between(std::span<const double> t_s, double from_s, double to_s);

/// True if every step equals the first within 4 ulp of the largest |t| (docs/file_formats.md).
/// @pre times increase strictly
[[nodiscard]] bool is_regular(std::span<const double> t_s);

/// How long each row holds [s]: exactly t_1 - t_0 on a regular grid, else its own difference, the
/// last as the one before. One row or none: zero.
[[nodiscard]] std::vector<double> hold_lengths(std::span<const double> t_s);

/// The usual step [s]: their median. Zero for fewer than two rows.
[[nodiscard]] double median_step(std::span<const double> t_s);

/// Rows [first, end) and how long they hold together [s].
struct Stretch {
  std::size_t first = 0;
  std::size_t end = 0;
  double length_s = 0.0;
};
/// The longest possible runs of rows with `inside` that hold for at least `least_s`, in order. A
/// hole of more than two and a half usual steps ends a run: what was not measured proves nothing.
/// The last row of a run holds for one usual step.
[[nodiscard]] std::vector<Stretch> stretches(std::span<const double> t_s,
                                             const std::vector<bool>& inside, double least_s);

/// Where the line from row k - 1 to row k reaches `level` [s]. @pre k > 0, x differs in the two
[[nodiscard]] double crossing_time(std::span<const double> t_s, std::span<const double> x,
                                   std::size_t k, double level);

/// Samples on a strict grid.
struct UniformSamples {
  double step_s = 0.0;
  std::vector<double> values;
};
/// The samples themselves if their times are regular, else resampled linearly at the median step
/// from the first time on. @pre t_s.size() == values.size() and at least two rows
[[nodiscard]] UniformSamples on_uniform_grid(std::span<const double> t_s,
                                             std::span<const double> values);
/// 0, step, 2 step, ... for these samples [s].
[[nodiscard]] std::vector<double> grid_times(const UniformSamples& samples);

}  // namespace isograsp::statistics
