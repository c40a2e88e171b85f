// SPDX-License-Identifier: GPL-3.0-or-later
// The squared distance of x(t) = a + t (b - a) from a convex object is convex in t and once
// differentiable: where its slope passes zero the segment is nearest. The slope does not decrease,
// so that bisection finds both ends of the part where it is zero.
#include "virtual_hand/capsule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "virtual_hand/overlap.hpp"

namespace isograsp::virtual_hand {

namespace {

/// Slopes below this share of the largest possible one are rounding: along parallel faces.
constexpr double kFlatSlope = 1e-13;

Vec3 nearest_in_box(const Vec3& p, const Vec3& half) noexcept {
  return p.cwiseMax(-half).cwiseMin(half);
}
Vec3 nearest_in_cylinder(const Vec3& p, const Vec3& half) noexcept {
  const double rho = std::hypot(p.x(), p.y());
  const double kept = rho > half.x() ? half.x() / rho : 1.0;
  return {kept * p.x(), kept * p.y(), std::clamp(p.z(), -half.z(), half.z())};
}
Vec3 nearest(const Vec3& p, const ObjectShape& shape) noexcept {
  return shape.kind == ObjectShape::Kind::box ? nearest_in_box(p, shape.half_m)
                                              : nearest_in_cylinder(p, shape.half_m);
}

/// Where the slope passes `level`, from below: the least t in [0, 1] with slope(t) >= level, to the
/// last bit.
template <class Slope>
double first_at_least(double level, const Slope& slope) noexcept {
  double below = 0.0;
  double above = 1.0;
  if (slope(below) >= level) return below;
  if (slope(above) < level) return above;
  while (true) {
    const double middle = 0.5 * (below + above);
    if (!(middle > below && middle < above)) return above;
    (slope(middle) >= level ? above : below) = middle;
  }
}

/// t of the point of the segment that is nearest to the object.
double nearest_along(const Capsule& capsule, const ObjectShape& shape) noexcept {
  const Vec3 d = capsule.b - capsule.a;
  const double reach =
      d.norm() * (std::max(capsule.a.norm(), capsule.b.norm()) + shape.half_m.norm());
  if (reach == 0.0) return 0.0;
  // Half the slope of the squared distance: the way out of the object times the way along.
  const auto slope = [&](double t) {
    const Vec3 p = capsule.a + t * d;
    return (p - nearest(p, shape)).dot(d);
  };
  const double flat = kFlatSlope * reach;
  const double first = first_at_least(-flat, slope);
  const double last = first_at_least(flat, slope);
  return 0.5 * (first + last);
}

}  // namespace

CapsuleContact capsule_contact(const Capsule& capsule, const ObjectShape& shape) noexcept {
  const double t = nearest_along(capsule, shape);
  const Vec3 p = capsule.a + t * (capsule.b - capsule.a);
  CapsuleContact contact;
  contact.point = nearest(p, shape);
  const Vec3 out = p - contact.point;
  const double distance_m = out.norm();
  // What lies nearer is in the object but for rounding.
  if (distance_m > std::numeric_limits<double>::epsilon() * shape.half_m.norm()) {
    contact.normal = -out / distance_m;
    contact.distance_m = distance_m - capsule.radius_m;
    return contact;
  }
  const LeastTranslation least = least_translation(capsule.a, capsule.b, shape);
  contact.deep = true;
  contact.normal = -least.direction;
  contact.distance_m = -least.way_m - capsule.radius_m;
  return contact;
}

}  // namespace isograsp::virtual_hand
