// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/kinds/two_hands/ only: when an object is lifted, live and in its measures.
#pragma once

namespace isograsp::tasks {

/// Higher above where it began it is off its rest.
inline constexpr double kOffRest_m = 0.01;

}  // namespace isograsp::tasks
