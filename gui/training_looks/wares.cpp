// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training_looks/wares.hpp"

#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShapeHints.h>
#include <Inventor/nodes/SoTranslation.h>

#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui::object_forms {

SoMaterial* make_shiny(const SbColor& colour, float shine, float transparency) {
  SoMaterial* material = scene_nodes::make_material(colour, transparency);
  material->ambientColor.setValue(colour * 0.9F);
  material->specularColor.setValue(shine, shine, shine);
  material->shininess.setValue(0.45F);
  return material;
}

SoShapeHints* make_open() {
  auto* hints = new SoShapeHints;
  hints->vertexOrdering.setValue(SoShapeHints::COUNTERCLOCKWISE);
  hints->shapeType.setValue(SoShapeHints::UNKNOWN_SHAPE_TYPE);
  return hints;
}

SoSeparator* make_board(const SbVec3f& middle, const SbVec3f& size, const SbColor& colour) {
  auto* board = new SoSeparator;
  auto* place = new SoTranslation;
  place->translation.setValue(middle);
  auto* box = new SoCube;
  box->width.setValue(size[0]);
  box->height.setValue(size[1]);
  box->depth.setValue(size[2]);
  board->addChild(place);
  board->addChild(make_shiny(colour, 0.12F));
  board->addChild(box);
  return board;
}

}  // namespace isograsp::gui::object_forms
