// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/object_scene.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <Inventor/SoDB.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoMatrixTransform.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include "gui/solids/scene_nodes.hpp"
#include "gui/solids/scene_view.hpp"
#include "gui/training_looks/object_forms.hpp"

namespace isograsp::gui {

using namespace scene_nodes;

struct ObjectScene::Parts {
  SoSeparator* root = new SoSeparator;
  SoPerspectiveCamera* camera = new SoPerspectiveCamera;
  SoTransform* object_place = new SoTransform;
  SoTransform* ghost_place = new SoTransform;
  SoSwitch* ghost_shown = new SoSwitch;
  SoSwitch* object_shown = new SoSwitch;
  SoSwitch* shadow_shown = new SoSwitch;
  SoSwitch* wall_shadow_shown = new SoSwitch;
  SoSwitch* ghost_shadow_shown = new SoSwitch;
  SoSwitch* room = new SoSwitch;  ///< 0: of a virtual object, 1: of a real one
  SoMatrixTransform* to_floor = new SoMatrixTransform;
  SoMatrixTransform* ghost_to_floor = new SoMatrixTransform;
  SoMatrixTransform* to_wall = new SoMatrixTransform;
  SoMaterial* object_colour = nullptr;  ///< of object_form
  SoSeparator* object_form = new SoSeparator;
  SoSeparator* ghost_form = new SoSeparator;
  SoSeparator* shadow_form = new SoSeparator;
  std::array<FingerNodes, kFingerCount> fingers;
  SceneView view;
  std::shared_ptr<const Scene> scene;
  std::optional<bool> in_space;  ///< which room is shown
  SoftShadow soft;
  SoSwitch* soft_shown = new SoSwitch;
  SoSwitch* living_room = nullptr;  ///< 0: with its grid; then in the three lights of training
  SoSwitch* shelf_shown = new SoSwitch;
  SoSeparator* shelf_form = new SoSeparator;
  tasks::Look look = tasks::Look::plain;
  object_forms::Form form;  ///< of a training look
  SbColor object_usual;

  /// The room, and where it is looked at from.
  void enter(bool space) {
    if (in_space == space) return;
    in_space = space;
    room->whichChild.setValue(space ? 1 : 0);
    const RoomSize& size = space ? kArmRoom : kTableRoom;
    // One above the other, and above the grid: in the same plane they would flicker.
    constexpr float kLift_m = 0.002F;
    if (space)
      to_floor->matrix.setValue(flatten_to_floor(size, 2.0F * kLift_m));
    else
      to_floor->matrix.setValue(flatten_to_floor(size));
    ghost_to_floor->matrix.setValue(flatten_to_floor(size, kLift_m));
    to_wall->matrix.setValue(flatten_to_wall(size));
    if (space) {  // from a little above: the floor tells the depth
      camera->position.setValue(0, 0.27F, 1.05F);
      camera->pointAt(SbVec3f(0, 0.02F, 0));
      camera->heightAngle.setValue(0.46F);
      camera->farDistance.setValue(4.0F);
    } else {
      camera->position.setValue(0, 0.055F, 0.86F);
      camera->pointAt(SbVec3f(0, 0.016F, 0));
      camera->heightAngle.setValue(0.46F);
      camera->farDistance.setValue(2.0F);
    }
  }

  void rebuild(bool space) {
    object_form->removeAllChildren();
    ghost_form->removeAllChildren();
    shadow_form->removeAllChildren();
    shelf_form->removeAllChildren();
    form = {};
    object_usual = kBlockColour;
    if (!space && object_forms::has_form(look, *scene)) return dress();
    object_form->addChild(object_colour = make_material(kBlockColour));
    object_colour->specularColor.setValue(0.22F, 0.22F, 0.22F);
    object_colour->shininess.setValue(0.3F);
    object_form->addChild(make_shape(*scene));
    object_form->addChild(make_mark(*scene, kBlockMark, 0.0F));
    shadow_form->addChild(make_shape(*scene));
    ghost_form->addChild(make_flat());
    ghost_form->addChild(make_material(kGhostColour, 0.72F));
    ghost_form->addChild(make_shape(*scene));
    ghost_form->addChild(make_mark(*scene, kGhostEdge, 0.45F));
    if (space) ghost_form->addChild(make_corners(*scene, kGhostCorner));
    // What turns about every axis keeps its stripe and its corners: a glass would not show it.
    if (look != tasks::Look::plain) object_forms::add_kitchen_details(*object_form, *scene);
    const auto edges = edges_of(*scene);
    if (edges.empty()) return;
    object_form->addChild(make_lines(edges, kBlockEdge, 1.5F));
    ghost_form->addChild(make_lines(edges, kGhostEdge, 2.5F));
  }

  /// Object and target in the form that the look gives them.
  void dress() {
    form = object_forms::make_form(look, *scene);
    object_colour = form.colour;
    object_usual = form.usual;
    object_form->addChild(form.solid);
    shadow_form->addChild(form.outline);
    ghost_form->addChild(make_flat());
    ghost_form->addChild(make_material(kGhostColour, 0.60F));
    ghost_form->addChild(form.outline);
    ghost_form->addChild(make_lines(form.edge, kGhostEdge, 2.5F));
    shelf_form->addChild(object_forms::make_shelf(*scene));
  }
};

ObjectScene::ObjectScene() {
  if (!SoDB::isInitialized()) SoDB::init();
  parts_ = std::make_unique<Parts>();
  Parts& p = *parts_;
  p.root->ref();
  p.root->renderCaching.setValue(SoSeparator::OFF);
  p.camera->nearDistance.setValue(0.2F);
  p.enter(false);
  p.root->addChild(p.camera);
  auto* light = new SoDirectionalLight;
  light->direction.setValue(0.35F, -0.75F, -0.85F);
  light->intensity.setValue(0.86F);
  p.root->addChild(light);
  // What the walls give back, from the other side and from below.
  auto* fill = new SoDirectionalLight;
  fill->direction.setValue(-0.6F, 0.25F, -0.75F);
  fill->intensity.setValue(0.26F);
  p.root->addChild(fill);
  auto* table = new SoSwitch;
  p.living_room = table;
  table->addChild(make_room(kTableRoom));
  for (const auto daylight :
       {tasks::Daylight::morning, tasks::Daylight::day, tasks::Daylight::evening})
    table->addChild(object_forms::make_living_room(daylight));
  table->whichChild.setValue(0);
  p.room->addChild(table);
  p.room->addChild(make_room(kArmRoom));
  p.root->addChild(p.room);

  auto* shadows = new SoSeparator;
  shadows->addChild(make_flat());
  const auto make_shadow = [&p](SoMatrixTransform* flatten, SoTransform* place,
                                const SbColor& colour, float transparency) {
    auto* shadow = new SoSeparator;
    shadow->addChild(make_material(colour, transparency));
    shadow->addChild(flatten);
    shadow->addChild(place);
    shadow->addChild(p.shadow_form);
    return shadow;
  };
  // The target's shadow below that of the object: where they differ the depth is not right yet.
  p.ghost_shadow_shown->addChild(make_shadow(p.ghost_to_floor, p.ghost_place, kGhostColour, 0.5F));
  p.shadow_shown->addChild(make_shadow(p.to_floor, p.object_place, kShadowColour, 0.55F));
  p.wall_shadow_shown->addChild(make_shadow(p.to_wall, p.object_place, kShadowColour, 0.82F));
  p.soft.build(kTableRoom, p.object_place, p.shadow_form);
  p.soft_shown->addChild(p.soft.root());
  shadows->addChild(p.ghost_shadow_shown);
  shadows->addChild(p.shadow_shown);
  shadows->addChild(p.soft_shown);
  shadows->addChild(p.wall_shadow_shown);
  p.root->addChild(shadows);

  auto* object = new SoSeparator;
  object->addChild(p.object_place);
  object->addChild(p.object_form);
  p.object_shown->addChild(object);
  p.root->addChild(p.object_shown);
  for (auto& finger : p.fingers) p.root->addChild(finger.shown);
  auto* shelf = new SoSeparator;
  shelf->addChild(p.ghost_place);
  shelf->addChild(p.shelf_form);
  p.shelf_shown->addChild(shelf);
  p.root->addChild(p.shelf_shown);
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
  p.enter(picture.in_space);
  if (picture.scene != nullptr && (picture.scene != p.scene || picture.look != p.look)) {
    p.scene = picture.scene;
    p.look = picture.look;
    p.rebuild(picture.in_space);
  }
  const auto show_if = [](SoSwitch* part, bool shown) {
    part->whichChild.setValue(shown ? SO_SWITCH_ALL : SO_SWITCH_NONE);
  };
  show_if(p.object_shown, picture.object_shown);
  const bool dressed =
      !picture.in_space && p.scene != nullptr && object_forms::has_form(p.look, *p.scene);
  p.living_room->whichChild.setValue(dressed ? 1 + static_cast<int>(picture.light) : 0);
  show_if(p.shelf_shown, dressed && picture.target_shown);
  object_forms::keep_level(p.form, picture.X_WO.q);
  // In the larger room the shadow tells the depth, and is sharp.
  show_if(p.shadow_shown, picture.in_space && picture.object_shown);
  show_if(p.soft_shown, !picture.in_space && picture.object_shown);
  if (p.scene != nullptr)
    p.soft.fall(static_cast<float>(picture.X_WO.p.y() - p.scene->size_m.y() / 2) -
                kTableRoom.floor);
  show_if(p.wall_shadow_shown, !picture.in_space && picture.object_shown);  // else it is far away
  show_if(p.ghost_shadow_shown, picture.in_space && picture.target_shown);
  const SbColor& colour = picture.unseen    ? kUnseenColour
                          : picture.matched ? kMatchedColour
                                            : p.object_usual;
  if (p.object_colour != nullptr) {
    p.object_colour->diffuseColor.setValue(colour);
    p.object_colour->ambientColor.setValue(colour);
  }
  p.object_place->translation.setValue(to_sb(picture.X_WO.p));
  p.object_place->rotation.setValue(to_sb(picture.X_WO.q));
  // A form that stands in its target would look muddy in it.
  show_if(p.ghost_shown, picture.target_shown && !(dressed && picture.matched));
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
  parts_->view.draw(*parts_->root, viewport_px);
}

QPointF ObjectScene::project(const Vec3& p_W, QSize size_px) const {
  return SceneView::project(*parts_->camera, p_W, size_px);
}

}  // namespace isograsp::gui
