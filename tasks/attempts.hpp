// SPDX-License-Identifier: GPL-3.0-or-later
// Whether several attempts at one thing agree, so that no further one is needed.
#pragma once

#include <cstdint>
#include <span>

namespace isograsp::tasks {

/// Which two attempts must agree: the best of an assessment, the last of practice.
enum class Compared : std::uint8_t { best_two, last_two };

/// They differ by at most `percent` of the larger. Fewer than two never agree.
[[nodiscard]] bool attempts_agree(std::span<const double> attempts, double percent,
                                  Compared compared);

}  // namespace isograsp::tasks
