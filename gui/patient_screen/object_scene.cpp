// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/object_scene.hpp"

#include <algorithm>
#include <vector>

#include <GL/gl.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMatrixTransform.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include "gui/patient_screen/scene_nodes.hpp"

namespace isograsp::gui {

using namespace scene_nodes;

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
  // Slightly larger than the block: faces in the same plane would flicker when the block is in
  // place.
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
  p.object_place->translation.setValue(to_sb(picture.X_WO.p));
  p.object_place->rotation.setValue(to_sb(picture.X_WO.q));
  p.ghost_shown->whichChild.setValue(picture.target_shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
  p.ghost_place->translation.setValue(to_sb(picture.X_WT.p));
  p.ghost_place->rotation.setValue(to_sb(picture.X_WT.q));
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& finger = picture.fingers[f];
    auto& nodes = p.fingers[f];
    nodes.shown->whichChild.setValue(finger.shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
    nodes.place->translation.setValue(to_sb(finger.tip_W));
    nodes.place->rotation.setValue(SbRotation(SbVec3f(0, 1, 0), to_sb(finger.axis_W)));
    nodes.form->whichChild.setValue(finger.touching ? 1 : 0);
  }
}

void ObjectScene::draw(const QRect& viewport_px) {
  Parts& p = *parts_;
  const QRect& v = viewport_px;
  SbViewportRegion region;
  region.setWindowSize(static_cast<short>(v.x() + v.width()),
                       static_cast<short>(v.y() + v.height()));
  region.setViewportPixels(static_cast<short>(v.x()), static_cast<short>(v.y()),
                           static_cast<short>(v.width()), static_cast<short>(v.height()));
  if (p.action == nullptr) {
    p.action = std::make_unique<SoGLRenderAction>(region);
    p.action->setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    p.action->setSmoothing(TRUE);
    p.action->setCacheContext(1);
  }
  p.action->setViewportRegion(region);
  glViewport(v.x(), v.y(), v.width(), v.height());
  glEnable(GL_SCISSOR_TEST);
  glScissor(v.x(), v.y(), v.width(), v.height());
  glClearColor(kWallColour[0], kWallColour[1], kWallColour[2], 1.0F);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  p.action->apply(p.root);
  glDisable(GL_SCISSOR_TEST);
}

QPointF ObjectScene::project(const Vec3& p_W, QSize size_px) const {
  const float aspect = static_cast<float>(size_px.width()) / static_cast<float>(size_px.height());
  SbViewVolume volume = parts_->camera->getViewVolume(aspect);
  SbVec3f place;
  volume.projectToScreen(to_sb(p_W), place);
  return {static_cast<qreal>(place[0]) * size_px.width(),
          (1.0 - static_cast<qreal>(place[1])) * size_px.height()};
}

}  // namespace isograsp::gui
