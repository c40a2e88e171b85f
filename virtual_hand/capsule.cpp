// SPDX-License-Identifier: GPL-3.0-or-later
// The squared distance of x(t) = a + t (b - a) from a convex object is convex in t and once
// differentiable: where its slope passes zero the segment is nearest. The slope does not decrease.
// For a box it is linear between at most six places where a coordinate passes a face: exact. For a
// cylinder a safeguarded Newton iteration finds both ends of the part where it is zero.
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

/// Half the slope of the squared distance, and how it rises.
struct Slope {
  double value = 0.0;
  double rise = 0.0;  ///< 0 on the side where nothing counts
};

/// Along one segment, as a function of t in [0, 1].
class SlopeAlong {
 public:
  SlopeAlong(const Capsule& capsule, const ObjectShape& shape) noexcept
      : a_(capsule.a), d_(capsule.b - capsule.a), half_(shape.half_m) {}

  [[nodiscard]] double of_box(double t) const noexcept {
    const Vec3 p = a_ + t * d_;
    return (p - nearest_in_box(p, half_)).dot(d_);
  }
  [[nodiscard]] Slope of_cylinder(double t) const noexcept {
    const Vec3 p = a_ + t * d_;
    Slope slope;
    const double over = p.z() - std::clamp(p.z(), -half_.z(), half_.z());
    if (over != 0.0) slope = {over * d_.z(), d_.z() * d_.z()};
    const double rho = std::hypot(p.x(), p.y());
    if (rho > half_.x()) {
      const double along = p.head<2>().dot(d_.head<2>());
      const double kept = half_.x() / rho;
      slope.value += (1.0 - kept) * along;
      slope.rise +=
          (1.0 - kept) * d_.head<2>().squaredNorm() + kept * (along / rho) * (along / rho);
    }
    return slope;
  }

  /// Where a coordinate passes a face, in rising order; only what lies within (0, 1).
  [[nodiscard]] std::size_t breaks(std::array<double, 6>& at) const noexcept {
    std::size_t count = 0;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      for (const double face : {-half_[axis], half_[axis]}) {
        const double t = (face - a_[axis]) / d_[axis];
        if (!(t > 0.0 && t < 1.0)) continue;
        std::size_t place = count++;
        for (; place > 0 && at[place - 1] > t; --place) at[place] = at[place - 1];
        at[place] = t;
      }
    return count;
  }

 private:
  Vec3 a_;
  Vec3 d_;
  Vec3 half_;
};

/// Middle of the part of a segment where the slope is between -flat and flat, beside a box.
double middle_beside_box(const SlopeAlong& slope, double flat) noexcept {
  std::array<double, 6> breaks{};
  const std::size_t count = slope.breaks(breaks);
  std::array<double, 2> ends{1.0, 1.0};  // where it passes -flat, where it passes flat
  const std::array<double, 2> levels{-flat, flat};
  std::size_t found = 0;
  double t0 = 0.0;
  double s0 = slope.of_box(0.0);
  for (; found < 2 && s0 >= levels[found]; ++found) ends[found] = 0.0;
  for (std::size_t k = 0; k <= count && found < 2; ++k) {
    const double t1 = k < count ? breaks[k] : 1.0;
    const double s1 = slope.of_box(t1);
    for (; found < 2 && s1 >= levels[found]; ++found)
      ends[found] = t0 + (levels[found] - s0) / (s1 - s0) * (t1 - t0);
    t0 = t1;
    s0 = s1;
  }
  return 0.5 * (ends[0] + ends[1]);
}

/// Where the slope beside a cylinder passes `level`, between `below` and 1: Newton, and halving
/// where Newton does not shrink its step by half.
double passes_beside_cylinder(const SlopeAlong& slope, double level, double below) noexcept {
  Slope now = slope.of_cylinder(below);
  if (now.value >= level) return below;
  double above = 1.0;
  if (slope.of_cylinder(above).value < level) return above;
  double t = below;
  double last_step = above - below;
  constexpr int kMost = 120;  // halvings alone: 53
  for (int k = 0; k < kMost; ++k) {
    double next = t - (now.value - level) / now.rise;
    double step = std::abs(next - t);
    if (!(next > below && next < above && step <= 0.5 * last_step)) {
      next = 0.5 * (below + above);
      step = 0.5 * (above - below);
      if (!(next > below && next < above)) return above;
    }
    last_step = step;
    if (next == t) return t;
    t = next;
    now = slope.of_cylinder(t);
    (now.value >= level ? above : below) = t;
  }
  return t;
}

/// t of the point of the segment that is nearest to the object.
double nearest_along(const Capsule& capsule, const ObjectShape& shape) noexcept {
  const Vec3 d = capsule.b - capsule.a;
  const double reach =
      d.norm() * (std::max(capsule.a.norm(), capsule.b.norm()) + shape.half_m.norm());
  if (reach == 0.0) return 0.0;
  const SlopeAlong slope(capsule, shape);
  const double flat = kFlatSlope * reach;
  if (shape.kind == ObjectShape::Kind::box) return middle_beside_box(slope, flat);
  const double first = passes_beside_cylinder(slope, -flat, 0.0);
  return 0.5 * (first + passes_beside_cylinder(slope, flat, first));
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
