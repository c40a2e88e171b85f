// SPDX-License-Identifier: GPL-3.0-or-later
// What several attempts at a maximum are worth together.
#pragma once

#include <span>

#include "tasks/measures/samples.hpp"

namespace isograsp {

/// The strongest attempt, version 1, unit of force.
[[nodiscard]] Computed best_attempt(std::span<const double> attempts);
/// Mean of all attempts, version 1, unit of force.
[[nodiscard]] Computed mean_of_attempts(std::span<const double> attempts);
/// Difference of the best two, version 1, in % of the best. Needs two attempts and force.
[[nodiscard]] Computed best_two_difference(std::span<const double> attempts);
/// The best two differ by at most 10 %: no further attempt is needed.
[[nodiscard]] bool attempts_agree(std::span<const double> attempts);
/// A later force exceeds the best attempt by more than 10 %: that was no maximum.
[[nodiscard]] bool is_submaximal(std::span<const double> attempts, double later);

}  // namespace isograsp
