// SPDX-License-Identifier: GPL-3.0-or-later
// How regular a signal is. Uniform grids only; see on_uniform_grid().
#pragma once

#include <cstdint>
#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Pairs of templates (i < j) that match: length m (B) and m + 1 (A).
struct TemplateMatches {
  std::int64_t longer = 0;   ///< A
  std::int64_t shorter = 0;  ///< B
};
/// m = 2, r = 0.2 population SD, Chebyshev distance <= r, N - m templates for both lengths.
[[nodiscard]] TemplateMatches template_matches(std::span<const double> x);
/// Sample entropy, version 1, dimensionless: -ln(A / B). Not detrended; lower is more regular.
[[nodiscard]] statistics::Computed sample_entropy(std::span<const double> x);

}  // namespace isograsp::tasks
