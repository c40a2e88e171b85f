// SPDX-License-Identifier: GPL-3.0-or-later
// The plan in words, for `isograsp grasp`.
#include "grasp_model/plan_words.hpp"

#include <algorithm>

#include "core/csv.hpp"
#include "grasp_model/dormand_prince.hpp"

namespace isograsp {

namespace {

/// Coefficients of the Runge-Kutta step that are not 0: of the stages, the end, both errors.
constexpr int kCoefficients = 1 + 2 + 2 + 3 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 8 + 8 + 9;

int flops_of_free_rotation(const Plan& plan) {
  const so3::Body& body = plan.body();
  const Scene& scene = plan.scene();
  constexpr int kState = 7;
  int rate = 4 * 7 + 3 * 8;                             // quaternion, momentum
  if (!body.stiffness.isZero(0.0)) rate += 6 + 30 + 7;  // angle of the half, polynomial, torque
  const bool even = body.stiffness.minCoeff() == body.stiffness.maxCoeff();
  if (!even) rate += 45;
  if (scene.wrench_frame == WrenchFrame::hand) rate += 33;  // torque turned into the body
  int flops = 12 * rate + 2 * kState * kCoefficients;
  if (plan.force_follows()) {
    constexpr int kTurned = 30;
    const int axes = static_cast<int>(std::count(scene.free.begin(), scene.free.begin() + 3, true));
    flops += 10 * kTurned + axes * (11 + 5 * 8);
  }
  return flops + 80;  // rates, normalisation, frames
}

}  // namespace

int flops_per_frame(const Plan& plan) {
  const Scene& scene = plan.scene();
  const int axes = static_cast<int>(std::count(scene.free.begin(), scene.free.begin() + 3, true));
  const int free = static_cast<int>(std::count(scene.free.begin(), scene.free.end(), true));
  constexpr int kStep = 12;  // LinearStep::advance, anchor and weight
  int flops = 0;
  for (const Contact& contact : scene.contacts) {
    const bool soft = contact.model == ContactModel::soft && contact.torsion_m > 0.0;
    const int columns = contact.model == ContactModel::frictionless ? 1 : soft ? 4 : 3;
    flops += contact.model == ContactModel::frictionless ? 0 : soft ? 14 : 5;
    flops += 2 * columns * free;
  }
  if (plan.coupled())
    flops += 5 * 2 * axes * axes + 3 * axes;
  else if (!plan.force_follows())
    flops += kStep * axes;
  switch (plan.rotations()) {
    case Plan::Rotations::none: break;
    case Plan::Rotations::one_axis:
      flops += kStep + 32;  // cosine and sine
      if (plan.force_follows()) flops += 6 * (kStep + 32 + 6) + axes * (11 + 5 * 5);
      break;
    case Plan::Rotations::three: flops += flops_of_free_rotation(plan);
  }
  return flops;
}

std::vector<std::pair<std::string, std::string>> words_of(const Plan& plan) {
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
                           "integrated " +
                           (plan.rotations() == Plan::Rotations::three
                                ? "by the stages of the rotation, error as that"
                                : "by 5-point Gauss quadrature, relative error below 1e-11"));
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
  lines.emplace_back(
      "flops", std::to_string(flops_per_frame(plan)) + " additions and multiplications a frame" +
                   (plan.rotations() == Plan::Rotations::three ? ", in one step a hold" : ""));
  return lines;
}

}  // namespace isograsp
