// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/world.hpp"

#include <algorithm>

namespace isograsp::hand_world {

using virtual_hand::AssistanceRow;
using virtual_hand::DigitContact;
using virtual_hand::DigitState;

namespace {

DigitContact as_contact(Digit digit, const TouchPoint& at) noexcept {
  DigitContact contact;
  contact.digit = digit;
  contact.link = at.link;
  contact.p_OC = at.p_O;
  const Vec3 tangent = at.normal_O.unitOrthogonal();
  contact.R_OC << tangent, at.normal_O.cross(tangent), at.normal_O;
  return contact;
}

}  // namespace

World::World(const ObjectBody& object, const WorldRules& rules) noexcept
    : rules_(rules), object_(object) {}

void World::place_hand(const virtual_hand::HandModel& model,
                       const virtual_hand::HandPose& pose) noexcept {
  hand_.emplace(model, rules_.dynamics);
  hand_->place(pose);
}

void World::place_object(const ObjectMotion& motion) noexcept {
  object_.place(motion);
  memory_.fill({});
}

void World::take_object(const ObjectBody& object) noexcept {
  object_ = RigidObject(object);
  for (auto& tie : ties_) tie.reset();
  silent_s_.fill(0.0);
  for (DigitTouch& touch : touches_) {
    touch = {};
    touch.gap_m = kMargin_m;
  }
  touched_.fill(false);
  supported_ = false;
  memory_.fill({});
}

void World::set_link_most(double most_N) noexcept {
  rules_.dynamics.link.most_N = most_N;
  if (hand_) hand_->set_link_most(most_N);
}

std::size_t World::hang(const Vec3& p_O, double stiffness_N_m, double damping_N_s_m) noexcept {
  std::size_t number = 0;
  while (led_[number]) ++number;
  led_[number].emplace(p_O, stiffness_N_m, damping_N_s_m);
  return number;
}

void World::step(double step_s, const HandTarget& target) noexcept {
  const Pose X_WO = object_.middle(step_s);
  Arrow matrix;
  ArrowVector pull;
  ArrowVector now;
  matrix.hub.block<6, 6>(kObjectPart, kObjectPart).setZero();
  now.hub.segment<3>(kObjectPart) = object_.motion().v_WO_W;
  now.hub.segment<3>(kObjectPart + 3) = object_.motion().w_WO_O;
  object_.add_to(matrix, pull, rules_.gravity_W, step_s);
  if (hand_) {
    matrix.hub.block<6, 6>(kPalmPart, kPalmPart).setZero();
    for (LeafMatrix& leaf : matrix.leaves) leaf.setZero();
    hand_->predict(step_s);
    hand_->write_velocity(now);
    hand_->add_to(matrix, pull, target, step_s);
  }
  const auto each_tie = [this](const auto& act) {
    for (auto& tie : led_)
      if (tie) act(*tie);
    for (auto& tie : ties_)
      if (tie) act(*tie);
  };
  const HandBody* const body = hand();
  each_tie([&](Tie& tie) { tie.add_to(matrix, pull, body, X_WO, now, step_s); });
  matrix_.factor(matrix);
  const auto end_of = [&](const ArrowVector& all) {
    ArrowVector velocity = matrix_.solved(all);
    velocity.hub = now.hub + step_s * velocity.hub;
    for (std::size_t d = 0; d < kDigitCount; ++d)
      velocity.leaves[d] = now.leaves[d] + step_s * velocity.leaves[d];
    return velocity;
  };
  ArrowVector end = end_of(pull);

  solver_.clear();
  report_ = {};
  if (hand_) find_hand_contacts(X_WO, now, step_s);
  if (ground_) find_ground_contacts(X_WO, now, step_s);
  press_pads(X_WO);
  if (solver_.size() > 0) {
    report_ = solver_.solve(matrix_, end, step_s);
    solver_.add_forces(pull);
    end = end_of(pull);
  }
  remember(X_WO);

  object_.advance(end.hub, step_s);
  if (hand_) hand_->advance(end, step_s);
  ArrowVector change;
  change.hub = 0.5 * (end.hub - now.hub);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    change.leaves[d] = 0.5 * (end.leaves[d] - now.leaves[d]);
  each_tie([&](Tie& tie) { tie.settle(change, step_s); });
  for (double& left_s : silent_s_) left_s = std::max(0.0, left_s - step_s);
}

void World::tie(const std::array<DigitState, kDigitCount>& states,
                const virtual_hand::TieGains& gains) noexcept {
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    if (states[d] == DigitState::attached) {
      if (!ties_[d] && touched_[d]) ties_[d].emplace(static_cast<int>(d), touches_[d].at, gains);
    } else if (ties_[d]) {
      ties_[d].reset();
      if (states[d] == DigitState::blocked) silent_s_[d] = kSilent_s;
    }
  }
}

AssistanceRow World::assistance_row(double t_s, bool placed) const noexcept {
  AssistanceRow row;
  row.t_s = t_s;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const DigitTouch& touch = touches_[d];
    const bool away =
        !touch.contact && (placed || touch.gap_m >= virtual_hand::Assistance::kReleaseGap_m);
    const double pull_N = ties_[d] && away ? ties_[d]->effort_N() : 0.0;
    row.digits[d] = {touch.contact, pull_N, touch.gap_m};
  }
  return row;
}

std::optional<DigitContact> World::contact_of(Digit digit) const noexcept {
  const DigitTouch& touch = touches_[index_of(digit)];
  if (!touch.contact) return std::nullopt;
  return as_contact(digit, touch.at);
}

std::optional<DigitContact> World::tie_of(Digit digit) const noexcept {
  const auto& tie = ties_[index_of(digit)];
  if (!tie) return std::nullopt;
  return as_contact(digit, tie->at());
}

}  // namespace isograsp::hand_world
