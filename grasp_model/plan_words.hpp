// SPDX-License-Identifier: GPL-3.0-or-later
// The plan in words: what was chosen, why, how exact it is and what it costs. Not for the real-time
// path.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grasp_model/plan.hpp"

namespace isograsp {

/// Pairs of a name (a JSON key) and words.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> words_of(const Plan& plan);

/// Additions, multiplications, divisions and roots of Plan::step with all fingers pressing within
/// their cones; three free rotations: in one step a hold.
[[nodiscard]] int flops_per_frame(const Plan& plan);

}  // namespace isograsp
