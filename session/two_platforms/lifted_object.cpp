// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/lifted_object.hpp"

#include <algorithm>
#include <utility>

#include "session/two_platforms/named_scene.hpp"
#include "session/two_platforms/side_of.hpp"

namespace isograsp::session {

namespace {

/// The one contact of a whole hand stands in the place of the first finger.
constexpr std::size_t kWhole = 0;

}  // namespace

LiftedObject::LiftedObject(bimanual::HandsScene scene, bimanual::PressedByHands pressed,
                           double strength, std::string text)
    : scene_(std::move(scene)),
      pressed_(std::move(pressed)),
      state_(pressed_.initial_state()),
      strength_(strength),
      text_(std::move(text)) {}

Result<LiftedObject> LiftedObject::make(const std::string& scene, const std::string& file,
                                        double strength, double period_s) {
  auto read = bimanual::parse_hands_scene(scene, file);
  if (!read) return read.error();
  auto strong = bimanual::strengthened(*std::move(read), strength);
  auto pressed = bimanual::PressedByHands::compile(strong.object, strong.contacts, period_s);
  if (!pressed) return pressed.error();
  return LiftedObject(std::move(strong), *std::move(pressed), strength, scene);
}

Result<LiftedObject> LiftedObject::read(const tasks::TaskSpec& spec,
                                        const tasks::TaskContext& context,
                                        const std::string& library) {
  const auto named = named_scene(spec, library);
  if (!named) return named.error();
  const tasks::HandsLoad load = *spec.hands_load();
  const auto demand = bimanual::lift_demand(named->scene, load.height_m);
  if (!demand) return demand.error();
  const auto weaker_N = context.two_hands.weaker_N();
  const double strength = weaker_N ? load.level * *weaker_N / demand->force_N() : 1.0;
  return make(named->text, named->path, strength > 0.0 ? strength : 1.0, context.period_s);
}

void LiftedObject::begin(LiftedView& view) noexcept {
  state_ = pressed_.initial_state();
  wrench_ = {};
  view = {};
  view.object = state_.object;
  view.size_m = scene_.object.size_m;
  for (const Hand hand : kBothHands)
    view.of[hand].end_O = scene_.contacts[place_of(hand)].contacts.front().p_OC;
}

void LiftedObject::press(const OfHands<Vec3>& push_W, LiftedView& view) noexcept {
  bimanual::HandWrenches wrench_C;
  for (const Hand hand : kBothHands)
    wrench_C[place_of(hand)] =
        bimanual::of_whole_hand(pressed_.contacts_of(side_of(hand)), {push_W[hand], Vec3::Zero()});
  wrench_ = pressed_.grasp(wrench_C, state_);
  view.F_O_W = wrench_.both.F_O_W;
  for (const Hand hand : kBothHands) {
    LiftingHand& of = view.of[hand];
    const GraspWrench& does = wrench_.hand[place_of(hand)];
    of.squeeze_N = wrench_C[place_of(hand)][kWhole].force.z();
    of.touches = does.contact[kWhole];
    of.slips = does.slip[kWhole];
    of.utilisation = does.utilisation[kWhole];
  }
}

void LiftedObject::move(LiftedView& view) noexcept {
  pressed_.move(wrench_, state_);
  view.object = state_.object;
}

void LiftedObject::stay(const Pose& X_WO, LiftedView& view) noexcept {
  state_.object = pressed_.at_rest(X_WO);
  view.object = state_.object;
}

Scene LiftedObject::half_of(Hand hand, const Platform& platform, double height_m) const {
  constexpr double kHalf = 0.5;
  constexpr double kHeld = 1.0;  // friction of pads on fingers that are strapped in
  Scene half = scene_.object;
  half.mass_kg *= kHalf;
  half.inertia_kg_m2 *= kHalf;
  half.stiffness *= kHalf;
  half.damping *= kHalf;
  half.free = {true, true, false, false, false, false};
  half.limits.clear();
  for (const Finger finger : kFingers) {
    const Support& support = platform.supports[index_of(finger)];
    Contact contact;
    contact.finger = finger;
    contact.p_OC = support.p_PC;
    contact.R_OC = support.R_PC;
    contact.friction = kHeld;
    half.contacts.push_back(contact);
  }
  if (const auto demand = bimanual::lift_demand(scene_, height_m); demand && half.mass_kg > 0.0) {
    const double across_N = hand == Hand::left ? -demand->squeeze_N : demand->squeeze_N;
    half.gravity_m_s2.x() += across_N / half.mass_kg;
  }
  return for_hand(std::move(half), hand);
}

}  // namespace isograsp::session
