// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/patch/solid_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isograsp {

namespace {

constexpr double kQuarterTurn_rad = std::numbers::pi / 2.0;

/// `inward`: the solid's own normal at the point.
Result<void> check_normal(const PatchFrame& frame, const Vec3& inward) {
  const double off_rad = std::atan2(frame.normal.cross(inward).norm(), frame.normal.dot(inward));
  if (off_rad <= kSameNormal_rad) return {};
  if (off_rad > kQuarterTurn_rad) return normal_outward();
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return refused("is %1 degrees off that of the surface"_text(fixed(kDegrees * off_rad, 1)),
                 "give the normal of the surface at this point"_text)
      .about("normal");
}

/// What may end a ray, by its distance from the contact point in the tangent plane.
struct RayEnd {
  double at_m;
  RayStop stop;
};
/// The first of them; of equals the first in the list.
PatchRay ray_to(std::initializer_list<RayEnd> ends, double limit_m) {
  const RayEnd first =
      std::min(ends, [](const RayEnd& a, const RayEnd& b) { return a.at_m < b.at_m; });
  return {limit_m, first.stop, {{0.0, first.at_m}}};
}

/// A flat face that ends after `face_m` at edges of 90 degrees. Nothing of the next face is seen
/// along the normal, so a rough surface ends there, too.
PatchRay flat_ray(double face_m, double limit_m, const Pad& pad) {
  const bool over = pad.rough || pad.sharp_edge_rad < kQuarterTurn_rad;
  return ray_to({{limit_m, RayStop::length}, {face_m, over ? RayStop::edge : RayStop::cone}},
                limit_m);
}

/// How far a rough surface that falls off as a circle of `radius_m` counts: its normal in the cone,
/// no deeper than the pad reaches.
double rough_limit_m(double radius_m, const Pad& pad) {
  const double cone_m = radius_m * std::sin(std::atan(pad.friction));
  const double depth_m = std::min(pad.depth_m, radius_m);
  return std::min(cone_m, std::sqrt(depth_m * (2.0 * radius_m - depth_m)));
}

/// The pieces of a rough ray that ends at `end`, of which `counts_m` count.
PatchRay rough_ray(RayEnd end, double counts_m, double limit_m) {
  return {limit_m, end.stop, {{0.0, std::min(end.at_m, counts_m)}}};
}

/// Angle up to which an ellipse with half axes R / sin beta (along the ray) and R is as long as
/// `length_m`; at most `most_rad`. `cosine`, `sine`: of beta, between ray and axis.
double angle_of_arc(double length_m, double radius_m, double cosine, double sine, double most_rad) {
  const double scale_m = radius_m / sine;
  const double k = std::min(1.0, std::abs(cosine));
  const auto length = [&](double angle_rad) { return scale_m * std::ellint_2(k, angle_rad); };
  if (length(most_rad) <= length_m) return most_rad;
  // The arc grows by less and less: Newton from below stays there and converges.
  double angle_rad = std::min(most_rad, length_m / scale_m);
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps; ++step) {
    const double slope_m =
        scale_m * std::sqrt(std::max(0.0, 1.0 - k * k * std::pow(std::sin(angle_rad), 2)));
    const double next_rad = angle_rad + (length_m - length(angle_rad)) / slope_m;
    if (!(std::abs(next_rad - angle_rad) > 1e-16)) break;
    angle_rad = std::clamp(next_rad, 0.0, most_rad);
  }
  return angle_rad;
}

Vec3 direction_of(const PatchFrame& frame, double angle_rad) {
  return std::cos(angle_rad) * frame.x + std::sin(angle_rad) * frame.y;
}

template <class Ray>
std::vector<PatchRay> all_rays(const Pad& pad, Ray&& ray) {
  std::vector<PatchRay> rays;
  rays.reserve(static_cast<std::size_t>(pad.rays));
  for (int j = 0; j < pad.rays; ++j) rays.push_back(ray(reach_of_ray(pad, j)));
  return rays;
}

}  // namespace

Error not_on_surface(double distance_m) {
  return refused("is %1 m from the surface"_text(shortest(distance_m)),
                 "move it there: 1e-6 m is the most"_text)
      .about("point");
}

Error normal_outward() {
  return refused("points out of the object"_text, "turn it round: normals point inwards"_text)
      .about("normal");
}

// Box.

namespace {
/// The face whose inward normal is nearest to that of the contact.
Eigen::Index face_axis(const Vec3& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}
}  // namespace

Result<void> BoxSurface::check(const PatchFrame& frame) const {
  const Eigen::Index axis = face_axis(frame.normal);
  Vec3 inward = Vec3::Zero();
  inward[axis] = frame.p[axis] > 0.0 ? -1.0 : 1.0;
  Vec3 beyond_m = frame.p.cwiseAbs() - half_m_;
  beyond_m[axis] = std::abs(beyond_m[axis]);
  if (const double off_m = beyond_m.maxCoeff(); !(off_m <= kOnSurface_m))
    return not_on_surface(off_m);
  return check_normal(frame, inward);
}

Result<std::vector<PatchRay>> BoxSurface::rays(const PatchFrame& frame, const Pad& pad) const {
  if (auto good = check(frame); !good) return good.error();
  return all_rays(pad, [&](PadReach reach) { return ray(frame, reach, pad); });
}

PatchRay BoxSurface::ray(const PatchFrame& frame, PadReach reach, const Pad& pad) const {
  const double limit_m = reach.limit_m;
  const Eigen::Index axis = face_axis(frame.normal);
  const Vec3 along = direction_of(frame, reach.angle_rad);
  double face_m = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (i == axis || along[i] == 0.0) continue;
    const double to_m = (along[i] > 0.0 ? half_m_[i] - frame.p[i] : -half_m_[i] - frame.p[i]);
    face_m = std::min(face_m, std::max(0.0, to_m / along[i]));
  }
  return flat_ray(face_m, limit_m, pad);
}

// Sphere.

Result<void> SphereSurface::check(const PatchFrame& frame) const {
  if (const double off_m = std::abs(frame.p.norm() - radius_m_); !(off_m <= kOnSurface_m))
    return not_on_surface(off_m);
  return check_normal(frame, -frame.p.normalized());
}

Result<std::vector<PatchRay>> SphereSurface::rays(const PatchFrame& frame, const Pad& pad) const {
  if (auto good = check(frame); !good) return good.error();
  return all_rays(pad, [&](PadReach reach) { return ray(frame, reach, pad); });
}

PatchRay SphereSurface::ray(const PatchFrame&, PadReach reach, const Pad& pad) const {
  const double limit_m = reach.limit_m;
  if (pad.rough) {
    const RayEnd end =
        limit_m < radius_m_ ? RayEnd{limit_m, RayStop::length} : RayEnd{radius_m_, RayStop::edge};
    return rough_ray(end, rough_limit_m(radius_m_, pad), limit_m);
  }
  const double turn_rad = limit_m / radius_m_;
  const double cone_rad = std::atan(pad.friction);
  const bool leaves = turn_rad > cone_rad;
  const double end_m = radius_m_ * std::sin(leaves ? cone_rad : turn_rad);
  return {limit_m, leaves ? RayStop::cone : RayStop::length, {{0.0, end_m}}};
}

// Cylinder.

bool CylinderSurface::on_cap(const PatchFrame& frame) const noexcept {
  return std::abs(frame.normal.z()) > std::numbers::sqrt2 / 2.0;
}

Result<void> CylinderSurface::check(const PatchFrame& frame) const {
  const double from_axis_m = frame.p.head<2>().norm();
  const double side_m = from_axis_m - radius_m_;
  const double cap_m = std::abs(frame.p.z()) - half_length_m_;
  const double off_m =
      on_cap(frame) ? std::max(std::abs(cap_m), side_m) : std::max(std::abs(side_m), cap_m);
  if (!(off_m <= kOnSurface_m)) return not_on_surface(off_m);
  if (on_cap(frame)) return check_normal(frame, Vec3(0.0, 0.0, frame.p.z() > 0.0 ? -1.0 : 1.0));
  return check_normal(frame, Vec3(-frame.p.x(), -frame.p.y(), 0.0) / from_axis_m);
}

Result<std::vector<PatchRay>> CylinderSurface::rays(const PatchFrame& frame, const Pad& pad) const {
  if (auto good = check(frame); !good) return good.error();
  return all_rays(pad, [&](PadReach reach) { return ray(frame, reach, pad); });
}

PatchRay CylinderSurface::ray(const PatchFrame& frame, PadReach reach, const Pad& pad) const {
  const double limit_m = reach.limit_m;
  const Vec3 along = direction_of(frame, reach.angle_rad);
  if (on_cap(frame)) {
    // From p to the circle: t² + 2 t p·d + p² - R² = 0.
    const auto p = frame.p.head<2>();
    const auto d = along.head<2>().normalized();
    const double half = p.dot(d);
    const double rest = radius_m_ * radius_m_ - p.squaredNorm();
    return flat_ray(std::max(0.0, std::sqrt(std::max(0.0, half * half + rest)) - half), limit_m,
                    pad);
  }
  const double cosine = along.z();
  const double sine = along.head<2>().norm();
  const double to_end_m = half_length_m_ - (cosine > 0.0 ? frame.p.z() : -frame.p.z());
  const double end_m = cosine == 0.0 ? std::numeric_limits<double>::infinity()
                                     : std::max(0.0, to_end_m / std::abs(cosine));
  // A ray along the axis is straight; so is one that is hardly bent over its whole length.
  constexpr double kStraight = 1e-9;
  if (sine * limit_m < kStraight * radius_m_) return flat_ray(end_m, limit_m, pad);
  const double widest_m = radius_m_ / sine;
  if (pad.rough) {
    const PatchRay bare = ray_to(
        {{limit_m, RayStop::length}, {end_m, RayStop::edge}, {widest_m, RayStop::edge}}, limit_m);
    return rough_ray({bare.pieces[0].to_m, bare.stop}, rough_limit_m(radius_m_, pad) / sine,
                     limit_m);
  }
  const double cone_rad = std::atan(pad.friction);
  const double arc_rad = angle_of_arc(limit_m, radius_m_, cosine, sine, cone_rad);
  const RayStop bent = arc_rad < cone_rad ? RayStop::length : RayStop::cone;
  const RayStop at_end = pad.sharp_edge_rad < kQuarterTurn_rad ? RayStop::edge : RayStop::cone;
  return ray_to({{widest_m * std::sin(arc_rad), bent}, {end_m, at_end}}, limit_m);
}

}  // namespace isograsp
