// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/solids/scene_nodes.hpp"

#include <algorithm>
#include <cmath>

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMaterialBinding.h>
#include <Inventor/nodes/SoMatrixTransform.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

#include "gui/solids/rounded_mesh.hpp"

namespace isograsp::gui::scene_nodes {

namespace {

const SbColor kFloorColour(0.83F, 0.86F, 0.89F);
const SbColor kGridColour(0.74F, 0.78F, 0.82F);
const SbColor kApproachColour(0.78F, 0.12F, 0.10F);
const SbColor kTouchColour(0.00F, 0.55F, 0.36F);
const SbColor kTipColour(0.80F, 0.73F, 0.68F);
const SbColor kTipNailColour(0.93F, 0.88F, 0.85F);
/// Where the wall is bright and the floor is near.
const SbColor kWallTopColour(0.955F, 0.968F, 0.98F);
const SbColor kFloorFarColour(0.76F, 0.80F, 0.84F);

SbVec3f extent_of(const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  switch (scene.shape) {
    case Shape::box: return size;
    case Shape::cylinder: return {size[0], size[0], size[1]};
    case Shape::sphere: return {size[0], size[0], size[0]};
  }
  return size;
}

/// A fingertip that ends at the origin and points along +y; `wide`: pressed flat.
SoSeparator* make_fingertip(float wide) {
  constexpr double kRadius = 0.0098;
  auto* group = new SoSeparator;
  auto* pressed = new SoTransform;
  pressed->scaleFactor.setValue(wide, 1.0F / wide, wide);
  group->addChild(pressed);
  SoMaterial* skin = make_material(kTipColour);
  skin->ambientColor.setValue(kTipColour * 0.85F);
  skin->specularColor.setValue(0.18F, 0.18F, 0.18F);
  skin->shininess.setValue(0.25F);
  group->addChild(skin);
  group->addChild(make_rounded({{Vec3(0, -0.0085, 0), 0.0085},
                                {Vec3(0, -0.022, -0.0005), kRadius},
                                {Vec3(0, -0.052, -0.001), 1.06 * kRadius}}));
  auto* nail = new SoSeparator;
  auto* place = new SoTransform;
  place->translation.setValue(0, -0.0125F, 0.0072F);
  place->rotation.setValue(SbVec3f(1, 0, 0), 0.16F);
  place->scaleFactor.setValue(0.0058F, 0.0076F, 0.0020F);
  nail->addChild(place);
  SoMaterial* gloss = make_material(kTipNailColour);
  gloss->specularColor.setValue(0.5F, 0.5F, 0.5F);
  gloss->shininess.setValue(0.6F);
  nail->addChild(gloss);
  nail->addChild(new SoSphere);
  group->addChild(nail);
  return group;
}

SoSeparator* make_collar(const SbColor& colour, float radius_m, float height_m) {
  auto* group = new SoSeparator;
  auto* behind = new SoTranslation;
  behind->translation.setValue(0, -0.039F, 0);
  auto* collar = new SoCylinder;
  collar->radius.setValue(radius_m);
  collar->height.setValue(height_m);
  group->addChild(make_material(colour));
  group->addChild(behind);
  group->addChild(collar);
  return group;
}

}  // namespace

SoMaterial* make_material(const SbColor& colour, float transparency) {
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(colour);
  material->ambientColor.setValue(colour);
  material->transparency.setValue(transparency);
  return material;
}

SoLightModel* make_flat() {
  auto* model = new SoLightModel;
  model->model.setValue(SoLightModel::BASE_COLOR);
  return model;
}

SoSeparator* make_lines(const std::vector<SbVec3f>& ends, const SbColor& colour, float width_px) {
  auto* lines = new SoSeparator;
  lines->addChild(make_flat());
  lines->addChild(make_material(colour));
  auto* style = new SoDrawStyle;
  style->lineWidth.setValue(width_px);
  lines->addChild(style);
  auto* points = new SoCoordinate3;
  points->point.setValues(0, static_cast<int>(ends.size()), ends.data());
  lines->addChild(points);
  auto* set = new SoLineSet;
  const std::vector<int32_t> pairs(ends.size() / 2, 2);
  set->numVertices.setValues(0, static_cast<int>(pairs.size()), pairs.data());
  lines->addChild(set);
  return lines;
}

SoSeparator* make_shaded_plane(const std::vector<SbVec3f>& corners,
                               const std::vector<SbColor>& colours) {
  auto* plane = new SoSeparator;
  plane->addChild(make_flat());
  auto* material = new SoMaterial;
  material->diffuseColor.setValues(0, static_cast<int>(colours.size()), colours.data());
  plane->addChild(material);
  auto* binding = new SoMaterialBinding;
  binding->value.setValue(SoMaterialBinding::PER_VERTEX);
  plane->addChild(binding);
  auto* points = new SoCoordinate3;
  points->point.setValues(0, static_cast<int>(corners.size()), corners.data());
  plane->addChild(points);
  auto* face = new SoFaceSet;
  face->numVertices.setValue(static_cast<int>(corners.size()));
  plane->addChild(face);
  return plane;
}

SoSeparator* make_room(const RoomSize& size) {
  auto* room = new SoSeparator;
  const auto& [floor, wall, front, w, top, grid] = size;
  room->addChild(
      make_shaded_plane({{-w, floor, wall}, {w, floor, wall}, {w, top, wall}, {-w, top, wall}},
                        {kWallColour, kWallColour, kWallTopColour, kWallTopColour}));
  room->addChild(make_shaded_plane(
      {{-w, floor, front}, {w, floor, front}, {w, floor, wall}, {-w, floor, wall}},
      {kFloorColour, kFloorColour, kFloorFarColour, kFloorFarColour}));
  constexpr float kLift_m = 0.0006F;  // above the planes: coplanar lines would flicker
  std::vector<SbVec3f> ends;
  for (float x = -w; x <= w + 1e-4F; x += grid) {
    ends.insert(ends.end(), {{x, floor, wall + kLift_m}, {x, top, wall + kLift_m}});
    ends.insert(ends.end(), {{x, floor + kLift_m, wall}, {x, floor + kLift_m, front}});
  }
  for (float y = floor + grid; y < top; y += grid)
    ends.insert(ends.end(), {{-w, y, wall + kLift_m}, {w, y, wall + kLift_m}});
  for (float z = wall; z <= front; z += grid)
    ends.insert(ends.end(), {{-w, floor + kLift_m, z}, {w, floor + kLift_m, z}});
  room->addChild(make_lines(ends, kGridColour, 1.0F));
  return room;
}

SoNode* make_shape(const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  switch (scene.shape) {
    case Shape::box: {
      auto* box = new SoCube;
      box->width.setValue(size[0]);
      box->height.setValue(size[1]);
      box->depth.setValue(size[2]);
      return box;
    }
    case Shape::cylinder: {  // axis = object z; the library's is y
      auto* turned = new SoSeparator;
      auto* turn = new SoTransform;
      turn->rotation.setValue(SbVec3f(1, 0, 0), static_cast<float>(M_PI / 2));
      auto* cylinder = new SoCylinder;
      cylinder->radius.setValue(size[0] / 2);
      cylinder->height.setValue(size[1]);
      turned->addChild(turn);
      turned->addChild(cylinder);
      return turned;
    }
    case Shape::sphere: {
      auto* sphere = new SoSphere;
      sphere->radius.setValue(size[0] / 2);
      return sphere;
    }
  }
  return new SoSeparator;
}

std::vector<SbVec3f> edges_of(const Scene& scene) {
  std::vector<SbVec3f> ends;
  if (scene.shape != Shape::box) return ends;
  const SbVec3f half = to_sb(scene.size_m) * 0.5F;
  for (int axis = 0; axis < 3; ++axis)
    for (const float u : {-1.0F, 1.0F})
      for (const float v : {-1.0F, 1.0F}) {
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        SbVec3f a;
        a[axis] = -half[axis];
        a[second] = u * half[second];
        a[third] = v * half[third];
        SbVec3f b = a;
        b[axis] = half[axis];
        ends.push_back(a);
        ends.push_back(b);
      }
  return ends;
}

SoSeparator* make_mark(const Scene& scene, const SbColor& colour, float transparency) {
  const SbVec3f size = extent_of(scene);
  auto* mark = new SoSeparator;
  mark->addChild(make_material(colour, transparency));
  auto* place = new SoTranslation;
  place->translation.setValue(0, 0.34F * size[1], 0.01F * size[2]);
  auto* stripe = new SoCube;
  stripe->width.setValue(0.62F * size[0]);
  stripe->height.setValue(0.14F * size[1]);
  stripe->depth.setValue(size[2]);
  mark->addChild(place);
  mark->addChild(stripe);
  return mark;
}

FingerNodes::FingerNodes() : shown(new SoSwitch), place(new SoTransform), form(new SoSwitch) {
  auto* group = new SoSeparator;
  group->addChild(place);
  auto* approaching = new SoSeparator;
  approaching->addChild(make_fingertip(1.0F));
  approaching->addChild(make_collar(kApproachColour, 0.0122F, 0.004F));
  form->addChild(approaching);
  // Touching: pressed flat, with a wide collar.
  auto* touching = new SoSeparator;
  touching->addChild(make_fingertip(1.12F));
  touching->addChild(make_collar(kTouchColour, 0.019F, 0.006F));
  form->addChild(touching);
  form->whichChild.setValue(0);
  group->addChild(form);
  shown->addChild(group);
}

SoSeparator* make_corners(const Scene& scene, const SbColor& colour) {
  constexpr float kRadius = 0.09F;  // of the shortest edge
  const SbVec3f size = extent_of(scene);
  auto* corners = new SoSeparator;
  corners->addChild(make_material(colour));
  for (const float x : {-0.5F, 0.5F})
    for (const float y : {-0.5F, 0.5F})
      for (const float z : {-0.5F, 0.5F}) {
        auto* one = new SoSeparator;
        auto* place = new SoTranslation;
        place->translation.setValue(x * size[0], y * size[1], z * size[2]);
        auto* ball = new SoSphere;
        ball->radius.setValue(kRadius * std::min({size[0], size[1], size[2]}));
        one->addChild(place);
        one->addChild(ball);
        corners->addChild(one);
      }
  return corners;
}

SoftShadow::SoftShadow() : root_(new SoSeparator) {}

void SoftShadow::build(const RoomSize& size, SoTransform* place, SoNode* form) {
  float lift_m = 0.0012F;
  for (std::size_t k = 0; k < kLayers; ++k) {
    auto* one = new SoSeparator;
    auto* flatten = new SoMatrixTransform;
    flatten->matrix.setValue(flatten_to_floor(size, lift_m));
    // The widest at the bottom: in the same plane they would hide each other.
    lift_m += 0.00025F;
    one->addChild(inks_[k] = make_material(kShadowColour, 1.0F));
    one->addChild(flatten);
    one->addChild(place);
    one->addChild(sizes_[k] = new SoTransform);
    one->addChild(form);
    root_->addChild(one);
  }
}

void SoftShadow::fall(float height_m) const {
  constexpr float kDark = 1.0F / static_cast<float>(kLayers);
  constexpr float kFades_m = 0.16F;
  const float high_m = std::max(0.0F, height_m);
  const float dark = kDark * std::exp(-high_m / kFades_m);
  for (std::size_t k = 0; k < kLayers; ++k) {
    const float out = static_cast<float>(kLayers - 1 - k) / static_cast<float>(kLayers - 1);
    const float wide = 0.92F + out * (0.20F + 1.1F * high_m);
    sizes_[k]->scaleFactor.setValue(wide, wide, wide);
    inks_[k]->transparency.setValue(1.0F - dark);
  }
}

SbMatrix flatten_to_floor(const RoomSize& size, float lift_m) {
  SbMatrix m = SbMatrix::identity();
  m[1][1] = 0.0F;
  m[3][1] = size.floor + lift_m;
  return m;
}
SbMatrix flatten_to_wall(const RoomSize& size) {
  // Light from the upper left: the shadow falls a little to the right and down.
  SbMatrix m = SbMatrix::identity();
  m[2][2] = 0.0F;
  m[3][0] = 0.012F;
  m[3][1] = -0.016F;
  m[3][2] = size.wall + 0.0012F;
  return m;
}

}  // namespace isograsp::gui::scene_nodes
