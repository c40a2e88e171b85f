// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/object_scene.hpp"

#include <algorithm>
#include <vector>

#include <GL/gl.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoFaceSet.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoLineSet.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMatrixTransform.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>
#include <Inventor/nodes/SoTranslation.h>

namespace isograsp {

namespace {

constexpr float kFloor_m = -0.160F;  ///< y of the floor
constexpr float kWall_m = -0.110F;   ///< z of the wall
constexpr float kFront_m = 0.160F;   ///< z to which the floor reaches
constexpr float kHalfWidth_m = 0.60F;
constexpr float kTop_m = 0.49F;
constexpr float kGrid_m = 0.05F;

const SbColor kWallColour(0.91F, 0.93F, 0.95F);
const SbColor kFloorColour(0.83F, 0.86F, 0.89F);
const SbColor kGridColour(0.74F, 0.78F, 0.82F);
const SbColor kShadowColour(0.25F, 0.29F, 0.34F);
const SbColor kBlockColour(0.20F, 0.42F, 0.66F);
const SbColor kBlockMark(0.97F, 0.98F, 1.00F);
const SbColor kBlockEdge(0.05F, 0.14F, 0.26F);
const SbColor kGhostColour(0.96F, 0.66F, 0.10F);
const SbColor kGhostEdge(0.45F, 0.27F, 0.00F);
const SbColor kApproachColour(0.78F, 0.12F, 0.10F);
const SbColor kTouchColour(0.00F, 0.55F, 0.36F);

SbVec3f to_sb(const Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}
SbRotation to_sb(const Quat& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z()),
          static_cast<float>(q.w())};
}

SoMaterial* make_material(const SbColor& colour, float transparency = 0.0F) {
  auto* material = new SoMaterial;
  material->diffuseColor.setValue(colour);
  material->ambientColor.setValue(colour);
  material->transparency.setValue(transparency);
  return material;
}

/// What follows is drawn in its own colour whatever the light.
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

SoSeparator* make_plane(const std::vector<SbVec3f>& corners, const SbColor& colour) {
  auto* plane = new SoSeparator;
  plane->addChild(make_flat());
  plane->addChild(make_material(colour));
  auto* points = new SoCoordinate3;
  points->point.setValues(0, static_cast<int>(corners.size()), corners.data());
  plane->addChild(points);
  auto* face = new SoFaceSet;
  face->numVertices.setValue(static_cast<int>(corners.size()));
  plane->addChild(face);
  return plane;
}

SoSeparator* make_room() {
  auto* room = new SoSeparator;
  const float w = kHalfWidth_m;
  room->addChild(make_plane({{-w, kFloor_m, kWall_m},
                             {w, kFloor_m, kWall_m},
                             {w, kTop_m, kWall_m},
                             {-w, kTop_m, kWall_m}},
                            kWallColour));
  room->addChild(make_plane({{-w, kFloor_m, kFront_m},
                             {w, kFloor_m, kFront_m},
                             {w, kFloor_m, kWall_m},
                             {-w, kFloor_m, kWall_m}},
                            kFloorColour));
  constexpr float kLift_m = 0.0006F;  // above the planes: coplanar lines would flicker
  std::vector<SbVec3f> ends;
  for (float x = -w; x <= w + 1e-4F; x += kGrid_m) {
    ends.insert(ends.end(), {{x, kFloor_m, kWall_m + kLift_m}, {x, kTop_m, kWall_m + kLift_m}});
    ends.insert(ends.end(), {{x, kFloor_m + kLift_m, kWall_m}, {x, kFloor_m + kLift_m, kFront_m}});
  }
  for (float y = kFloor_m + kGrid_m; y < kTop_m; y += kGrid_m)
    ends.insert(ends.end(), {{-w, y, kWall_m + kLift_m}, {w, y, kWall_m + kLift_m}});
  for (float z = kWall_m; z <= kFront_m; z += kGrid_m)
    ends.insert(ends.end(), {{-w, kFloor_m + kLift_m, z}, {w, kFloor_m + kLift_m, z}});
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

SbVec3f extent_of(const Scene& scene) {
  const SbVec3f size = to_sb(scene.size_m);
  switch (scene.shape) {
    case Shape::box: return size;
    case Shape::cylinder: return {size[0], size[0], size[1]};
    case Shape::sphere: return {size[0], size[0], size[0]};
  }
  return size;
}

/// The edges of a box; other shapes have none.
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

/// A stripe along the upper edge: without it a turned block looks as before.
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

/// A cone whose tip is the origin and which points along +y.
SoSeparator* make_cone(float height_m, float radius_m, const SbColor& colour) {
  auto* group = new SoSeparator;
  group->addChild(make_material(colour));
  auto* place = new SoTranslation;
  place->translation.setValue(0, -height_m / 2, 0);
  auto* cone = new SoCone;
  cone->height.setValue(height_m);
  cone->bottomRadius.setValue(radius_m);
  group->addChild(place);
  group->addChild(cone);
  return group;
}

struct FingerNodes {
  SoSwitch* shown = new SoSwitch;
  SoTransform* place = new SoTransform;
  SoSwitch* form = new SoSwitch;  ///< 0: approaching, 1: touching

  FingerNodes() {
    auto* group = new SoSeparator;
    group->addChild(place);
    form->addChild(make_cone(0.050F, 0.0095F, kApproachColour));
    // Touching: shorter, wider, with a collar.
    auto* touching = new SoSeparator;
    touching->addChild(make_cone(0.036F, 0.0135F, kTouchColour));
    auto* behind = new SoTranslation;
    behind->translation.setValue(0, -0.039F, 0);
    auto* collar = new SoCylinder;
    collar->radius.setValue(0.019F);
    collar->height.setValue(0.006F);
    touching->addChild(make_material(kTouchColour));
    touching->addChild(behind);
    touching->addChild(collar);
    form->addChild(touching);
    form->whichChild.setValue(0);
    group->addChild(form);
    shown->addChild(group);
  }
};

SbMatrix flatten_to_floor() {
  SbMatrix m = SbMatrix::identity();
  m[1][1] = 0.0F;
  m[3][1] = kFloor_m + 0.0012F;
  return m;
}
SbMatrix flatten_to_wall() {
  // Light from the upper left: the shadow falls a little to the right and down.
  SbMatrix m = SbMatrix::identity();
  m[2][2] = 0.0F;
  m[3][0] = 0.012F;
  m[3][1] = -0.016F;
  m[3][2] = kWall_m + 0.0012F;
  return m;
}

}  // namespace

struct ObjectScene::Parts {
  SoSeparator* root = new SoSeparator;
  SoPerspectiveCamera* camera = new SoPerspectiveCamera;
  SoTransform* object_place = new SoTransform;
  SoTransform* ghost_place = new SoTransform;
  SoSwitch* ghost_shown = new SoSwitch;
  SoSeparator* object_form = new SoSeparator;
  SoSeparator* ghost_form = new SoSeparator;
  SoSeparator* shadow_form = new SoSeparator;
  std::array<FingerNodes, kFingerCount> fingers;
  std::unique_ptr<SoGLRenderAction> action;
  std::shared_ptr<const Scene> scene;

  void rebuild() {
    object_form->removeAllChildren();
    ghost_form->removeAllChildren();
    shadow_form->removeAllChildren();
    object_form->addChild(make_material(kBlockColour));
    object_form->addChild(make_shape(*scene));
    object_form->addChild(make_mark(*scene, kBlockMark, 0.0F));
    shadow_form->addChild(make_shape(*scene));
    ghost_form->addChild(make_flat());
    ghost_form->addChild(make_material(kGhostColour, 0.72F));
    ghost_form->addChild(make_shape(*scene));
    ghost_form->addChild(make_mark(*scene, kGhostEdge, 0.45F));
    const auto edges = edges_of(*scene);
    if (edges.empty()) return;
    object_form->addChild(make_lines(edges, kBlockEdge, 1.5F));
    ghost_form->addChild(make_lines(edges, kGhostEdge, 2.5F));
  }
};

ObjectScene::ObjectScene() {
  if (!SoDB::isInitialized()) SoDB::init();
  parts_ = std::make_unique<Parts>();
  Parts& p = *parts_;
  p.root->ref();
  p.root->renderCaching.setValue(SoSeparator::OFF);
  p.camera->position.setValue(0, 0.055F, 0.86F);
  p.camera->pointAt(SbVec3f(0, 0.016F, 0));
  p.camera->heightAngle.setValue(0.46F);
  p.camera->nearDistance.setValue(0.2F);
  p.camera->farDistance.setValue(2.0F);
  p.root->addChild(p.camera);
  auto* light = new SoDirectionalLight;
  light->direction.setValue(0.35F, -0.75F, -0.85F);
  light->intensity.setValue(0.95F);
  p.root->addChild(light);
  p.root->addChild(make_room());

  auto* shadows = new SoSeparator;
  shadows->addChild(make_flat());
  for (const auto& [matrix, transparency] :
       {std::pair{flatten_to_floor(), 0.55F}, std::pair{flatten_to_wall(), 0.82F}}) {
    auto* shadow = new SoSeparator;
    shadow->addChild(make_material(kShadowColour, transparency));
    auto* flatten = new SoMatrixTransform;
    flatten->matrix.setValue(matrix);
    shadow->addChild(flatten);
    shadow->addChild(p.object_place);
    shadow->addChild(p.shadow_form);
    shadows->addChild(shadow);
  }
  p.root->addChild(shadows);

  auto* object = new SoSeparator;
  object->addChild(p.object_place);
  object->addChild(p.object_form);
  p.root->addChild(object);
  for (auto& finger : p.fingers) p.root->addChild(finger.shown);
  auto* ghost = new SoSeparator;
  // A hair larger than the block: equal faces would show stripes when the block is in place.
  p.ghost_place->scaleFactor.setValue(1.01F, 1.01F, 1.01F);
  ghost->addChild(p.ghost_place);
  ghost->addChild(p.ghost_form);
  p.ghost_shown->addChild(ghost);
  p.root->addChild(p.ghost_shown);
}

ObjectScene::~ObjectScene() {
  parts_->root->unref();
}

void ObjectScene::show(const PatientPicture& picture) {
  Parts& p = *parts_;
  if (picture.scene != p.scene && picture.scene != nullptr) {
    p.scene = picture.scene;
    p.rebuild();
  }
  p.object_place->translation.setValue(to_sb(picture.object.p_WO));
  p.object_place->rotation.setValue(to_sb(picture.object.q_WO));
  p.ghost_shown->whichChild.setValue(picture.target_shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
  p.ghost_place->translation.setValue(to_sb(picture.target.p_WO));
  p.ghost_place->rotation.setValue(to_sb(picture.target.q_WO));
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& finger = picture.fingers[f];
    auto& nodes = p.fingers[f];
    nodes.shown->whichChild.setValue(finger.shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
    nodes.place->translation.setValue(to_sb(finger.tip_W));
    nodes.place->rotation.setValue(SbRotation(SbVec3f(0, 1, 0), to_sb(finger.axis_W)));
    nodes.form->whichChild.setValue(finger.touching ? 1 : 0);
  }
}

void ObjectScene::draw(QSize size_px) {
  Parts& p = *parts_;
  const SbViewportRegion region(static_cast<short>(size_px.width()),
                                static_cast<short>(size_px.height()));
  if (p.action == nullptr) {
    p.action = std::make_unique<SoGLRenderAction>(region);
    p.action->setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    p.action->setSmoothing(TRUE);
    p.action->setCacheContext(1);
  }
  p.action->setViewportRegion(region);
  glViewport(0, 0, size_px.width(), size_px.height());
  glClearColor(kWallColour[0], kWallColour[1], kWallColour[2], 1.0F);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  p.action->apply(p.root);
}

QPointF ObjectScene::project(const Vec3& p_W, QSize size_px) const {
  const float aspect = static_cast<float>(size_px.width()) / static_cast<float>(size_px.height());
  SbViewVolume volume = parts_->camera->getViewVolume(aspect);
  SbVec3f place;
  volume.projectToScreen(to_sb(p_W), place);
  return {static_cast<qreal>(place[0]) * size_px.width(),
          (1.0 - static_cast<qreal>(place[1])) * size_px.height()};
}

}  // namespace isograsp
