// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/task_view.hpp"

namespace isograsp::tasks {

namespace {
const ForceView kNoForce;
const ObjectView kNoObject;
const ArmView kNoArm;
const HandView kNoHand;
const TwoHandsView kNoTwoHands;
const ObjectInput kNoObjectInput;
const HandInput kNoHandInput;
}  // namespace

std::string_view name_of(Phase phase) noexcept {
  switch (phase) {
    case Phase::lead_in: return "lead-in";
    case Phase::active: return "active";
    case Phase::transport: return "transport";
    case Phase::hold: return "hold";
    case Phase::paused: return "paused";
    case Phase::done: return "done";
  }
  return "unknown";
}

const ForceView& SpecialView::force() const noexcept {
  if (const auto* view = std::get_if<ForceView>(&special)) return *view;
  const auto* view = std::get_if<ObjectView>(&special);
  return view != nullptr ? view->grip : kNoForce;
}

const ObjectView& SpecialView::object() const noexcept {
  const auto* view = std::get_if<ObjectView>(&special);
  return view != nullptr ? *view : kNoObject;
}

const ArmView& SpecialView::arm() const noexcept {
  const auto* view = std::get_if<ArmView>(&special);
  return view != nullptr ? *view : kNoArm;
}

const HandView& SpecialView::hand() const noexcept {
  const auto* view = std::get_if<HandView>(&special);
  return view != nullptr ? *view : kNoHand;
}

const TwoHandsView& SpecialView::two_hands() const noexcept {
  const auto* view = std::get_if<TwoHandsView>(&special);
  return view != nullptr ? *view : kNoTwoHands;
}

ForceView blank_force(const ForceReferences& references, ForceChannel channel) {
  ForceView view;
  view.channel = channel;
  view.resting_force_N = references.resting(channel);
  view.maximum_force_N = references.maximum(channel);
  view.noise_sd_N = references.noise(channel);
  return view;
}

ForceView with_force(ForceView blank, const TaskInput& input) noexcept {
  if (const auto* force = std::get_if<ForceInput>(&input))
    blank.actual_force_N = force_of(force->wrench_C, blank.channel);
  else if (const auto* object = std::get_if<ObjectInput>(&input))
    blank.actual_force_N = force_of(object->wrench_C, blank.channel);
  return blank;
}

const ObjectInput& object_of(const TaskInput& input) noexcept {
  const auto* object = std::get_if<ObjectInput>(&input);
  return object != nullptr ? *object : kNoObjectInput;
}

const HandInput& hand_of(const TaskInput& input) noexcept {
  const auto* hand = std::get_if<HandInput>(&input);
  return hand != nullptr ? *hand : kNoHandInput;
}

}  // namespace isograsp::tasks
