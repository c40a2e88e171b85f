// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that are exactly normal, where the tails of a distribution matter: the sum of uniforms
// that core/random.hpp gives has lighter ones.
#pragma once

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace isograsp::test {

/// Mean 0, standard deviation 1 (Box and Muller 1958).
[[nodiscard]] inline double normal(Random& random) {
  const double radius = std::sqrt(-2.0 * std::log1p(-random.uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * random.uniform());
}

}  // namespace isograsp::test
