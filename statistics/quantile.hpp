// SPDX-License-Identifier: GPL-3.0-or-later
// Quantiles of weighted values.
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::statistics {

/// Weighted quantile, version 1, unit of x: the smallest value that has at least `share` (0 … 1] of
/// the whole weight at or below it. Values without weight do not count.
[[nodiscard]] Computed quantile(std::span<const double> x, std::span<const double> weight,
                                double share);

}  // namespace isograsp::statistics
