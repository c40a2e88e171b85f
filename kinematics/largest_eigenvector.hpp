// SPDX-License-Identifier: GPL-3.0-or-later
// The eigenvector of the largest eigenvalue of a symmetric 4 x 4 matrix: the best attitude of a
// rigid body and the mean of attitudes are both such a vector.
#pragma once

#include "core/spatial.hpp"

namespace isograsp {

using Mat4 = Eigen::Matrix4d;
using Vec4 = Eigen::Vector4d;

/// Of length 1, with any sign. Two equal largest eigenvalues: one of their vectors. Real-time:
/// fixed size, nothing allocated. @pre n is symmetric and finite
[[nodiscard]] Vec4 largest_eigenvector(const Mat4& n) noexcept;

}  // namespace isograsp
