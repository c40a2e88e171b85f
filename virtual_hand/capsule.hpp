// SPDX-License-Identifier: GPL-3.0-or-later
// Distance of a capsule (a segment with a radius) from a box or a cylinder (Delrieu et al.,
// phalanges as capsules; docs/virtual_hand.md). Object frame O: origin at its centre, cylinder
// along z. SI units. Pure, without allocation: real-time safe.
#pragma once

#include <cstdint>

#include "core/spatial.hpp"

namespace isograsp::virtual_hand {

struct Capsule {
  Vec3 a = Vec3::Zero();  ///< ends of its segment [m]
  Vec3 b = Vec3::Zero();
  double radius_m = 0.0;
};

struct ObjectShape {
  enum class Kind : std::uint8_t { box, cylinder };
  Kind kind = Kind::box;
  Vec3 half_m = Vec3::Zero();  ///< box: half edges; cylinder: radius, radius, half length
};

/// How far a capsule is from an object.
struct CapsuleContact {
  double distance_m = 0.0;  ///< of the surfaces; negative: they overlap
  /// Into the object, unit vector: from the segment to the nearest point; where the segment itself
  /// is in the object, against the least translation that frees it.
  Vec3 normal = Vec3::Zero();
  Vec3 point = Vec3::Zero();  ///< of the object, nearest to the segment [m]
  bool deep = false;          ///< the segment itself meets the object
};

/// Exact for boxes and, but for the last bits of an iteration, for cylinders. A segment that is
/// equally near along a part of it touches in the middle of that part.
[[nodiscard]] CapsuleContact capsule_contact(const Capsule& capsule,
                                             const ObjectShape& shape) noexcept;

}  // namespace isograsp::virtual_hand
