// SPDX-License-Identifier: GPL-3.0-or-later
// How well a force is found again without seeing it.
#pragma once

#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Errors e = reproduced - target, one per repetition, version 1, unit of force. (Schmidt's three)
struct ForceSense {
  statistics::Computed constant_error;  ///< mean of e; positive: too strong
  statistics::Computed absolute_error;  ///< mean of |e|
  statistics::Computed variable_error;  ///< SD(n - 1) of e; needs two repetitions
};
/// @pre equal lengths
[[nodiscard]] ForceSense force_sense(std::span<const double> target,
                                     std::span<const double> reproduced);

}  // namespace isograsp::tasks
