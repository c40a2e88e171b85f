// SPDX-License-Identifier: GPL-3.0-or-later
// The mean of finite numbers is finite, even if their sum overflows.
#pragma once

#include <span>

namespace isograsp {

/// Sum / count, in order; if the sum overflows, of the values in smaller units. Never beyond the
/// smallest and the largest of them by more than rounding. @pre not empty, all finite
[[nodiscard]] double arithmetic_mean(std::span<const double> values);

}  // namespace isograsp
