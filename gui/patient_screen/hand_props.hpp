// SPDX-License-Identifier: GPL-3.0-or-later
// What stands around a tracked hand in its picture: a table with a soft shadow, lines whose ends
// move, marks of touch, the form of an object. Metres; nodes of Coin, which whoever they are added
// to owns.
#pragma once

#include <vector>

#include <Inventor/SbColor.h>
#include <Inventor/SbLinear.h>

#include "grasp_model/scene.hpp"
#include "gui/patient_screen/table_shade.hpp"
#include "gui/picture/hand_picture.hpp"

class SoCoordinate3;
class SoMaterial;
class SoNode;
class SoSeparator;
class SoSwitch;
class SoTexture2;
class SoTransform;

namespace isograsp::gui::scene_nodes {

/// One above the other by so much [m]: in the same plane they would flicker.
inline constexpr float kOverTable_m = 0.0005F;

void show_if(SoSwitch* part, bool shown);
/// Its colour in any light.
void set_colour(SoMaterial* material, const SbColor& colour);

/// A table at height 0 with a grid of 10 cm, wider than what is seen of it.
[[nodiscard]] SoSeparator* make_table();

/// A level rectangle with a shadow on it.
struct ShadedPlane {
  explicit ShadedPlane(const SbColor& colour);
  void show(const HandPicture& picture, const ShadeArea& area);
  SoSeparator* root;
  SoTexture2* shadow;
  SoCoordinate3* corners;
};

/// A line whose ends move.
struct MovedLine {
  /// `pattern`: sixteen points of it, as OpenGL takes them.
  MovedLine(const SbColor& colour, float width_px, unsigned short pattern);
  void show(const Vec3& from_W, const Vec3& to_W);
  SoSwitch* shown;
  SoCoordinate3* ends;
};
inline constexpr unsigned short kWhole = 0xffff;
inline constexpr unsigned short kDashed = 0x3f3f;

/// The touch of one digit: a disc on the object.
struct MarkNodes {
  MarkNodes();
  void show(const HandPicture::Mark& mark, const SbColor& colour);
  SoSwitch* shown;
  SoTransform* place;
  SoMaterial* colour;
};

/// Where the drop line of a target meets the table.
[[nodiscard]] SoSeparator* make_foot();

/// The same body as the object of a scene: a cylinder lies along z.
[[nodiscard]] Scene scene_of(const virtual_hand::ObjectShape& shape);
[[nodiscard]] SoNode* make_body(const virtual_hand::ObjectShape& shape);
/// Edges of a box, rims of a cylinder: each pair of points is a line.
[[nodiscard]] std::vector<SbVec3f> outline_of(const virtual_hand::ObjectShape& shape);

}  // namespace isograsp::gui::scene_nodes
