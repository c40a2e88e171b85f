// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/carried_by_hands.hpp"

#include <utility>

#include "session/two_platforms/named_scene.hpp"
#include "session/two_platforms/side_of.hpp"

namespace isograsp::session {

CarriedByHands::CarriedByHands(bimanual::CarryingHands hands, const CarrySetup& setup,
                               std::string text)
    : hands_(std::move(hands)), setup_(setup), text_(std::move(text)) {}

Result<CarriedByHands> CarriedByHands::make(const std::string& scene, const std::string& file,
                                            const tasks::HandsCarry& carry, const CarrySetup& setup,
                                            double period_s) {
  auto read = bimanual::parse_hands_scene(scene, file);
  if (!read) return read.error();
  auto with = bimanual::with_technique(*std::move(read), {carry.clutch, carry.pinch});
  if (!with) return with.error();
  with->hands.left_share = setup.left_share;
  for (const Hand hand : kBothHands) {
    with->hands.hands[place_of(hand)].force_at_edge_N.setConstant(setup.of[hand].at_edge_N);
    with->grasp->force_on_N[place_of(hand)] = setup.of[hand].on_N;
  }
  auto hands = bimanual::CarryingHands::compile(*with, period_s);
  if (!hands) return hands.error();
  return CarriedByHands(*std::move(hands), setup, scene);
}

Result<CarriedByHands> CarriedByHands::read(const tasks::TaskSpec& spec,
                                            const tasks::TaskContext& context,
                                            const std::string& library) {
  const auto named = named_scene(spec, library);
  if (!named) return named.error();
  const tasks::HandsCarry carry = *spec.hands_carry();
  CarrySetup setup;
  if (const auto& affected = context.two_hands.affected)
    setup.left_share = *affected == Hand::left ? carry.affected_share : 1.0 - carry.affected_share;
  for (const Hand hand : kBothHands) {
    const tasks::HandReferences& of = context.two_hands.of[hand];
    if (of.maximum_N.value_or(0.0) > 0.0)
      setup.of[hand] = tasks::carry_forces(of, carry.edge_fraction);
    else
      setup.of[hand] = {named->scene.hands.hands[place_of(hand)].force_at_edge_N.maxCoeff(),
                        named->scene.grasp ? named->scene.grasp->force_on_N[place_of(hand)] : 0.0};
  }
  return make(named->text, named->path, carry, setup, context.period_s);
}

void CarriedByHands::begin(CarriedView& view) noexcept {
  hands_.begin_hands();
  hands_.put(hands_.scene().object.initial_X_WO);
  view = {};
  view.size_m = hands_.scene().object.size_m;
  view.half_size_m = hands_.scene().hands.half_size_m;
  show(view);
}

void CarriedByHands::show(CarriedView& view) const noexcept {
  const bimanual::HandsState& hands = hands_.hands();
  view.object = hands_.object();
  view.held = hands_.held();
  view.joint = hands_.joint();
  for (const Hand hand : kBothHands) {
    CarryingHand& of = view.of[hand];
    of.p_W = hands.p_W[place_of(hand)];
    of.bubble_W = hands.bubble_W[place_of(hand)];
    of.excess = hands.excess[place_of(hand)];
    of.squeeze_N = hands_.squeeze_N()[place_of(hand)];
  }
}

void CarriedByHands::press(const OfHands<Vec3>& push_W, bool clutch, CarriedView& view) noexcept {
  bimanual::HandsInput input;
  for (const Hand hand : kBothHands) input.push_N[place_of(hand)] = push_W[hand];
  // With bubbles the pedal does nothing, and nothing says that it does.
  view.clutch = clutch && hands_.scene().hands.explore == bimanual::Explore::clutch;
  input.clutch.fill(view.clutch);
  hands_.see(input);
  show(view);
}

void CarriedByHands::move(CarriedView& view) noexcept {
  hands_.move();
  view.object = hands_.object();
}

void CarriedByHands::stay(const Pose& X_WO, bool home, CarriedView& view) noexcept {
  if (home)
    hands_.begin_hands();
  else
    hands_.move();
  hands_.put(X_WO);
  view.object = hands_.object();
}

virtual_patient::CarryKnown CarriedByHands::known_to(Hand hand, const Platform& platform) const {
  constexpr double kFirmly = 6.0;  // as much as friction needs while it stands still
  const bimanual::HandsScene& scene = hands_.scene();
  virtual_patient::CarryKnown known;
  known.hand = hand;
  known.at_edge_N = setup_.of[hand].at_edge_N;
  known.rate_m_s = scene.hands.rate_m_s;
  known.rate_exponent = scene.hands.rate_exponent;
  known.clutch = scene.hands.explore == bimanual::Explore::clutch;
  known.pinch = scene.pads.empty();
  for (const bimanual::PadSpec& pad : scene.pads) {
    if (pad.hand != side_of(hand)) continue;
    const double weight_N = scene.object.mass_kg * scene.object.gravity_m_s2.norm();
    known.depth_m = kFirmly * 0.5 * weight_N / (pad.friction * pad.stiffness[0]);
  }
  for (const Finger finger : kFingers) {
    const Mat3& R_PC = platform.supports[index_of(finger)].R_PC;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      known.R_WC[index_of(finger)].col(axis) = push_in_view(hand, R_PC.col(axis));
  }
  return known;
}

}  // namespace isograsp::session
