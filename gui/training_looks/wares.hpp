// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/training_looks only: what furniture and objects are made of.
#pragma once

#include <Inventor/SbColor.h>
#include <Inventor/SbLinear.h>

class SoMaterial;
class SoSeparator;
class SoShapeHints;

namespace isograsp::gui::object_forms {

[[nodiscard]] SoMaterial* make_shiny(const SbColor& colour, float shine, float transparency = 0.0F);
/// Seen from within as well.
[[nodiscard]] SoShapeHints* make_open();
[[nodiscard]] SoSeparator* make_board(const SbVec3f& middle, const SbVec3f& size,
                                      const SbColor& colour);

}  // namespace isograsp::gui::object_forms
