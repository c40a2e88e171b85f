// SPDX-License-Identifier: GPL-3.0-or-later
// Where the object really is: slow, high-order, in more digits than double; shares no formula with
// the product. Linear degrees of freedom: matrix exponential in 113 bits. Three rotations (and a
// force that turns with them): Runge-Kutta-Fehlberg 7(8) in 64 bits with many steps a hold.
#pragma once

#include "bench/case.hpp"

namespace isograsp::bench {

/// Fills scene.reference and the excursions from body, start and pushes.
void add_reference(Case& scene);

}  // namespace isograsp::bench
