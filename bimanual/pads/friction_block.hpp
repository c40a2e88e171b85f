// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of one block with the others held still: the force of greatest dissipation in an
// ellipsoid, by its secular equation. 2 or 3 rows.
#pragma once

#include <Eigen/Core>

namespace isograsp::bimanual {

/// The slip is u = slip_free - W f. The f within the ellipsoid of half axes `limits` that lets
/// nothing slip or, if there is none, the one on it whose outward normal is the slip that is left.
/// A limit of 0 bears nothing. @pre W is symmetric, not negative
template <int N>
[[nodiscard]] Eigen::Matrix<double, N, 1> friction_in_ellipsoid(
    const Eigen::Matrix<double, N, N>& W, const Eigen::Matrix<double, N, 1>& slip_free,
    const Eigen::Matrix<double, N, 1>& limits);
extern template Eigen::Vector2d friction_in_ellipsoid<2>(const Eigen::Matrix2d&,
                                                         const Eigen::Vector2d&,
                                                         const Eigen::Vector2d&);
extern template Eigen::Vector3d friction_in_ellipsoid<3>(const Eigen::Matrix3d&,
                                                         const Eigen::Vector3d&,
                                                         const Eigen::Vector3d&);

}  // namespace isograsp::bimanual
