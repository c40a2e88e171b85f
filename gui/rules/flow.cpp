// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/flow.hpp"

#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

FlowView judge(const FlowFacts& facts) {
  FlowView view;
  view.device = condition_of(facts);
  view.device_mood = mood_of(view.device);
  view.situation = situation_of(facts, view.device);
  view.mood = mood_of(view.situation);
  // The sentence says what the small light shows; it has no check mark or dots.
  const bool content =
      view.mood == Mood::ready || view.mood == Mood::busy || view.mood == Mood::turn;
  view.device_speaks = (view.device == DeviceCondition::degraded && view.mood != Mood::fault) ||
                       (view.device_mood == Mood::attention && content);
  if (view.device_speaks) view.mood = Mood::attention;
  view.device_known = facts.device_chosen || facts.connection != Connection::none;
  view.start_posture = facts.start_posture;
  view.hand_entry = facts.hand_entry;
  view.both_hands = facts.both_hands;
  view.steps = steps_of(facts, view.situation, view.device);
  decide_acts(facts, view);
  return view;
}

}  // namespace isograsp::gui
