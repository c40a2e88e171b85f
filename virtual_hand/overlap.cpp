// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isograsp::virtual_hand {

namespace {

/// How far the object reaches along n (support function), n a unit vector.
double reach(const ObjectShape& shape, const Vec3& n) noexcept {
  const Vec3& half = shape.half_m;
  if (shape.kind == ObjectShape::Kind::box) return half.dot(n.cwiseAbs());
  return half.x() * std::hypot(n.x(), n.y()) + half.z() * std::abs(n.z());
}

class LeastOf {
 public:
  LeastOf(const Vec3& a, const Vec3& b, const ObjectShape& shape) noexcept
      : a_(a), b_(b), shape_(shape) {
    least_.way_m = std::numeric_limits<double>::infinity();
  }

  /// How far the segment must go along n until none of it is in the object.
  [[nodiscard]] double way(const Vec3& n) const noexcept {
    return reach(shape_, n) - std::min(a_.dot(n), b_.dot(n));
  }
  /// Both directions of an axis; one without length says nothing.
  void consider(const Vec3& axis) noexcept {
    const double length = axis.norm();
    if (!(length > 0.0)) return;
    for (const Vec3& n : {Vec3(axis / length), Vec3(-axis / length)})
      if (const double way_m = way(n); way_m < least_.way_m) least_ = {n, way_m};
  }
  [[nodiscard]] const LeastTranslation& least() const noexcept { return least_; }

 private:
  const Vec3& a_;
  const Vec3& b_;
  const ObjectShape& shape_;
  LeastTranslation least_;
};

/// The best of all directions u cos + v sin: the least of a grid, then golden section around it.
void consider_circle(LeastOf& least, const Vec3& u, const Vec3& v) noexcept {
  constexpr int kGrid = 72;
  constexpr double kStep = 2.0 * std::numbers::pi / kGrid;
  constexpr int kSections = 60;  // the bracket shrinks to 1e-12 of a step
  const auto at = [&](double angle) { return Vec3(std::cos(angle) * u + std::sin(angle) * v); };
  int best = 0;
  for (int k = 1; k < kGrid; ++k)
    if (least.way(at(k * kStep)) < least.way(at(best * kStep))) best = k;
  double from = (best - 1) * kStep;
  double to = (best + 1) * kStep;
  constexpr double kGolden = std::numbers::phi - 1.0;
  for (int k = 0; k < kSections; ++k) {
    const double left = to - kGolden * (to - from);
    const double right = from + kGolden * (to - from);
    if (least.way(at(left)) < least.way(at(right)))
      to = right;
    else
      from = left;
  }
  least.consider(at(0.5 * (from + to)));
}

}  // namespace

LeastTranslation least_translation(const Vec3& a, const Vec3& b,
                                   const ObjectShape& shape) noexcept {
  LeastOf least(a, b, shape);
  const Vec3 d = b - a;
  least.consider(Vec3::UnitZ());
  if (shape.kind == ObjectShape::Kind::box) {
    for (const Vec3& edge : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      least.consider(edge);
      least.consider(edge.cross(d));
    }
    return least.least();
  }
  for (const Vec3& end : {a, b}) least.consider({end.x(), end.y(), 0.0});
  least.consider(Vec3::UnitX());  // an end on the axis: all radial directions are alike
  if (const double length = d.norm(); length > 0.0) {
    const Vec3 along = d / length;
    const Vec3 u = along.unitOrthogonal();
    consider_circle(least, u, along.cross(u));
  }
  return least.least();
}

}  // namespace isograsp::virtual_hand
