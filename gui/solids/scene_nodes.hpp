// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient's 3D picture is made of: room, block with its mark, fingers, shadows. Metres, in
// the frame that each stands in; nodes of Coin, which whoever they are added to owns.
#pragma once

#include <array>
#include <vector>

#include <Inventor/SbColor.h>
#include <Inventor/SbLinear.h>

#include "grasp_model/scene.hpp"

class SoLightModel;
class SoMaterial;
class SoNode;
class SoSeparator;
class SoSwitch;
class SoTransform;

namespace isograsp::gui::scene_nodes {

inline const SbColor kWallColour(0.91F, 0.93F, 0.95F);
inline const SbColor kShadowColour(0.25F, 0.29F, 0.34F);
inline const SbColor kBlockColour(0.20F, 0.42F, 0.66F);
inline const SbColor kBlockMark(0.97F, 0.98F, 1.00F);
inline const SbColor kBlockEdge(0.05F, 0.14F, 0.26F);
inline const SbColor kGhostColour(0.96F, 0.66F, 0.10F);
inline const SbColor kGhostEdge(0.45F, 0.27F, 0.00F);
inline const SbColor kGhostCorner(1.00F, 0.90F, 0.25F);
inline const SbColor kMatchedColour(0.00F, 0.55F, 0.36F);
inline const SbColor kUnseenColour(0.66F, 0.69F, 0.72F);

[[nodiscard]] inline SbVec3f to_sb(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
[[nodiscard]] inline SbRotation to_sb(const Quat& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
          static_cast<float>(q.w())};
}

[[nodiscard]] SoMaterial* make_material(const SbColor& colour, float transparency = 0.0F);
/// What follows is drawn in its own colour whatever the light.
[[nodiscard]] SoLightModel* make_flat();
/// Each pair of points is a line.
[[nodiscard]] SoSeparator* make_lines(const std::vector<SbVec3f>& ends, const SbColor& colour,
                                      float width_px);
/// Where floor and wall are, and how far they reach [m].
struct RoomSize {
  float floor;  ///< y
  float wall;   ///< z
  float front;  ///< z to which the floor reaches
  float half_width;
  float top;  ///< y
  float grid;
};
/// Round a virtual object, which the device holds in its place.
inline constexpr RoomSize kTableRoom{-0.160F, -0.110F, 0.160F, 0.60F, 0.49F, 0.05F};
/// Round a real object, which an arm moves.
inline constexpr RoomSize kArmRoom{-0.190F, -0.50F, 0.50F, 1.20F, 0.90F, 0.10F};

/// A plane whose corners have these colours, whatever the light.
[[nodiscard]] SoSeparator* make_shaded_plane(const std::vector<SbVec3f>& corners,
                                             const std::vector<SbColor>& colours);
/// Floor and wall with their grid.
[[nodiscard]] SoSeparator* make_room(const RoomSize& size);
[[nodiscard]] SoNode* make_shape(const Scene& scene);
/// The edges of a box; other shapes have none.
[[nodiscard]] std::vector<SbVec3f> edges_of(const Scene& scene);
/// A stripe along the upper edge: without it a turned block looks as before.
[[nodiscard]] SoSeparator* make_mark(const Scene& scene, const SbColor& colour, float transparency);

/// A fingertip that ends at the place, pointing along +y.
struct FingerNodes {
  FingerNodes();
  SoSwitch* shown;
  SoTransform* place;
  SoSwitch* form;  ///< 0: approaching, 1: touching
};

/// A bright ball in each corner of a box.
[[nodiscard]] SoSeparator* make_corners(const Scene& scene, const SbColor& colour);

/// On the floor, of a lamp that is not a point: the same shape a few times, ever wider and ever
/// paler, the more so the higher the object is.
class SoftShadow {
 public:
  SoftShadow();
  /// Of `form`, which stands at `place`.
  void build(const RoomSize& size, SoTransform* place, SoNode* form);
  /// `height_m`: of the object above the floor.
  void fall(float height_m) const;
  [[nodiscard]] SoSeparator* root() const noexcept { return root_; }

 private:
  static constexpr std::size_t kLayers = 7;
  SoSeparator* root_;
  std::array<SoMaterial*, kLayers> inks_{};
  std::array<SoTransform*, kLayers> sizes_{};
};

/// Projections that make a shadow out of what follows, so far above the floor, or before the wall.
[[nodiscard]] SbMatrix flatten_to_floor(const RoomSize& size, float lift_m = 0.0012F);
[[nodiscard]] SbMatrix flatten_to_wall(const RoomSize& size);

}  // namespace isograsp::gui::scene_nodes
