// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/rules/ only: what a view of the flow is put together from.
#pragma once

#include <QString>

#include "gui/rules/flow.hpp"
#include "session/platform/zeroing.hpp"

namespace isograsp::gui {

// flow_device.cpp
[[nodiscard]] bool in_trial(const FlowFacts& facts);
[[nodiscard]] session::ZeroStanding zero_of(const FlowFacts& facts);
/// It is good.
[[nodiscard]] bool has_zero(const FlowFacts& facts);
/// What is chosen is nothing with virtual objects: it is measured of a hand without its entry test.
[[nodiscard]] bool may_do_without_entry(const FlowFacts& facts);
/// What is chosen is done by a picture of which nobody knows whether it moves as it should.
[[nodiscard]] bool picture_due(const FlowFacts& facts);
/// A trial that the therapist has paused goes on as it stands. After a fault, or the restart of a
/// sensor during that pause: from rest only, and with a zero that has not moved; before cameras: as
/// soon as they send pictures again. Out of sight: by itself.
[[nodiscard]] bool may_go_on(const FlowFacts& facts);
/// Both hands are, or were, to go in, and nobody has said that they are: nothing begins.
[[nodiscard]] bool hands_due(const FlowFacts& facts);
[[nodiscard]] DeviceCondition condition_of(const FlowFacts& facts);
[[nodiscard]] Mood mood_of(DeviceCondition condition);

// flow_situation.cpp
/// As long as no session is open: what has to be chosen next.
[[nodiscard]] Situation before_session(const FlowFacts& facts);
[[nodiscard]] Situation situation_of(const FlowFacts& facts, DeviceCondition condition);
[[nodiscard]] Mood mood_of(Situation situation);

// flow_steps.cpp
[[nodiscard]] std::array<StepState, kStepCount> steps_of(const FlowFacts& facts,
                                                         Situation situation,
                                                         DeviceCondition condition);

// flow_acts.cpp
/// Why no trial can begin at this moment.
enum class Obstacle : std::uint8_t {
  none,
  no_device,
  recording_over,
  no_zero,
  zeroing,
  trial_runs,
  protocol_over,
  zero_again,
  platforms_unchecked,
  stop_untested,
  not_within_reach,
  not_strapped,
  settles,
  rests,
  pause_ends,
  no_task,
  picture_unsure,
  task_lacks
};
[[nodiscard]] Obstacle obstacle_of(const FlowFacts& facts);
/// All that `view` says may or must be done, and the one thing to press; from its situation and the
/// mood of its device.
void decide_acts(const FlowFacts& facts, FlowView& view);

// flow_fault.cpp
/// What is told of a fault, once its words are there; nothing: there is none.
[[nodiscard]] std::optional<FaultStory> fault_of(const FlowFacts& facts, const FlowView& view);

// flow_hand_words.cpp: of a tracked hand, where they differ from those of forces; empty: they do
// not
[[nodiscard]] QString hand_device_words(const FlowFacts& facts, DeviceCondition condition);
[[nodiscard]] QString hand_words(Situation situation, const FlowFacts& facts);
[[nodiscard]] QString hand_hint(const FlowFacts& facts, Obstacle obstacle);

// flow_two_hands_words.cpp: the same of two platforms
[[nodiscard]] QString both_device_words(const FlowFacts& facts, DeviceCondition condition);
[[nodiscard]] QString both_words(Situation situation, const FlowFacts& facts);
[[nodiscard]] QString both_hint(const FlowFacts& facts, Obstacle obstacle);

}  // namespace isograsp::gui
