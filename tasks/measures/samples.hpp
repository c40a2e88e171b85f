// SPDX-License-Identifier: GPL-3.0-or-later
// What all measures share: a number or the reason why there is none, and time grids.
// Measures are pure functions: same samples, same bits. Formulas and sources: docs/measures.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isograsp {

/// The value of a measure, or why it has none.
struct Computed {
  Computed(double number) : value(number) {}             // NOLINT: a number is a result
  Computed(std::string why) : reason(std::move(why)) {}  // NOLINT: so is a reason
  Computed(const char* why) : reason(why) {}             // NOLINT
  std::optional<double> value;
  std::string reason;
};

/// True if every step equals the first within 4 ulp of the largest |t| (docs/file_formats.md).
/// @pre times increase strictly
[[nodiscard]] bool is_regular(std::span<const double> t_s);

/// How long each row holds [s]: exactly t_1 - t_0 on a regular grid, else its own difference, the
/// last as the one before. One row or none: zero.
[[nodiscard]] std::vector<double> hold_lengths(std::span<const double> t_s);

/// Samples on a strict grid.
struct UniformSamples {
  double step_s = 0.0;
  std::vector<double> values;
};
/// The samples themselves if their times are regular, else resampled linearly at the median step
/// from the first time on. @pre t_s.size() == values.size() and at least two rows
[[nodiscard]] UniformSamples on_uniform_grid(std::span<const double> t_s,
                                             std::span<const double> values);

}  // namespace isograsp
