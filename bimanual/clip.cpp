// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/clip.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::bimanual {

namespace {

/// Keeps what lies between two planes across an axis.
bool keep_slab(double begin, double along, double half, ClippedPart& part) noexcept {
  if (along == 0.0) return std::abs(begin) <= half;
  double first = (-half - begin) / along;
  double last = (half - begin) / along;
  if (first > last) std::swap(first, last);
  part.from = std::max(part.from, first);
  part.to = std::min(part.to, last);
  return part.from < part.to;
}

/// Keeps what lies in a ball, or in the circle of a cylinder: |begin + t along| <= radius.
template <class Vector>
bool keep_round(const Vector& begin, const Vector& along, double radius,
                ClippedPart& part) noexcept {
  const double a = along.squaredNorm();
  const double c = begin.squaredNorm() - radius * radius;
  if (a == 0.0) return c <= 0.0;
  const double b = begin.dot(along);
  const double root = b * b - a * c;
  if (!(root > 0.0)) return false;
  const double width = std::sqrt(root);
  part.from = std::max(part.from, (-b - width) / a);
  part.to = std::min(part.to, (-b + width) / a);
  return part.from < part.to;
}

}  // namespace

std::optional<ClippedPart> clip(Shape shape, const Vec3& size_m, const Vec3& begin,
                                const Vec3& end) noexcept {
  const Vec3 along = end - begin;
  ClippedPart part;
  bool meets = true;
  switch (shape) {
    case Shape::box:
      for (Eigen::Index i = 0; i < 3 && meets; ++i)
        meets = keep_slab(begin[i], along[i], size_m[i] / 2.0, part);
      break;
    case Shape::sphere: meets = keep_round(begin, along, size_m.x() / 2.0, part); break;
    case Shape::cylinder:
      meets = keep_slab(begin.z(), along.z(), size_m.y() / 2.0, part) &&
              keep_round(Eigen::Vector2d(begin.head<2>()), Eigen::Vector2d(along.head<2>()),
                         size_m.x() / 2.0, part);
      break;
  }
  if (!meets) return std::nullopt;
  return part;
}

}  // namespace isograsp::bimanual
