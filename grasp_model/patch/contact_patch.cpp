// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/patch/contact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace isograsp {

namespace {

/// Rounding of a length in steps of rings makes no further ring.
constexpr double kRingSlack = 1e-9;
/// More are no finer picture of a finger, only slower.
constexpr int kMostRays = 100000;
constexpr int kMostRings = 10000;

Result<void> check_pad(const Pad& pad) {
  const auto bad = [](Text what) {
    return refused(std::move(what), "correct it"_text).about("pad");
  };
  const auto is_positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  if (!is_positive(pad.semi_x_m) || !is_positive(pad.semi_y_m))
    return bad("its semi-axes are no positive lengths"_text);
  if (pad.rays < 3 || pad.rays > kMostRays || pad.rings < 1 || pad.rings > kMostRings)
    return bad("it needs 3 to %1 rays and 1 to %2 rings"_text(kMostRays, kMostRings));
  if (!is_positive(pad.friction)) return bad("its friction is no positive number"_text);
  if (!(pad.depth_m >= 0.0)) return bad("its depth is negative"_text);
  return {};
}

double angle_of(std::size_t ray, std::size_t rays) noexcept {
  return 2.0 * std::numbers::pi * static_cast<double>(ray) / static_cast<double>(rays);
}
Vec2 direction(double angle_rad) noexcept {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

}  // namespace

Result<PatchFrame> PatchFrame::along(const Vec3& p, const Vec3& normal, const Vec3& tangent) {
  constexpr double kLeastSine = 1e-6;  // between normal and tangent
  PatchFrame frame;
  frame.p = p;
  if (!(normal.norm() > 0.0) || !normal.allFinite())
    return refused("is no direction"_text, "write three numbers, not all zero"_text)
        .about("normal");
  frame.normal = normal.normalized();
  const Vec3 across = frame.normal.cross(tangent);
  if (!(across.norm() > kLeastSine * tangent.norm()) || !tangent.allFinite())
    return refused("is no direction beside the normal"_text, "write another one"_text)
        .about("tangent");
  frame.y = across.normalized();
  frame.x = frame.y.cross(frame.normal);
  return frame;
}

PadReach reach_of_ray(const Pad& pad, int ray) noexcept {
  const double angle_rad =
      angle_of(static_cast<std::size_t>(ray), static_cast<std::size_t>(pad.rays));
  return {angle_rad,
          pad.semi_x_m * pad.semi_y_m /
              std::hypot(pad.semi_y_m * std::cos(angle_rad), pad.semi_x_m * std::sin(angle_rad))};
}

Result<ContactPatch> scan_patch(const PatchSurface& surface, const PatchFrame& frame,
                                const Pad& pad) {
  if (auto good = check_pad(pad); !good) return good.error();
  const auto rays = surface.rays(frame, pad);
  if (!rays) return rays.error();
  return patch_of(*rays, pad);
}

std::vector<PressedPoint> elements_of(std::span<const PatchRay> rays, const Pad& pad) {
  std::vector<PressedPoint> elements;
  const double sector_rad = 2.0 * std::numbers::pi / static_cast<double>(rays.size());
  for (std::size_t j = 0; j < rays.size(); ++j) {
    const Vec2 outward = direction(angle_of(j, rays.size()));
    for (const RayPiece& piece : rays[j].pieces) {
      const double length_m = piece.to_m - piece.from_m;
      if (!(length_m > 0.0)) continue;
      const int steps = std::max(
          1, static_cast<int>(std::ceil(pad.rings * length_m / rays[j].limit_m - kRingSlack)));
      for (int step = 0; step < steps; ++step) {
        const double a = piece.from_m + length_m * step / steps;
        const double b = piece.from_m + length_m * (step + 1) / steps;
        // (b³ - a³) / (b² - a²), without the difference of near equals.
        const double radius_m = 2.0 / 3.0 * (a * a + a * b + b * b) / (a + b);
        elements.push_back({radius_m * outward, sector_rad * (b - a) * (b + a) / 2.0});
      }
    }
  }
  return elements;
}

ContactPatch patch_of(std::span<const PatchRay> rays, const Pad& pad) {
  ContactPatch patch;
  for (std::size_t j = 0; j < rays.size(); ++j) {
    ++patch.stopped[static_cast<std::size_t>(rays[j].stop)];
    const double end_m = rays[j].pieces.empty() ? 0.0 : rays[j].pieces.back().to_m;
    patch.outline_m.push_back(end_m * direction(angle_of(j, rays.size())));
  }
  std::vector<PressedPoint> points = elements_of(rays, pad);
  patch.elements = points.size();
  for (const PressedPoint& point : points) patch.area_m2 += point.share;
  if (!(patch.area_m2 > 0.0)) return patch;
  for (PressedPoint& point : points) {
    point.share /= patch.area_m2;
    patch.centroid_m += point.share * point.p_m;
  }
  patch.torsion_m = pad.friction * mean_distance(points, patch.centroid_m);
  patch.pure_torsion_limit_m = pad.friction * mean_distance(points, geometric_median(points));
  return patch;
}

double mean_distance(std::span<const PressedPoint> points, const Vec2& from) noexcept {
  double sum_m = 0.0;
  for (const PressedPoint& point : points) sum_m += point.share * (point.p_m - from).norm();
  return sum_m;
}

namespace {

/// Where one step from `from` towards the median ends: Newton's, or Weiszfeld's where that is
/// nearer to it. `from` may lie on a point, which then pulls in no direction.
Vec2 step_to_median(std::span<const PressedPoint> points, const Vec2& from) noexcept {
  Vec2 weighted = Vec2::Zero();
  Vec2 pull = Vec2::Zero();  // as if all were springs of constant force
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  double weight = 0.0;
  for (const PressedPoint& point : points) {
    const Vec2 to = point.p_m - from;
    const double distance_m = to.norm();
    if (distance_m == 0.0) continue;
    const double w = point.share / distance_m;
    const Vec2 across(-to.y() / distance_m, to.x() / distance_m);
    weight += w;
    weighted += w * point.p_m;
    pull += w * to;
    stiffness += w * across * across.transpose();
  }
  if (weight == 0.0) return from;
  const Vec2 weiszfeld = weighted / weight;
  const double determinant = stiffness.determinant();
  if (!(determinant > 0.0)) return weiszfeld;
  const Vec2 newton = from + stiffness.inverse() * pull;
  return mean_distance(points, newton) < mean_distance(points, weiszfeld) ? newton : weiszfeld;
}

/// A point that carries so much that all others together cannot pull the median off it.
const PressedPoint* heaviest_at_median(std::span<const PressedPoint> points) noexcept {
  for (const PressedPoint& one : points) {
    Vec2 pull = Vec2::Zero();
    double share = 0.0;
    for (const PressedPoint& other : points) {
      const Vec2 to = other.p_m - one.p_m;
      const double distance_m = to.norm();
      if (distance_m > 0.0)
        pull += other.share / distance_m * to;
      else
        share += other.share;
    }
    if (pull.norm() <= share) return &one;
  }
  return nullptr;
}

}  // namespace

Vec2 geometric_median(std::span<const PressedPoint> points) {
  constexpr int kMostSteps = 200;
  constexpr std::size_t kFew = 256;  // of more, none carries so much that it matters
  if (points.empty()) return Vec2::Zero();
  if (points.size() <= kFew)
    if (const PressedPoint* const heaviest = heaviest_at_median(points)) return heaviest->p_m;
  Vec2 at = Vec2::Zero();
  for (const PressedPoint& point : points) at += point.share * point.p_m;
  double least_m = mean_distance(points, at);
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec2 next = step_to_median(points, at);
    const double next_m = mean_distance(points, next);
    if (!(next_m < least_m)) break;
    at = next;
    least_m = next_m;
  }
  return at;
}

}  // namespace isograsp
