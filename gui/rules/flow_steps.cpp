// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a session: which is done, which is next.
#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

namespace {

/// What the sentence speaks of; nothing: none of the steps.
std::optional<Step> step_of(Situation situation, const FlowFacts& facts) {
  switch (situation) {
    case Situation::session_failed:
      if (facts.connection != Connection::none) return std::nullopt;
      return step_of(before_session(facts), facts);
    case Situation::choose_patient: return Step::patient;
    case Situation::confirm_hand:
    case Situation::choose_hand: return Step::hand;
    case Situation::screen: return Step::screening;
    case Situation::seek_earlier:
    case Situation::ask_earlier: return Step::work;
    case Situation::choose_device:
    case Situation::connect:
    case Situation::connecting:
    case Situation::device_fault:
    case Situation::device_gone:
    case Situation::wait_for_forces: return Step::device;
    case Situation::zeroing:
    case Situation::zero_refused:
    case Situation::zero_outdated:
    case Situation::zero_missing:
    case Situation::protocol_zero:
    case Situation::check_platforms: return Step::zero;
    case Situation::straps_due:
    case Situation::test_stop:
    case Situation::promise_reach:
    case Situation::strap_in:
    case Situation::strap_again:
    case Situation::settle:
    case Situation::rest_ready:
    case Situation::rest_left_out: return Step::rest;
    case Situation::in_trial:
    case Situation::paused:
    case Situation::paused_by_fault:
    case Situation::let_go:
    case Situation::goes_on_by_itself:
    case Situation::starting: return facts.task_rests && !facts.recorded ? Step::rest : Step::work;
    case Situation::pause:
    case Situation::next_by_itself:
    case Situation::next_after_rest:
    case Situation::next_act:
    case Situation::check_picture:
    case Situation::no_act:
    case Situation::recording_ready:
    case Situation::first_maximum:
    case Situation::next_maximum:
    case Situation::choose_task:
    case Situation::trial_stored: return Step::work;
    case Situation::database_failed:
    case Situation::database_opening:
    case Situation::look_only:
    case Situation::saving:
    case Situation::recording_over:
    case Situation::stop_work:
    case Situation::protocol_over: break;
  }
  return std::nullopt;
}

bool is_done(Step step, const FlowFacts& facts, DeviceCondition condition) {
  const bool open = facts.connection == Connection::open;
  switch (step) {
    case Step::patient: return facts.patient_chosen;
    case Step::hand: return facts.hand_chosen;
    case Step::screening: return facts.screened;
    case Step::device: return open && mood_of(condition) != Mood::fault;
    case Step::zero: return open && has_zero(facts);
    case Step::rest:
      return open && (facts.recorded || (facts.rest_done && !facts.straps_due && !facts.hand_out));
    case Step::work:
      return open && (facts.protocol.active ? facts.protocol.act == ProtocolFacts::Act::none
                                            : facts.task_done);
  }
  return false;
}

bool is_asked(Step step, const FlowFacts& facts) {
  return (step != Step::zero || facts.asks_zero) && (step != Step::rest || facts.asks_rest);
}

}  // namespace

std::array<StepState, kStepCount> steps_of(const FlowFacts& facts, Situation situation,
                                           DeviceCondition condition) {
  const auto next = step_of(situation, facts);
  std::array<StepState, kStepCount> steps{};
  for (std::size_t i = 0; i < kStepCount; ++i) {
    const auto step = static_cast<Step>(i);
    steps[i] = !is_asked(step, facts)            ? StepState::absent
               : next == step                    ? StepState::next
               : is_done(step, facts, condition) ? StepState::done
                                                 : StepState::open;
  }
  return steps;
}

std::optional<Step> FlowView::next() const {
  for (std::size_t i = 0; i < kStepCount; ++i)
    if (steps[i] == StepState::next) return static_cast<Step>(i);
  return std::nullopt;
}

}  // namespace isograsp::gui
