// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/flow.hpp"

#include "gui/rules/flow_start.hpp"
#include "session/acquisition/zeroing.hpp"

namespace isograsp::gui {

namespace {

bool in_trial(const FlowFacts& facts) {
  return facts.stage == session::Stage::trial || facts.stage == session::Stage::paused;
}

session::ZeroStanding zero_of(const FlowFacts& facts) {
  return session::standing_of_zero(facts.recorded, facts.zeroed, facts.restarted.has_value());
}

bool has_zero(const FlowFacts& facts) {
  return zero_of(facts) == session::ZeroStanding::good;
}

/// A trial that the therapist has paused goes on as it stands. After a fault, or the restart of a
/// sensor during that pause: from rest only, and with a zero that has not moved.
bool may_go_on(const FlowFacts& facts) {
  return facts.at_rest || (facts.pause_cause == session::PauseCause::therapist && has_zero(facts));
}

DeviceCondition condition_of(const FlowFacts& facts) {
  using Condition = DeviceCondition;
  if (!facts.connection_error.empty()) return Condition::failed;
  switch (facts.connection) {
    case Connection::none: return Condition::absent;
    case Connection::opening: return Condition::connecting;
    case Connection::closing: return Condition::saving;
    case Connection::open: break;
  }
  if (facts.stage == session::Stage::finished)
    return facts.recorded ? Condition::recording_over : Condition::gone;
  if (facts.anything_arrived && facts.health.state == DeviceState::faulted)
    return Condition::faulted;
  if (facts.frozen) return Condition::frozen;
  if (!facts.anything_arrived) return Condition::waiting;
  const bool zeroing = facts.stage == session::Stage::zeroing || facts.zero_asked;
  if (zero_of(facts) == session::ZeroStanding::outdated && !zeroing) return Condition::outdated;
  // A restart is told for some seconds; a zero that was set meanwhile is the answer to it.
  const bool answered = facts.health.fault == DeviceFault::restarted &&
                        (zeroing || (has_zero(facts) && !facts.recorded));
  if (facts.health.fault != DeviceFault::none && !answered) return Condition::degraded;
  if (facts.stage == session::Stage::paused &&
      facts.pause_cause == session::PauseCause::missing_samples)
    return Condition::gap;
  if (zeroing) return Condition::zeroing;
  return has_zero(facts) ? Condition::ready : Condition::no_zero;
}

Mood mood_of(DeviceCondition condition) {
  using Condition = DeviceCondition;
  switch (condition) {
    case Condition::absent: return Mood::off;
    case Condition::connecting:
    case Condition::saving:
    case Condition::waiting:
    case Condition::zeroing: return Mood::busy;
    case Condition::failed:
    case Condition::gone:
    case Condition::faulted:
    case Condition::frozen: return Mood::fault;
    case Condition::outdated:
    case Condition::degraded:
    case Condition::gap:
    case Condition::no_zero: return Mood::attention;
    case Condition::recording_over:
    case Condition::ready: break;
  }
  return Mood::ready;
}

Situation before_session(const FlowFacts& facts) {
  if (facts.look_only) return Situation::look_only;
  if (!facts.patient_chosen) return Situation::choose_patient;
  if (facts.hand_to_confirm) return Situation::confirm_hand;
  if (!facts.hand_chosen) return Situation::choose_hand;
  if (!facts.screened) return Situation::screen;
  if (facts.earlier_sought) return Situation::seek_earlier;
  if (facts.earlier_undecided) return Situation::ask_earlier;
  return facts.device_chosen ? Situation::connect : Situation::choose_device;
}

/// The resting force comes next; the hand is strapped and settles before it.
Situation before_rest(const FlowFacts& facts) {
  if (!facts.strapped) return Situation::strap_in;
  return facts.settling_s > 0 ? Situation::settle : Situation::rest_ready;
}

Situation in_protocol(const FlowFacts& facts) {
  const auto& protocol = facts.protocol;
  switch (protocol.act) {
    case ProtocolFacts::Act::none: return Situation::protocol_over;
    case ProtocolFacts::Act::zero: return Situation::protocol_zero;
    case ProtocolFacts::Act::pause:
      return facts.hand_out ? Situation::strap_again : Situation::pause;
    case ProtocolFacts::Act::trial: break;
  }
  if (facts.hand_out) return Situation::strap_again;
  if (!facts.task_chosen) return Situation::no_act;
  const bool rest = facts.task_rests;
  if (rest && before_rest(facts) != Situation::rest_ready) return before_rest(facts);
  if (protocol.goes_on && protocol.start_in_s > 0) return Situation::next_by_itself;
  if (protocol.wait_s > 0) return Situation::next_after_rest;
  return rest ? Situation::rest_ready : Situation::next_act;
}

Situation by_hand(const FlowFacts& facts) {
  if (facts.recorded) return facts.task_done ? Situation::trial_stored : Situation::recording_ready;
  if (facts.hand_out) return Situation::strap_again;
  const bool rest = facts.task_chosen && facts.task_rests;
  if (!facts.rest_done && !rest) return Situation::rest_left_out;
  if (rest && (!facts.rest_done || facts.settling_s > 0)) return before_rest(facts);
  if (facts.task_done) return Situation::trial_stored;
  if (facts.maximum_force_N <= 0.0) return Situation::first_maximum;
  return facts.maximum_attempts < 2 ? Situation::next_maximum : Situation::choose_task;
}

Situation between_trials(const FlowFacts& facts) {
  if (facts.starting) return Situation::starting;
  if (!facts.recorded && !facts.zero_refusal.empty()) return Situation::zero_refused;
  if (!has_zero(facts)) {
    if (!facts.stop_reason.empty()) return Situation::stop_work;  // nobody comes back for it
    return zero_of(facts) == session::ZeroStanding::outdated ? Situation::zero_outdated
                                                             : Situation::zero_missing;
  }
  // Also of a hand whose work is over.
  if (facts.straps_due && !facts.recorded) return Situation::straps_due;
  if (!facts.stop_reason.empty()) return Situation::stop_work;
  return facts.protocol.active ? in_protocol(facts) : by_hand(facts);
}

Situation in_session(const FlowFacts& facts, DeviceCondition condition) {
  if (condition == DeviceCondition::gone) return Situation::device_gone;
  if (condition == DeviceCondition::recording_over) return Situation::recording_over;
  if (mood_of(condition) == Mood::fault) return Situation::device_fault;
  if (condition == DeviceCondition::waiting) return Situation::wait_for_forces;
  switch (facts.stage) {
    case session::Stage::zeroing: return Situation::zeroing;
    case session::Stage::trial: return Situation::in_trial;
    case session::Stage::paused:
      if (facts.pause_cause == session::PauseCause::therapist)
        return may_go_on(facts) ? Situation::paused : Situation::let_go;
      return facts.health.fault == DeviceFault::none && !facts.at_rest ? Situation::let_go
                                                                       : Situation::paused_by_fault;
    case session::Stage::idle:
    case session::Stage::finished: break;
  }
  return facts.zero_asked ? Situation::zeroing : between_trials(facts);
}

Situation situation_of(const FlowFacts& facts, DeviceCondition condition) {
  if (!facts.database_error.empty()) return Situation::database_failed;
  if (!facts.database_open) return Situation::database_opening;
  if (!facts.connection_error.empty()) return Situation::session_failed;
  switch (facts.connection) {
    case Connection::none: return before_session(facts);
    case Connection::opening: return Situation::connecting;
    case Connection::closing: return Situation::saving;
    case Connection::open: break;
  }
  return in_session(facts, condition);
}

Mood mood_of(Situation situation) {
  switch (situation) {
    case Situation::database_failed:
    case Situation::session_failed:
    case Situation::device_fault:
    case Situation::device_gone:
    case Situation::paused_by_fault:
    case Situation::let_go: return Mood::fault;
    case Situation::database_opening:
    case Situation::connecting:
    case Situation::saving:
    case Situation::seek_earlier:
    case Situation::wait_for_forces:
    case Situation::zeroing:
    case Situation::in_trial:
    case Situation::starting:
    case Situation::settle: return Mood::busy;
    case Situation::recording_over:
    case Situation::protocol_over:
    case Situation::rest_ready:
    case Situation::pause:
    case Situation::next_by_itself:
    case Situation::next_after_rest:
    case Situation::next_act:
    case Situation::recording_ready:
    case Situation::first_maximum:
    case Situation::next_maximum:
    case Situation::choose_task:
    case Situation::trial_stored: return Mood::ready;
    case Situation::look_only:
    case Situation::choose_patient:
    case Situation::confirm_hand:
    case Situation::choose_hand:
    case Situation::screen:
    case Situation::ask_earlier:
    case Situation::choose_device:
    case Situation::connect:
    case Situation::paused:
    case Situation::zero_refused:
    case Situation::zero_outdated:
    case Situation::zero_missing:
    case Situation::straps_due:
    case Situation::stop_work:
    case Situation::protocol_zero:
    case Situation::strap_in:
    case Situation::strap_again:
    case Situation::rest_left_out:
    case Situation::no_act: break;
  }
  return Mood::attention;
}

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
    case Situation::protocol_zero: return Step::zero;
    case Situation::straps_due:
    case Situation::strap_in:
    case Situation::strap_again:
    case Situation::settle:
    case Situation::rest_ready:
    case Situation::rest_left_out: return Step::rest;
    case Situation::in_trial:
    case Situation::paused:
    case Situation::paused_by_fault:
    case Situation::let_go:
    case Situation::starting: return facts.task_rests && !facts.recorded ? Step::rest : Step::work;
    case Situation::pause:
    case Situation::next_by_itself:
    case Situation::next_after_rest:
    case Situation::next_act:
    case Situation::no_act:
    case Situation::recording_ready:
    case Situation::first_maximum:
    case Situation::next_maximum:
    case Situation::choose_task: return Step::work;
    case Situation::database_failed:
    case Situation::database_opening:
    case Situation::look_only:
    case Situation::saving:
    case Situation::recording_over:
    case Situation::stop_work:
    case Situation::protocol_over:
    case Situation::trial_stored: break;
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

void decide_steps(const FlowFacts& facts, FlowView& view) {
  const auto next = step_of(view.situation, facts);
  for (std::size_t i = 0; i < kStepCount; ++i) {
    const auto step = static_cast<Step>(i);
    view.steps[i] = next == step                        ? StepState::next
                    : is_done(step, facts, view.device) ? StepState::done
                                                        : StepState::open;
  }
}

/// Pressing Start in a protocol that waits makes it go on by itself, where that is wanted.
bool may_arm(const FlowFacts& facts) {
  const auto& protocol = facts.protocol;
  if (!protocol.active || protocol.goes_on || !protocol.by_itself || !has_zero(facts)) return false;
  if (protocol.act == ProtocolFacts::Act::pause) return true;
  const bool settles = facts.task_rests && facts.strapped && facts.settling_s > 0;
  return protocol.act == ProtocolFacts::Act::trial && facts.task_chosen &&
         (!facts.task_rests || facts.strapped) && (protocol.wait_s > 0 || settles);
}

NextPress press_for(Situation situation, const FlowFacts& facts, const FlowView& view) {
  const auto if_possible = [](bool possible, NextPress press) {
    return possible ? press : NextPress::none;
  };
  switch (situation) {
    case Situation::session_failed:
      if (facts.connection != Connection::none) return NextPress::none;
      return press_for(before_session(facts), facts, view);
    case Situation::choose_patient: return if_possible(view.may_change_patient, NextPress::patient);
    case Situation::confirm_hand: return if_possible(view.may_change_hand, NextPress::confirm_hand);
    case Situation::choose_hand: return if_possible(view.may_change_hand, NextPress::hand);
    case Situation::screen: return if_possible(view.may_change_hand, NextPress::screening);
    case Situation::ask_earlier: return if_possible(view.may_change_hand, NextPress::earlier);
    case Situation::choose_device: return if_possible(view.may_change_device, NextPress::device);
    case Situation::connect: return if_possible(view.may_connect, NextPress::connect);
    case Situation::zero_refused:
    case Situation::zero_outdated:
    case Situation::zero_missing:
    case Situation::protocol_zero: return if_possible(view.may_zero, NextPress::zero);
    case Situation::straps_due:
    case Situation::strap_in:
    case Situation::strap_again: return if_possible(view.may_strap, NextPress::strap);
    case Situation::paused:
    case Situation::paused_by_fault:
    case Situation::let_go: return if_possible(view.may_resume, NextPress::resume);
    case Situation::protocol_over: return if_possible(view.offers_end, NextPress::report);
    case Situation::settle:
    case Situation::rest_ready:
    case Situation::pause:
    case Situation::next_after_rest:
    case Situation::next_act:
    case Situation::recording_ready:
    case Situation::first_maximum:
    case Situation::next_maximum:
    case Situation::choose_task:
      return if_possible(view.may_start && !facts.protocol.goes_on, NextPress::start);
    default: return NextPress::none;
  }
}

bool ends_here(Situation situation) {
  switch (situation) {
    case Situation::stop_work:
    case Situation::protocol_over:
    case Situation::trial_stored:
    case Situation::recording_over:
    case Situation::device_gone: return true;
    default: return false;
  }
}

void decide_acts_between(const FlowFacts& facts, bool sound, FlowView& view) {
  const bool open = facts.connection == Connection::open;
  const bool quiet =
      open && facts.stage == session::Stage::idle && !facts.starting && !facts.zero_asked;
  const bool ready = quiet && sound;
  const bool zero = has_zero(facts);
  view.may_zero = ready && !facts.recorded;
  view.may_accept_changed = view.may_zero && facts.zero_only_changed;
  view.may_check = view.may_zero;
  view.may_strap = view.may_zero && zero && (!facts.strapped || facts.straps_due);
  view.may_choose_task = !in_trial(facts) && !facts.starting && !facts.zero_asked;
  view.may_show_how =
      view.may_choose_task && facts.task_chosen && !facts.recorded &&
      facts.connection != Connection::opening && facts.connection != Connection::closing &&
      facts.stage != session::Stage::zeroing && facts.stage != session::Stage::finished;
  view.may_begin = ready && obstacle_of(facts) == Obstacle::none;
  view.may_start = view.may_begin || (ready && may_arm(facts));
  view.may_repeat =
      ready && zero && facts.last_rested &&
      (!*facts.last_rested || facts.recorded || (facts.strapped && facts.settling_s == 0));
  view.may_skip = quiet && facts.protocol.active && facts.protocol.act != ProtocolFacts::Act::none;
  view.may_stand_by = quiet && facts.protocol.active && facts.protocol.goes_on;
}

}  // namespace

Obstacle obstacle_of(const FlowFacts& facts) {
  if (facts.connection != Connection::open) return Obstacle::no_device;
  if (facts.stage == session::Stage::finished) return Obstacle::recording_over;
  if (!has_zero(facts)) return Obstacle::no_zero;
  if (facts.stage == session::Stage::zeroing || facts.zero_asked) return Obstacle::zeroing;
  if (in_trial(facts)) return Obstacle::trial_runs;
  const auto& protocol = facts.protocol;
  if (protocol.active && protocol.act == ProtocolFacts::Act::none) return Obstacle::protocol_over;
  if (protocol.active && protocol.act == ProtocolFacts::Act::zero) return Obstacle::zero_again;
  const bool rest = facts.task_chosen && facts.task_rests && !facts.recorded;
  if (rest && !facts.strapped) return Obstacle::not_strapped;
  if (rest && facts.settling_s > 0) return Obstacle::settles;
  if (protocol.active && protocol.wait_s > 0) return Obstacle::rests;
  if (protocol.active && protocol.act == ProtocolFacts::Act::pause) return Obstacle::pause_ends;
  if (!facts.task_chosen) return Obstacle::no_task;
  return facts.task_lacks.empty() ? Obstacle::none : Obstacle::task_lacks;
}

std::optional<Step> FlowView::next() const {
  for (std::size_t i = 0; i < kStepCount; ++i)
    if (steps[i] == StepState::next) return static_cast<Step>(i);
  return std::nullopt;
}

FlowView judge(const FlowFacts& facts) {
  FlowView view;
  view.device = condition_of(facts);
  view.device_mood = mood_of(view.device);
  view.situation = situation_of(facts, view.device);
  view.mood = mood_of(view.situation);
  // What the small light asks for, the sentence says; no check or dots stand beside it.
  const bool content = view.mood == Mood::ready || view.mood == Mood::busy;
  view.device_speaks = (view.device == DeviceCondition::degraded && view.mood != Mood::fault) ||
                       (view.device_mood == Mood::attention && content);
  if (view.device_speaks) view.mood = Mood::attention;
  decide_steps(facts, view);

  const bool closed = facts.connection == Connection::none;
  const bool open = facts.connection == Connection::open;
  const bool sound = view.device_mood != Mood::fault && facts.anything_arrived;
  view.may_change_patient = facts.database_open && closed;
  view.may_change_hand = closed && !facts.look_only;
  view.may_change_device = closed && !facts.look_only;
  view.may_connect = facts.database_open && closed && before_session(facts) == Situation::connect;
  view.may_cancel_connecting = facts.connection == Connection::opening;
  view.may_disconnect =
      open && !in_trial(facts) && facts.stage != session::Stage::zeroing && !facts.zero_asked;
  decide_acts_between(facts, sound, view);
  view.must_stand_by = view.device_mood == Mood::fault || facts.straps_due || !has_zero(facts) ||
                       !facts.zero_refusal.empty();
  view.may_pause = open && facts.stage == session::Stage::trial;
  view.may_resume = open && facts.stage == session::Stage::paused && sound && may_go_on(facts);
  view.may_stop = open && in_trial(facts);
  view.offers_end = view.may_disconnect && ends_here(view.situation);
  view.press = press_for(view.situation, facts, view);
  return view;
}

}  // namespace isograsp::gui
