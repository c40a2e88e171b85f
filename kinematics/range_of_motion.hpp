// SPDX-License-Identifier: GPL-3.0-or-later
// Active range of motion: how far a link's angle goes, at once and held.
#pragma once

#include <optional>
#include <span>

namespace isograsp {

/// Extremes [rad]; nothing where there is no value.
struct Range {
  std::optional<double> min_rad;
  std::optional<double> max_rad;
  /// Of the mean over +-0.1 s about a row, so that one bad row makes no range.
  std::optional<double> min_held_rad;
  std::optional<double> max_held_rad;
};

/// `angle_rad`: one for each row, missing ones NaN. Held means count only where their window lies
/// inside the record and misses no row. @pre times increase strictly, equal sizes
[[nodiscard]] Range range_of_motion(std::span<const double> t_s, std::span<const double> angle_rad);

}  // namespace isograsp
