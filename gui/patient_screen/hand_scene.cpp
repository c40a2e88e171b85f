// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/hand_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <GL/gl.h>
#include <Inventor/SoDB.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>
#include <Inventor/nodes/SoTransform.h>

#include "gui/patient_screen/hand_colours.hpp"
#include "gui/patient_screen/hand_nodes.hpp"
#include "gui/patient_screen/hand_props.hpp"
#include "gui/solids/scene_nodes.hpp"
#include "gui/solids/scene_view.hpp"
#include "gui/training_looks/object_forms.hpp"

namespace isograsp::gui {

using namespace scene_nodes;
using virtual_hand::ObjectShape;

namespace {

/// Where it is looked at from, above the table: over the own shoulder, as one sees the own hand.
const Vec3 kEye_m(0.0, 0.50, 0.74);
const Vec3 kLooksAt_m(0.0, 0.10, 0.035);
/// Seen from top to bottom, where the picture is at least so much wider than high.
constexpr double kHeightAngle_rad = 0.36;
constexpr double kLeastAspect = 1.5;

constexpr int kShadePoints = 128;

void mask_colours(void* on, SoAction* action) {
  if (!action->isOfType(SoGLRenderAction::getClassTypeId())) return;
  const GLboolean drawn = on != nullptr ? GL_TRUE : GL_FALSE;
  glColorMask(drawn, drawn, drawn, drawn);
}

SoCallback* make_mask(bool on) {
  static bool yes = true;
  auto* mask = new SoCallback;
  mask->setCallback(mask_colours, on ? &yes : nullptr);
  return mask;
}

/// A narrow picture shows as much from left to right as a wide one.
void fit(SoPerspectiveCamera& camera, double aspect) {
  const double half = std::tan(0.5 * kHeightAngle_rad) * std::max(1.0, kLeastAspect / aspect);
  camera.aspectRatio.setValue(static_cast<float>(aspect));
  camera.heightAngle.setValue(static_cast<float>(2.0 * std::atan(half)));
}

}  // namespace

struct HandScene::Parts {
  SoSeparator* root = new SoSeparator;
  SoPerspectiveCamera* camera = new SoPerspectiveCamera;
  SoTransform* table_place = new SoTransform;
  ShadedPlane table{kTableColour};
  ShadedPlane block_top{kBlockTop};
  SoSwitch* block_shown = new SoSwitch;
  SoTransform* block_place = new SoTransform;
  SoCube* block = new SoCube;
  SoSwitch* object_shown = new SoSwitch;
  SoTransform* object_place = new SoTransform;
  SoSeparator* object_form = new SoSeparator;
  SoMaterial* object_colour = nullptr;
  SoSwitch* target_shown = new SoSwitch;
  SoTransform* target_place = new SoTransform;
  SoSeparator* target_form = new SoSeparator;
  SoMaterial* target_colour = nullptr;
  SoSwitch* foot_shown = new SoSwitch;
  SoTransform* foot_place = new SoTransform;
  MovedLine way{kTargetColour, 3.0F, kWhole};
  MovedLine drop{kTargetEdge, 2.0F, kDashed};
  std::array<MarkNodes, kDigitCount> marks;
  HandNodes hand;
  SoSwitch* hand_shown = new SoSwitch;
  HandNodes tracked;
  SoSwitch* tracked_shown = new SoSwitch;
  SoMaterial* tracked_colour = make_material(kTrackedColour, 0.6F);
  SceneView view;
  std::optional<ObjectShape> shape;       ///< that is built …
  tasks::Look look = tasks::Look::plain;  ///< … in this look

  void build_room();
  void build_things();
  void build_hands();
  void build(const ObjectShape& of, tasks::Look in);
  void show_table(const HandPicture& picture);
  void show_object(const HandPicture& picture);
  void show_target(const HandPicture& picture);
};

void HandScene::Parts::build_room() {
  auto* ambient = new SoEnvironment;
  ambient->ambientIntensity.setValue(0.42F);
  root->addChild(ambient);
  for (const auto& [direction, intensity] :
       {std::pair{SbVec3f(0.45F, -0.85F, -0.45F), 0.62F}, {SbVec3f(-0.7F, -0.25F, -0.6F), 0.20F}}) {
    auto* light = new SoDirectionalLight;
    light->direction.setValue(direction);
    light->intensity.setValue(intensity);
    root->addChild(light);
  }
  auto* plain = new SoSeparator;
  plain->addChild(table_place);
  plain->addChild(make_table());
  root->addChild(plain);
  root->addChild(table.root);
  auto* support = new SoSeparator;
  auto* body = new SoSeparator;
  body->addChild(block_place);
  body->addChild(make_material(kBlockSide));
  body->addChild(block);
  support->addChild(body);
  support->addChild(block_top.root);
  block_shown->addChild(support);
  root->addChild(block_shown);
}

void HandScene::Parts::build_things() {
  auto* object = new SoSeparator;
  object->addChild(object_place);
  object->addChild(object_form);
  object_shown->addChild(object);
  root->addChild(object_shown);
  for (auto& mark : marks) root->addChild(mark.shown);
  root->addChild(drop.shown);
  root->addChild(way.shown);
  auto* foot = new SoSeparator;
  foot->addChild(foot_place);
  foot->addChild(make_foot());
  foot_shown->addChild(foot);
  root->addChild(foot_shown);
  auto* target = new SoSeparator;
  // Faces in the same plane would flicker when the object is in place.
  target_place->scaleFactor.setValue(1.03F, 1.03F, 1.03F);
  target->addChild(target_place);
  target->addChild(target_form);
  target_shown->addChild(target);
  root->addChild(target_shown);
}

void HandScene::Parts::build_hands() {
  hand_shown->addChild(hand.root());
  root->addChild(hand_shown);
  // Its depth first, in no colour: only the nearest surface is seen through, not all its parts.
  auto* see_through = new SoSeparator;
  see_through->renderCaching.setValue(SoSeparator::OFF);
  see_through->addChild(make_mask(false));
  see_through->addChild(tracked.root());
  see_through->addChild(make_mask(true));
  tracked_colour->setOverride(TRUE);
  see_through->addChild(tracked_colour);
  see_through->addChild(tracked.root());
  tracked_shown->addChild(see_through);
  root->addChild(tracked_shown);
}

void HandScene::Parts::build(const ObjectShape& of, tasks::Look in) {
  if (shape && shape->kind == of.kind && shape->half_m == of.half_m && look == in) return;
  shape = of;
  look = in;
  object_form->removeAllChildren();
  target_form->removeAllChildren();
  object_form->addChild(object_colour = make_material(kThingColour));
  object_form->addChild(make_body(of));
  object_form->addChild(make_lines(outline_of(of), kThingEdge, 1.5F));
  if (look == tasks::Look::jar) object_forms::add_kitchen_details(*object_form, scene_of(of));
  target_form->addChild(target_colour = make_material(kTargetColour, 0.6F));
  target_form->addChild(make_body(of));
  target_form->addChild(make_lines(outline_of(of), kTargetEdge, 2.0F));
}

void HandScene::Parts::show_table(const HandPicture& picture) {
  const double table_m = picture.ground.table_m;
  const auto at = [](double value) { return static_cast<float>(value); };
  table_place->translation.setValue(0.0F, at(table_m), 0.0F);
  constexpr double kLeft_m = -0.34, kFront_m = 0.36, kWide_m = 0.68, kDeep_m = 0.62;
  table.show(picture, {kLeft_m, kFront_m, kWide_m, kDeep_m, table_m, kShadePoints, kShadePoints});
  show_if(block_shown, picture.ground.block.has_value());
  if (!picture.ground.block) return;
  const hand_world::SupportBlock& of = *picture.ground.block;
  block->width.setValue(at(2.0 * of.half_x_m));
  block->depth.setValue(at(2.0 * of.half_z_m));
  block->height.setValue(at(of.top_m - table_m));
  block_place->translation.setValue(at(of.x_m), at(0.5 * (of.top_m + table_m)), at(of.z_m));
  block_top.show(picture, {of.x_m - of.half_x_m, of.z_m + of.half_z_m, 2.0 * of.half_x_m,
                           2.0 * of.half_z_m, of.top_m, kShadePoints / 2, kShadePoints / 2});
}

void HandScene::Parts::show_object(const HandPicture& picture) {
  show_if(object_shown, picture.object.has_value());
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    show_if(marks[d].shown, picture.marks[d].has_value());
    if (!picture.marks[d]) continue;
    const bool tied = picture.tips[d] == HandPicture::Tip::tied;
    marks[d].show(*picture.marks[d], tied ? kTiedColour : kTouchesColour);
  }
  if (!picture.object) return;
  build(*picture.object, picture.look);
  const SbColor& colour = picture.placed ? kPlacedColour : kThingColour;
  set_colour(object_colour, colour);
  object_place->translation.setValue(to_sb(picture.X_WO.p));
  object_place->rotation.setValue(to_sb(picture.X_WO.q));
}

void HandScene::Parts::show_target(const HandPicture& picture) {
  const bool shown = picture.target != HandPicture::Target::none && picture.object;
  const bool away = shown && picture.target == HandPicture::Target::away;
  show_if(target_shown, shown);
  show_if(foot_shown, shown);
  show_if(drop.shown, shown);
  show_if(way.shown, away);
  if (!shown) return;
  target_colour->transparency.setValue(away ? 0.6F : 0.0F);
  target_place->translation.setValue(to_sb(picture.X_WT.p));
  target_place->rotation.setValue(to_sb(picture.X_WT.q));
  Vec3 foot_W = picture.X_WT.p;
  foot_W.y() = picture.ground.height_below(foot_W) + 3.0 * static_cast<double>(kOverTable_m);
  foot_place->translation.setValue(to_sb(foot_W));
  drop.show(picture.X_WT.p, foot_W);
  if (away) way.show(picture.X_WO.p, picture.X_WT.p);
}

HandScene::HandScene() {
  if (!SoDB::isInitialized()) SoDB::init();
  parts_ = std::make_unique<Parts>();
  Parts& p = *parts_;
  p.root->ref();
  p.root->renderCaching.setValue(SoSeparator::OFF);
  p.camera->viewportMapping.setValue(SoCamera::LEAVE_ALONE);
  p.camera->nearDistance.setValue(0.2F);
  p.camera->farDistance.setValue(3.0F);
  p.root->addChild(p.camera);
  p.build_room();
  p.build_things();
  p.build_hands();
}

HandScene::~HandScene() {
  parts_->root->unref();
}

void HandScene::show(const HandPicture& picture) {
  Parts& p = *parts_;
  const Vec3 table(0.0, picture.ground.table_m, 0.0);
  p.camera->position.setValue(to_sb(table + kEye_m));
  p.camera->pointAt(to_sb(table + kLooksAt_m));
  p.show_table(picture);
  p.show_object(picture);
  p.show_target(picture);
  show_if(p.hand_shown, picture.hand.has_value());
  if (picture.hand) {
    p.hand.place(*picture.hand, picture.radii_m);
    p.hand.tint(picture.tips, picture.frozen);
  }
  show_if(p.tracked_shown, picture.tracked.has_value());
  if (picture.tracked) {
    p.tracked.place(*picture.tracked, picture.radii_m);
    p.tracked.tint({}, false);
    p.tracked_colour->transparency.setValue(1.0F - static_cast<float>(picture.tracked_opacity));
  }
}

void HandScene::draw(const QRect& viewport_px) {
  fit(*parts_->camera, static_cast<double>(viewport_px.width()) / viewport_px.height());
  parts_->view.draw(*parts_->root, viewport_px);
}

QPointF HandScene::project(const Vec3& p_W, QSize size_px) const {
  fit(*parts_->camera, static_cast<double>(size_px.width()) / size_px.height());
  return SceneView::project(*parts_->camera, p_W, size_px);
}

}  // namespace isograsp::gui
