// SPDX-License-Identifier: GPL-3.0-or-later
// The plan in words, for `isograsp grasp`.
#include "grasp_model/plan_words.hpp"

#include <algorithm>

#include "core/csv.hpp"

namespace isograsp {

namespace {

/// Coefficients of a Runge-Kutta step that are not 0: of the stages, the end, the errors.
int coefficients_of(so3::Order order) {
  constexpr int kThird = 1 + 1 + 3 + 3;
  constexpr int kFifth = 1 + 2 + 3 + 4 + 5 + 4 + 5;
  constexpr int kEighth = 1 + 2 + 2 + 3 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 8 + 8 + 9;
  return order == so3::Order::third ? kThird : order == so3::Order::fifth ? kFifth : kEighth;
}

int flops_of_free_rotation(const Plan& plan) {
  const so3::Body& body = plan.body();
  const Scene& scene = plan.scene();
  const so3::Order order = order_of(plan.likely_level());
  constexpr int kState = 7;
  int rate = 4 * 7 + 3 * 8;                             // quaternion, momentum
  if (!body.stiffness.isZero(0.0)) rate += 6 + 30 + 7;  // angle of the half, polynomial, torque
  const bool even = body.stiffness.minCoeff() == body.stiffness.maxCoeff();
  if (!even) rate += 45;
  if (scene.wrench_frame == WrenchFrame::hand) rate += 33;  // torque turned into the body
  int flops = so3::evaluations(order) * rate + 2 * kState * coefficients_of(order);
  if (plan.force_follows()) {
    constexpr int kTurned = 30;
    const int axes = static_cast<int>(std::count(scene.free.begin(), scene.free.begin() + 3, true));
    const int nodes = static_cast<int>(stage_nodes(order).size);
    flops += (nodes + 2) * kTurned + axes * (11 + 5 * nodes);
  }
  return flops + 80;  // rates, normalisation, frames
}

std::string words_of_free_rotation(const Plan& plan) {
  constexpr const char* kSteps[] = {"order 3 (Bogacki-Shampine, 3 evaluations)",
                                    "order 5 (Cash-Karp, 6 evaluations)",
                                    "order 8 (Dormand-Prince, 12 evaluations)"};
  const auto step = [&](int level) -> std::string {
    return kSteps[static_cast<std::size_t>(order_of(level))];
  };
  std::string words =
      "rx ry rz: coupled, explicit steps on the unit quaternion to an estimated "
      "error of " +
      format_number(plan.scene().tolerance_rad) + " rad a hold, " + step(plan.likely_level());
  if (plan.coarsest_level() < 0)
    words += " to begin with, as the estimate asks from " + step(plan.coarsest_level()) + " to " +
             step(0);
  return words + " in steps of a hold / 2^n; extrapolated implicit Euler if too stiff";
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
    case Plan::Rotations::three: lines.emplace_back("rotation", words_of_free_rotation(plan));
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
