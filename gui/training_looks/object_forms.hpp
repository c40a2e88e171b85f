// SPDX-License-Identifier: GPL-3.0-or-later
// What an object of a task is drawn as in training: as large as it is, held where it is held.
#pragma once

#include <vector>

#include <Inventor/SbColor.h>
#include <Inventor/SbLinear.h>

#include "grasp_model/scene.hpp"
#include "tasks/looks/look.hpp"

class SoCoordinate3;
class SoMaterial;
class SoNode;
class SoSeparator;
class SoVertexProperty;

namespace isograsp::gui::object_forms {

/// What is drawn of an object, in its own frame; whoever they are added to owns the nodes.
struct Form {
  SoSeparator* solid = nullptr;     ///< in its colours
  SoMaterial* colour = nullptr;     ///< of its part that turns green on the target
  SbColor usual;                    ///< of that part
  SoNode* outline = nullptr;        ///< its shape without colours, for its target and its shadow
  std::vector<SbVec3f> edge;        ///< pairs of points: how its shape looks from the front
  SoVertexProperty* tea = nullptr;  ///< what is in a glass; null: nothing is (keep_level)
  float tea_radius_m = 0.0F;
  float tea_top_m = 0.0F;
};
/// @pre the object is a box
[[nodiscard]] Form make_form(tasks::Look look, const Scene& scene);
/// The tea stays level however the glass is turned.
void keep_level(const Form& form, const Quat& q_WO);
/// Lid and label, on a body that is drawn as it is: of jars and tins in a kitchen.
void add_kitchen_details(SoSeparator& form, const Scene& scene);
/// The shelf under a place of the object.
[[nodiscard]] SoSeparator* make_shelf(const Scene& scene);
/// Table and wall of a room in that light.
[[nodiscard]] SoSeparator* make_living_room(tasks::Daylight light);
/// Round forms show no turn about their axis: they are for boxes that turn about z alone.
[[nodiscard]] bool has_form(tasks::Look look, const Scene& scene) noexcept;

}  // namespace isograsp::gui::object_forms
