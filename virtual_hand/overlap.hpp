// SPDX-License-Identifier: GPL-3.0-or-later
// The least translation that takes a segment out of an object: the depth of what overlaps. Object
// frame, SI units. Pure, without allocation: real-time safe.
#pragma once

#include "virtual_hand/capsule.hpp"

namespace isograsp::virtual_hand {

struct LeastTranslation {
  Vec3 direction = Vec3::UnitZ();  ///< out of the object, unit vector
  double way_m = 0.0;
};

/// Of the segment from `a` to `b`. Box: exact, by the faces of the Minkowski sum (face normals, and
/// edge times segment). Cylinder: caps, radial directions of both ends, and the best of all
/// directions perpendicular to the segment.
[[nodiscard]] LeastTranslation least_translation(const Vec3& a, const Vec3& b,
                                                 const ObjectShape& shape) noexcept;

}  // namespace isograsp::virtual_hand
