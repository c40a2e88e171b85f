// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces of solids whose rays are known in closed form: box, sphere, cylinder, with the origin in
// their middle (docs/grasp_model.md, "Contact patch"). SI units.
#pragma once

#include "grasp_model/patch/contact_patch.hpp"

namespace isograsp {

/// The contact point may be this far from the surface [m].
inline constexpr double kOnSurface_m = 1e-6;
/// … and the given normal this far from the solid's own, which is then used [rad].
inline constexpr double kSameNormal_rad = 0.0175;

/// What PatchSurface::rays() refuses, of any surface.
[[nodiscard]] Error not_on_surface(double distance_m);
[[nodiscard]] Error normal_outward();

/// Edges along the axes.
class BoxSurface final : public PatchSurface {
 public:
  explicit BoxSurface(const Vec3& size_m) : half_m_(size_m / 2.0) {}
  [[nodiscard]] Result<std::vector<PatchRay>> rays(const PatchFrame& frame,
                                                   const Pad& pad) const override;

 private:
  [[nodiscard]] Result<void> check(const PatchFrame& frame) const;
  [[nodiscard]] PatchRay ray(const PatchFrame& frame, PadReach reach, const Pad& pad) const;

  Vec3 half_m_;
};

class SphereSurface final : public PatchSurface {
 public:
  explicit SphereSurface(double diameter_m) : radius_m_(diameter_m / 2.0) {}
  [[nodiscard]] Result<std::vector<PatchRay>> rays(const PatchFrame& frame,
                                                   const Pad& pad) const override;

 private:
  [[nodiscard]] Result<void> check(const PatchFrame& frame) const;
  [[nodiscard]] PatchRay ray(const PatchFrame& frame, PadReach reach, const Pad& pad) const;

  double radius_m_;
};

/// Axis z.
class CylinderSurface final : public PatchSurface {
 public:
  CylinderSurface(double diameter_m, double length_m)
      : radius_m_(diameter_m / 2.0), half_length_m_(length_m / 2.0) {}
  [[nodiscard]] Result<std::vector<PatchRay>> rays(const PatchFrame& frame,
                                                   const Pad& pad) const override;

 private:
  [[nodiscard]] Result<void> check(const PatchFrame& frame) const;
  [[nodiscard]] PatchRay ray(const PatchFrame& frame, PadReach reach, const Pad& pad) const;
  [[nodiscard]] bool on_cap(const PatchFrame& frame) const noexcept;

  double radius_m_;
  double half_length_m_;
};

}  // namespace isograsp
