// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/hand_props.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <Inventor/nodes/SoComplexity.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTexture2.h>
#include <Inventor/nodes/SoTextureCoordinate2.h>
#include <Inventor/nodes/SoTransform.h>

#include "gui/patient_screen/hand_colours.hpp"
#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui::scene_nodes {

using virtual_hand::ObjectShape;

namespace {

constexpr float kTableHalf_m = 1.1F;
constexpr float kTableBack_m = -0.42F;
constexpr float kTableFront_m = 0.62F;

SoSeparator* make_quad(SoCoordinate3* corners) {
  auto* quad = new SoSeparator;
  quad->addChild(corners);
  auto* face = new SoFaceSet;
  face->numVertices.setValue(4);
  quad->addChild(face);
  return quad;
}

/// From the front left, against the clock.
void set_corners(SoCoordinate3* corners, float left, float right, float front, float back,
                 float y) {
  const std::array<SbVec3f, 4> ends{
      SbVec3f(left, y, front), {right, y, front}, {right, y, back}, {left, y, back}};
  corners->point.setValues(0, 4, ends.data());
}

}  // namespace

void show_if(SoSwitch* part, bool shown) {
  part->whichChild.setValue(shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
}

void set_colour(SoMaterial* material, const SbColor& colour) {
  material->diffuseColor.setValue(colour);
  material->ambientColor.setValue(colour);
}

SoSeparator* make_table() {
  auto* table = new SoSeparator;
  table->addChild(make_flat());
  table->addChild(make_material(kTableColour));
  auto* corners = new SoCoordinate3;
  set_corners(corners, -kTableHalf_m, kTableHalf_m, kTableFront_m, kTableBack_m, 0.0F);
  table->addChild(make_quad(corners));
  constexpr float kGrid_m = 0.1F;
  constexpr float kAbove_m = 2.0F * kOverTable_m;
  std::vector<SbVec3f> grid;
  for (int k = -11; k <= 11; ++k) {
    const float x = kGrid_m * static_cast<float>(k);
    grid.insert(grid.end(), {{x, kAbove_m, kTableBack_m}, {x, kAbove_m, kTableFront_m}});
  }
  for (int k = -4; k <= 6; ++k) {
    const float z = kGrid_m * static_cast<float>(k);
    grid.insert(grid.end(), {{-kTableHalf_m, kAbove_m, z}, {kTableHalf_m, kAbove_m, z}});
  }
  table->addChild(make_lines(grid, kTableGrid, 1.0F));
  return table;
}

ShadedPlane::ShadedPlane(const SbColor& colour)
    : root(new SoSeparator), shadow(new SoTexture2), corners(new SoCoordinate3) {
  root->renderCaching.setValue(SoSeparator::OFF);
  root->addChild(make_flat());
  auto* quality = new SoComplexity;
  quality->textureQuality.setValue(0.4F);  // between points straight, no smaller copies
  root->addChild(quality);
  shadow->wrapS.setValue(SoTexture2::CLAMP);
  shadow->wrapT.setValue(SoTexture2::CLAMP);
  root->addChild(shadow);
  auto* places = new SoTextureCoordinate2;
  // At the very edge OpenGL would mix in the black beyond it.
  constexpr float kIn = 0.01F;
  constexpr float kOut = 1.0F - kIn;
  const std::array<SbVec2f, 4> ends{SbVec2f(kIn, kIn), {kOut, kIn}, {kOut, kOut}, {kIn, kOut}};
  places->point.setValues(0, 4, ends.data());
  root->addChild(places);
  root->addChild(make_material(colour));
  root->addChild(make_quad(corners));
}

void ShadedPlane::show(const HandPicture& picture, const ShadeArea& area) {
  const auto at = [](double value) { return static_cast<float>(value); };
  set_corners(corners, at(area.left_m), at(area.left_m + area.width_m), at(area.front_m),
              at(area.front_m - area.depth_m), at(area.height_m) + kOverTable_m);
  const auto shade = table_shade(picture, area);
  shadow->image.setValue(SbVec2s(static_cast<short>(area.columns), static_cast<short>(area.rows)),
                         1, shade.data());
}

MovedLine::MovedLine(const SbColor& colour, float width_px, unsigned short pattern)
    : shown(new SoSwitch), ends(new SoCoordinate3) {
  auto* line = new SoSeparator;
  line->renderCaching.setValue(SoSeparator::OFF);
  line->addChild(make_flat());
  line->addChild(make_material(colour));
  auto* style = new SoDrawStyle;
  style->lineWidth.setValue(width_px);
  style->linePattern.setValue(pattern);
  line->addChild(style);
  line->addChild(ends);
  auto* set = new SoLineSet;
  set->numVertices.setValue(2);
  line->addChild(set);
  shown->addChild(line);
}

void MovedLine::show(const Vec3& from_W, const Vec3& to_W) {
  const std::array<SbVec3f, 2> both{to_sb(from_W), to_sb(to_W)};
  ends->point.setValues(0, 2, both.data());
  show_if(shown, true);
}

MarkNodes::MarkNodes()
    : shown(new SoSwitch), place(new SoTransform), colour(make_material(kTouchesColour)) {
  auto* mark = new SoSeparator;
  mark->addChild(place);
  mark->addChild(colour);
  auto* disc = new SoCylinder;
  disc->radius.setValue(1.0F);
  disc->height.setValue(1.0F);
  mark->addChild(disc);
  shown->addChild(mark);
}

void MarkNodes::show(const HandPicture::Mark& mark, const SbColor& of) {
  constexpr float kThick_m = 0.0016F;
  constexpr float kRim = 1.3F;
  const float radius_m = kRim * static_cast<float>(mark.radius_m);
  place->translation.setValue(to_sb(mark.p_W));
  place->rotation.setValue(SbRotation(SbVec3f(0, 1, 0), to_sb(mark.normal_W)));
  place->scaleFactor.setValue(radius_m, kThick_m, radius_m);
  set_colour(colour, of);
}

SoSeparator* make_foot() {
  auto* foot = new SoSeparator;
  foot->addChild(make_flat());
  foot->addChild(make_material(kTargetColour, 0.35F));
  auto* disc = new SoCylinder;
  disc->radius.setValue(0.012F);
  disc->height.setValue(0.0008F);
  foot->addChild(disc);
  return foot;
}

Scene scene_of(const ObjectShape& shape) {
  Scene scene;
  const Vec3 size_m = 2.0 * shape.half_m;
  const bool box = shape.kind == ObjectShape::Kind::box;
  scene.shape = box ? Shape::box : Shape::cylinder;
  scene.size_m = box ? size_m : Vec3(size_m.x(), size_m.z(), 0.0);
  return scene;
}

SoNode* make_body(const ObjectShape& shape) {
  return make_shape(scene_of(shape));
}

std::vector<SbVec3f> outline_of(const ObjectShape& shape) {
  if (shape.kind == ObjectShape::Kind::box) return edges_of(scene_of(shape));
  constexpr int kParts = 40;
  std::vector<SbVec3f> ends;
  for (const double z : {-shape.half_m.z(), shape.half_m.z()})
    for (int k = 0; k < kParts; ++k)
      for (const int end : {k, k + 1}) {
        const double angle = 2.0 * std::numbers::pi * end / kParts;
        ends.push_back(
            to_sb(Vec3(shape.half_m.x() * std::cos(angle), shape.half_m.x() * std::sin(angle), z)));
      }
  return ends;
}

}  // namespace isograsp::gui::scene_nodes
