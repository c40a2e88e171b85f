// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pressed_by_hands.hpp"

#include "grasp_model/grasp.hpp"

namespace isograsp::bimanual {

namespace {

constexpr std::size_t bit_of(std::size_t side, std::size_t finger) {
  return std::size_t{1} << (kFingerCount * side + finger);
}

std::vector<Contact> touching_of(const std::array<HandContacts, kSides>& hands, std::size_t mask) {
  std::vector<Contact> touching;
  for (std::size_t side = 0; side < kSides; ++side)
    for (const Contact& contact : hands[side].contacts)
      if ((mask & bit_of(side, isograsp::index_of(contact.finger))) != 0)
        touching.push_back(contact);
  return touching;
}

}  // namespace

FingerWrenches of_whole_hand(const HandContacts& hand, const Wrench& push_W) noexcept {
  const Mat3& R_WC = hand.contacts.front().R_OC;
  FingerWrenches wrench_C;
  wrench_C[0] = {R_WC.transpose() * push_W.force, R_WC.transpose() * push_W.torque};
  return wrench_C;
}

Result<PressedByHands> PressedByHands::compile(const Scene& object,
                                               const std::array<HandContacts, kSides>& hands,
                                               double hold_s) {
  std::vector<Plan> plans;
  for (const HandContacts& hand : hands) {
    Scene scene = object;
    scene.contacts = hand.contacts;
    scene.grasp_rule = GraspRule::any;  // the rule looks at both hands, below
    auto plan = Plan::compile(scene, hold_s);
    if (!plan) return plan.error();
    plans.push_back(std::move(*plan));
  }
  PressedByHands pressed(std::move(plans), hands);
  for (std::size_t mask = 0; mask < kMasks; ++mask)
    pressed.acts_[mask] = grasp_rule_holds(object, touching_of(hands, mask));
  return pressed;
}

PressedWrench PressedByHands::grasp(const HandWrenches& wrench_C,
                                    PressedState& state) const noexcept {
  PressedWrench out;
  std::size_t mask = 0;
  for (std::size_t side = 0; side < kSides; ++side) {
    state.object.contact = state.touching[side];
    out.hand[side] = plans_[side].grasp(wrench_C[side], state.object);
    state.touching[side] = state.object.contact;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      if (out.hand[side].contact[f] && !out.hand[side].invalid[f]) mask |= bit_of(side, f);
  }
  state.object.contact = {};
  for (GraspWrench& hand : out.hand) {
    if (!acts_[mask]) hand.F_O_W = hand.held = {};
    out.both.held.force += hand.held.force;
    out.both.held.torque += hand.held.torque;
    out.both.F_O_W.force += hand.F_O_W.force;
    out.both.F_O_W.torque += hand.F_O_W.torque;
  }
  return out;
}

}  // namespace isograsp::bimanual
