// SPDX-License-Identifier: GPL-3.0-or-later
// A mean of finite numbers is a finite number, though their sum may be none.
#pragma once

#include <span>

namespace isograsp {

/// Sum / count, in order; where the sum is too large for a number, of the values in smaller units.
/// Never beyond the smallest and the largest of them by more than rounding. @pre not empty, all
/// finite
[[nodiscard]] double arithmetic_mean(std::span<const double> values);

}  // namespace isograsp
