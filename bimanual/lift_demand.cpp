// SPDX-License-Identifier: GPL-3.0-or-later
//   raise   = (k_y (y - y_anchor) - m g_y) / 2
//   squeeze = kSqueezeMargin raise / mu
#include "bimanual/lift_demand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isograsp::bimanual {

namespace {

/// A contact of a whole hand across the line of the hands, with friction.
Result<void> check_contact(const HandsScene& scene, Side side) {
  const HandContacts& hand = scene.contacts[index_of(side)];
  if (!hand.whole || hand.contacts.size() != 1)
    return refused(
               "is lifted by whole hands: one contact of each"_text,
               "write one [[contact]] with hand = \"left\" and one with \"right\", no finger"_text)
        .at(scene.object.file)
        .about("contact");
  const Contact& contact = hand.contacts.front();
  constexpr double kUpright = 0.1;  // of a normal: it would carry by itself
  const double towards = side == Side::left ? contact.R_OC(0, 2) : -contact.R_OC(0, 2);
  if (!(towards > 0.0) || std::abs(contact.R_OC(1, 2)) > kUpright)
    return refused("has hands that do not press against each other across"_text,
                   "give the left contact the normal [1, 0, 0] and the right one [-1, 0, 0]"_text)
        .at(scene.object.file)
        .about("normal");
  if (contact.model == ContactModel::frictionless || !(contact.friction > 0.0))
    return refused("has no friction by which hands could lift it"_text,
                   "write model = \"point\" and a friction above zero"_text)
        .at(scene.object.file)
        .about("friction");
  return {};
}

double most_y(const Scene& object) {
  double most = std::numeric_limits<double>::infinity();
  for (const TravelLimit& limit : object.limits)
    if (limit.dof == Dof::y) most = std::min(most, limit.most);
  return most;
}

}  // namespace

Result<LiftDemand> lift_demand(const HandsScene& scene, double height_m) {
  const Scene& object = scene.object;
  if (scene.coupling != Coupling::force)
    return refused("is no object that hands lift by what they press"_text,
                   "write coupling = \"force\" in [hands]"_text)
        .at(object.file)
        .about("coupling");
  for (const Side side : {Side::left, Side::right})
    if (auto good = check_contact(scene, side); !good) return good.error();
  constexpr Eigen::Index kUp = 1;
  const double y_m = object.initial_X_WO.p.y() + height_m;
  if (!object.free[static_cast<std::size_t>(Dof::y)] || !(y_m < most_y(object)))
    return refused("cannot be lifted to the height of the task"_text,
                   "free y and widen its limit, or lower height_m in the task"_text)
        .at(object.file)
        .about("limits");
  LiftDemand demand;
  demand.raise_N = 0.5 * (object.stiffness[kUp] * (y_m - object.anchor_m.y()) -
                          object.mass_kg * object.gravity_m_s2.y());
  if (!(demand.raise_N > 0.0))
    return refused("weighs nothing at the height of the task"_text,
                   "give it a mass and gravity_m_s2 = [0, -9.81, 0]"_text)
        .at(object.file)
        .about("mass_kg");
  double friction = std::numeric_limits<double>::infinity();
  for (const HandContacts& hand : scene.contacts)
    friction = std::min(friction, hand.contacts.front().friction);
  demand.squeeze_N = kSqueezeMargin * demand.raise_N / friction;
  return demand;
}

HandsScene strengthened(HandsScene scene, double factor) {
  scene.object.mass_kg *= factor;
  scene.object.inertia_kg_m2 *= factor;
  scene.object.stiffness *= factor;
  scene.object.damping *= factor;
  for (HandContacts& hand : scene.contacts)
    for (Contact& contact : hand.contacts) contact.threshold_N *= factor;
  return scene;
}

}  // namespace isograsp::bimanual
