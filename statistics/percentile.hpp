// SPDX-License-Identifier: GPL-3.0-or-later
// Values by rank.
#pragma once

#include <span>

#include "statistics/samples.hpp"

namespace isograsp::statistics {

/// Percentile, version 1, unit of x: of the sorted values x_0 ... x_n-1 the one at position
/// (n - 1) percent / 100, interpolated linearly between neighbours. (Definition 7 of Hyndman & Fan
/// 1996) @pre 0 <= percent <= 100, x finite
[[nodiscard]] Computed percentile(std::span<const double> x, double percent);
/// The 50th percentile.
[[nodiscard]] Computed median(std::span<const double> x);

}  // namespace isograsp::statistics
