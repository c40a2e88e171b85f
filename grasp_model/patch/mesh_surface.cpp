// SPDX-License-Identifier: GPL-3.0-or-later
// How a ray walks: the half plane of normal and direction cuts the mesh in a line from edge to
// edge. A vertex that lies in the plane counts as on one side of it, always the same: so each
// triangle is cut at two edges or none, and the walk never stands at a vertex (simulation of
// simplicity).
#include "grasp_model/patch/mesh_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grasp_model/patch/solid_surface.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kNoEdge = 3;

double angle_between_normals(const Vec3& a, const Vec3& b) noexcept {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5, by regions).
Vec3 nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto on_segment = [&p](const Vec3& from, const Vec3& to) -> Vec3 {
    const Vec3 along = to - from;
    const double squared = along.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return from + t * along;
  };
  const Vec3 normal = (b - a).cross(c - a);
  const bool inside = normal.squaredNorm() > 0.0 && normal.dot((b - a).cross(p - a)) >= 0.0 &&
                      normal.dot((c - b).cross(p - b)) >= 0.0 &&
                      normal.dot((a - c).cross(p - c)) >= 0.0;
  if (inside) return p - normal * (normal.dot(p - a) / normal.squaredNorm());
  Vec3 nearest = on_segment(a, b);
  for (const Vec3& other : {on_segment(b, c), on_segment(c, a)})
    if ((p - other).squaredNorm() < (p - nearest).squaredNorm()) nearest = other;
  return nearest;
}

/// Adds the part of a segment between two places that lies within the depth; joins it to the piece
/// before where they meet.
void add_piece(std::vector<RayPiece>& pieces, double from_m, double from_deep_m, double to_m,
               double to_deep_m, double depth_m) {
  // The segment as a part t of 0 … 1, cut at +depth and -depth.
  double begin = 0.0, end = 1.0;
  const double rise_m = to_deep_m - from_deep_m;
  for (const double sign : {1.0, -1.0}) {
    const double room_m = depth_m - sign * from_deep_m;  // left at the begin
    const double fall_m = sign * rise_m;                 // used up on the way
    if (fall_m == 0.0) {
      if (room_m < 0.0) return;
    } else if (fall_m > 0.0) {
      end = std::min(end, room_m / fall_m);
    } else {
      begin = std::max(begin, room_m / fall_m);
    }
  }
  if (!(begin < end)) return;
  const RayPiece piece{from_m + begin * (to_m - from_m), from_m + end * (to_m - from_m)};
  if (!(piece.from_m < piece.to_m)) return;
  constexpr double kMeet_m = 1e-12;
  if (!pieces.empty() && piece.from_m - pieces.back().to_m <= kMeet_m)
    pieces.back().to_m = std::max(pieces.back().to_m, piece.to_m);
  else
    pieces.push_back(piece);
}

}  // namespace

/// The half plane of one ray.
struct MeshSurface::Section {
  Vec3 p;
  Vec3 along;
  Vec3 normal;  ///< of the contact
  Vec3 across;  ///< of the half plane

  [[nodiscard]] double side_m(const Vec3& vertex) const { return across.dot(vertex - p); }
  [[nodiscard]] Crossing between(const Vec3& a, double a_m, const Vec3& b, double b_m) const {
    const Vec3 at = a + (b - a) * (a_m / (a_m - b_m)) - p;
    return {kNone, 0, along.dot(at), normal.dot(at)};
  }
};

Vec3 MeshSurface::middle_of(std::size_t triangle) const {
  const auto& [a, b, c] = triangles_[triangle].vertices;
  return (vertices_[a] + vertices_[b] + vertices_[c]) / 3.0;
}

double MeshSurface::distance_m(const Triangle& triangle, const Vec3& p) const {
  const auto& [a, b, c] = triangle.vertices;
  return (nearest_in_triangle(p, vertices_[a], vertices_[b], vertices_[c]) - p).norm();
}

Result<std::vector<std::uint32_t>> MeshSurface::under(const PatchFrame& frame) const {
  std::vector<std::uint32_t> found;
  bool touches = false;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const double off_m = distance_m(triangles_[t], frame.p);
    least_m = std::min(least_m, off_m);
    if (!(off_m <= kOnSurface_m)) continue;
    touches = true;
    if (triangles_[t].inward.dot(frame.normal) > 0.0) found.push_back(t);
  }
  if (!touches) return not_on_surface(least_m);
  if (found.empty()) return normal_outward();
  return found;
}

std::optional<MeshSurface::Crossing> MeshSurface::forward_edge(const Section& section,
                                                               std::uint32_t triangle,
                                                               std::size_t entry) const {
  const Triangle& at = triangles_[triangle];
  std::optional<Crossing> farthest;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    if (edge == entry) continue;
    const Vec3& a = vertices_[at.vertices[edge]];
    const Vec3& b = vertices_[at.vertices[(edge + 1) % 3]];
    const double a_m = section.side_m(a);
    const double b_m = section.side_m(b);
    if ((a_m >= 0.0) == (b_m >= 0.0)) continue;
    Crossing crossing = section.between(a, a_m, b, b_m);
    crossing.triangle = triangle;
    crossing.edge = edge;
    if (!farthest || crossing.along_m > farthest->along_m) farthest = crossing;
  }
  return farthest;
}

std::optional<MeshSurface::Crossing> MeshSurface::first_edge(
    const Section& section, std::span<const std::uint32_t> under) const {
  constexpr double kGoesOn_m = 1e-9;
  // On an edge or a vertex the triangle is the one into which the ray goes.
  std::optional<Crossing> first;
  for (const std::uint32_t triangle : under) {
    const auto edge = forward_edge(section, triangle, kNoEdge);
    if (edge && edge->along_m > kGoesOn_m && (!first || edge->along_m > first->along_m))
      first = edge;
  }
  return first;
}

Result<std::vector<PatchRay>> MeshSurface::rays(const PatchFrame& frame, const Pad& pad) const {
  const auto on = under(frame);
  if (!on) return on.error();
  std::vector<PatchRay> rays;
  rays.reserve(static_cast<std::size_t>(pad.rays));
  for (int j = 0; j < pad.rays; ++j) {
    const PadReach reach = reach_of_ray(pad, j);
    const Vec3 along = std::cos(reach.angle_rad) * frame.x + std::sin(reach.angle_rad) * frame.y;
    rays.push_back(
        ray({frame.p, along, frame.normal, frame.normal.cross(along)}, *on, reach.limit_m, pad));
  }
  return rays;
}

PatchRay MeshSurface::ray(const Section& section, std::span<const std::uint32_t> under,
                          double limit_m, const Pad& pad) const {
  const double cone_rad = std::atan(pad.friction);
  const auto in_cone = [&](std::uint32_t triangle) {
    return angle_between_normals(triangles_[triangle].inward, section.normal) <= cone_rad;
  };
  PatchRay ray{limit_m, RayStop::boundary, {}};
  double at_m = 0.0, deep_m = 0.0;  // where the walk stands, in the half plane
  double gone_m = 0.0;              // along the surface; of a rough one in the tangent plane
  const auto stop = [&](RayStop why) {
    ray.stop = why;
    if (!pad.rough) ray.pieces = {{0.0, at_m}};
    return ray;
  };
  auto next = first_edge(section, under);
  if (!next) return stop(RayStop::boundary);
  if (!pad.rough && !in_cone(next->triangle)) return stop(RayStop::cone);
  // Each triangle is met once at most.
  for (std::size_t met = 0; next && met <= triangles_.size(); ++met) {
    const Triangle& here = triangles_[next->triangle];
    const double step_along_m = next->along_m - at_m;
    const double step_m =
        pad.rough ? step_along_m : std::hypot(step_along_m, next->deep_m - deep_m);
    if (pad.rough && step_along_m < 0.0) return stop(RayStop::edge);  // it bends back below itself
    const bool ends = gone_m + step_m >= limit_m;
    const double share = ends && step_m > 0.0 ? (limit_m - gone_m) / step_m : 1.0;
    const double to_m = at_m + share * step_along_m;
    const double to_deep_m = deep_m + share * (next->deep_m - deep_m);
    if (pad.rough && in_cone(next->triangle))
      add_piece(ray.pieces, at_m, deep_m, to_m, to_deep_m, pad.depth_m);
    at_m = to_m;
    deep_m = to_deep_m;
    gone_m += share * step_m;
    if (ends) return stop(RayStop::length);
    const std::uint32_t beyond = here.beside[next->edge];
    if (beyond == kNone) return stop(RayStop::boundary);
    if (!pad.rough) {
      if (angle_between_normals(here.inward, triangles_[beyond].inward) > pad.sharp_edge_rad)
        return stop(RayStop::edge);
      if (!in_cone(beyond)) return stop(RayStop::cone);
    }
    const auto& sides = triangles_[beyond].beside;
    const auto entry = static_cast<std::size_t>(
        std::find(sides.begin(), sides.end(), next->triangle) - sides.begin());
    next = forward_edge(section, beyond, entry);
  }
  return stop(RayStop::boundary);
}

}  // namespace isograsp
