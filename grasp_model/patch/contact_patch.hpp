// SPDX-License-Identifier: GPL-3.0-or-later
// The patch of a surface that a finger pad covers: rays from the contact point run along the
// surface until the pad ends, or the surface (Talvas et al., god-finger surfaces;
// docs/grasp_model.md, "Contact patch"). Its torsional limit belongs to a soft contact. Done when a
// scene is read, never while it runs. SI units; contact frame C: z into the object, x the tangent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

using Vec2 = Eigen::Vector2d;

/// The pad of a finger, and how finely its patch is looked at.
struct Pad {
  double semi_x_m = 0.0075;
  double semi_y_m = 0.0055;
  int rays = 64;
  int rings = 8;
  double friction = 0.8;
  double sharp_edge_rad = 0.5235987755982988;  ///< 30 degrees: a crease above it is an edge
  /// The pulp bridges grooves: a ray goes on over edges, and what lies within `depth_m` of the
  /// tangent plane counts.
  bool rough = false;
  double depth_m = 0.0;
};

/// Why a ray ended.
enum class RayStop : std::uint8_t {
  length,   ///< the pad is no larger
  edge,     ///< the surface bends off
  cone,     ///< its normal leaves the friction cone
  boundary  ///< an open mesh ends
};
inline constexpr std::array<std::string_view, 4> kRayStopNames{"length", "edge", "cone",
                                                               "boundary"};

/// A piece of a ray that counts, by its distance from the contact point in the tangent plane.
struct RayPiece {
  double from_m = 0.0;
  double to_m = 0.0;
};
struct PatchRay {
  double limit_m = 0.0;  ///< how far the pad reaches in this direction
  RayStop stop = RayStop::length;
  std::vector<RayPiece> pieces;  ///< outward, apart from each other
};

/// Where the pad presses, and how its rays run in the contact frame.
struct PatchFrame {
  Vec3 p = Vec3::Zero();        ///< the contact point
  Vec3 normal = Vec3::UnitZ();  ///< into the object
  Vec3 x = Vec3::UnitX();
  Vec3 y = Vec3::UnitY();  ///< normal x x

  /// `tangent` need not be perpendicular to the normal. Errors (field "normal", "tangent"): zero,
  /// no number, or parallel.
  [[nodiscard]] static Result<PatchFrame> along(const Vec3& p, const Vec3& normal,
                                                const Vec3& tangent);
};

struct ContactPatch {
  double area_m2 = 0.0;
  Vec2 centroid_m = Vec2::Zero();  ///< from the contact point, in the tangent plane
  /// Torsional limit per newton of normal force about the centroid, pressure everywhere alike:
  /// mu sum S |r - c| / sum S.
  double torsion_m = 0.0;
  /// The same about the point where it is least: the greatest torque that comes without a force.
  double pure_torsion_limit_m = 0.0;
  std::size_t elements = 0;
  std::array<std::size_t, kRayStopNames.size()> stopped{};  ///< rays, by RayStop
  std::vector<Vec2> outline_m;                              ///< outermost point of each ray
};

/// A surface that rays run along.
class PatchSurface {
 public:
  virtual ~PatchSurface() = default;
  /// All rays of a pad; ray j goes 2 pi j / rays from x to y. Errors (field "point", "normal"): not
  /// on the surface, or not into the object there.
  [[nodiscard]] virtual Result<std::vector<PatchRay>> rays(const PatchFrame& frame,
                                                           const Pad& pad) const = 0;
};

/// A direction in which the pad reaches so far: its ellipse.
struct PadReach {
  double angle_rad = 0.0;  ///< from x to y
  double limit_m = 0.0;
};
[[nodiscard]] PadReach reach_of_ray(const Pad& pad, int ray) noexcept;

/// All rays of the pad, summed up. Errors: those of the surface's check(); a pad that is none
/// (field "pad").
[[nodiscard]] Result<ContactPatch> scan_patch(const PatchSurface& surface, const PatchFrame& frame,
                                              const Pad& pad);

/// A place that carries a share of the pressure.
struct PressedPoint {
  Vec2 p_m = Vec2::Zero();
  double share = 0.0;  ///< of all: they sum up to 1
};
/// The sectors of the rays; a share is an area here [m^2].
[[nodiscard]] std::vector<PressedPoint> elements_of(std::span<const PatchRay> rays, const Pad& pad);
/// The same from rays: sectors of 2 pi / rays between two radii; ray j is at 2 pi j / rays.
[[nodiscard]] ContactPatch patch_of(std::span<const PatchRay> rays, const Pad& pad);

/// Where the sum of shares times distance is least: their geometric median, by the steps of Newton
/// and Weiszfeld.
[[nodiscard]] Vec2 geometric_median(std::span<const PressedPoint> points);
/// Sum of shares times distance from `from`.
[[nodiscard]] double mean_distance(std::span<const PressedPoint> points, const Vec2& from) noexcept;

}  // namespace isograsp
