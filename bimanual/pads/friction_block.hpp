// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of one block with the others held still: the force of greatest dissipation in an
// ellipsoid, by its secular equation.
#pragma once

#include "core/spatial.hpp"

namespace isograsp::bimanual {

/// The slip is u = slip_free - W f. The f within the ellipsoid of half axes `limits` that lets
/// nothing slip or, if there is none, the one on it whose outward normal is the slip that is left.
/// A limit of 0 bears nothing. @pre W is symmetric, not negative
[[nodiscard]] Vec3 friction_in_ellipsoid(const Mat3& W, const Vec3& slip_free, const Vec3& limits);

}  // namespace isograsp::bimanual
