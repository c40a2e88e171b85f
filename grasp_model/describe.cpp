// SPDX-License-Identifier: GPL-3.0-or-later
// The plan in words, for `isograsp grasp`.
#include "core/csv.hpp"
#include "grasp_model/grasp.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp {

std::vector<std::pair<std::string, std::string>> describe(const Plan& plan) {
  const Scene& scene = plan.scene();
  const auto axes = [&](std::size_t first) {
    std::string names;
    for (std::size_t i = first; i < first + 3; ++i)
      if (scene.free[i]) names += (names.empty() ? "" : " ") + std::string(kDofNames[i]);
    return names;
  };
  std::vector<std::pair<std::string, std::string>> lines;
  const std::string linear = axes(0);
  if (linear.empty())
    lines.emplace_back("translation", "none: x y z are locked and cost nothing");
  else if (plan.force_follows())
    lines.emplace_back("translation",
                       linear +
                           ": exact response; the force turns with the object within the hold, "
                           "integrated by 5-point Gauss quadrature, relative error below " +
                           (plan.rotations() == Plan::Rotations::three ? "1e-6" : "1e-11"));
  else if (plan.coupled())
    lines.emplace_back("translation",
                       linear +
                           ": coupled by springs or dampers at an angle, exact step by one "
                           "matrix exponential, error of rounding only");
  else
    lines.emplace_back("translation",
                       linear + ": uncoupled, closed-form exact step, error of rounding only");
  switch (plan.rotations()) {
    case Plan::Rotations::none:
      lines.emplace_back("rotation", "none: rx ry rz are locked and cost nothing");
      break;
    case Plan::Rotations::one_axis:
      lines.emplace_back("rotation",
                         axes(3) +
                             ": one fixed axis, closed-form exact step of the unwrapped "
                             "angle, error of rounding only");
      break;
    case Plan::Rotations::three:
      lines.emplace_back("rotation",
                         "rx ry rz: coupled, Dormand-Prince 8(5,3) on the unit "
                         "quaternion, steps of a hold / 2^n to an estimated error of " +
                             format_number(scene.tolerance_rad) +
                             " rad a hold; extrapolated implicit Euler if too stiff");
  }
  std::string contacts;
  for (const auto& contact : scene.contacts) {
    constexpr const char* kModels[] = {"frictionless", "point", "soft"};
    contacts += (contacts.empty() ? "" : ", ") + std::string(name_of(contact.finger)) + " " +
                kModels[static_cast<std::size_t>(contact.model)];
  }
  lines.emplace_back("contacts", contacts.empty() ? "none" : contacts);
  lines.emplace_back("wrench_frame", scene.wrench_frame == WrenchFrame::hand
                                         ? "hand: constant in world axes"
                                         : "object: constant in object axes");
  lines.emplace_back("grasp_rule", scene.grasp_rule == GraspRule::any
                                       ? "any: each touching finger acts"
                                   : scene.grasp_rule == GraspRule::opposition
                                       ? "opposition: table of 8 finger sets"
                                       : "closure: table of 8 finger sets");
  lines.emplace_back(
      "limits", scene.limits.empty() ? "none" : "stop at the crossing inside the hold, no bounce");
  lines.emplace_back("hold_s", format_number(plan.hold_s()));
  return lines;
}

}  // namespace isograsp
