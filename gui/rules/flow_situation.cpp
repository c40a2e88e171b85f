// SPDX-License-Identifier: GPL-3.0-or-later
// The situation of the session, from the facts.
#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

namespace {

/// Both hands go in: before that what frees them is made sure of.
Situation before_hands(const FlowFacts& facts) {
  if (!facts.platforms_checked) return Situation::check_platforms;
  if (!facts.stop_tested) return Situation::test_stop;
  if (!facts.within_reach) return Situation::promise_reach;
  return facts.hand_out ? Situation::strap_again : Situation::strap_in;
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
      if (hands_due(facts)) return before_hands(facts);
      return facts.hand_out ? Situation::strap_again : Situation::pause;
    case ProtocolFacts::Act::trial: break;
  }
  if (hands_due(facts)) return before_hands(facts);
  if (facts.hand_out) return Situation::strap_again;
  if (!facts.task_chosen) return Situation::no_act;
  const bool rest = facts.task_rests;
  if (rest && before_rest(facts) != Situation::rest_ready) return before_rest(facts);
  if (picture_due(facts)) return Situation::check_picture;
  if (protocol.goes_on && protocol.start_in_s > 0) return Situation::next_by_itself;
  if (protocol.wait_s > 0) return Situation::next_after_rest;
  return rest ? Situation::rest_ready : Situation::next_act;
}

Situation by_hand(const FlowFacts& facts) {
  if (facts.recorded) return facts.task_done ? Situation::trial_stored : Situation::recording_ready;
  if (hands_due(facts)) return before_hands(facts);
  if (facts.hand_out) return Situation::strap_again;
  const bool rest = facts.task_chosen && facts.task_rests;
  if (!facts.rest_done && !rest) return Situation::rest_left_out;
  if (rest && (!facts.rest_done || facts.settling_s > 0)) return before_rest(facts);
  if (picture_due(facts)) return Situation::check_picture;
  if (facts.task_done) return Situation::trial_stored;
  if (!facts.asks_rest) return Situation::choose_task;  // nothing is scaled to a force
  if (!(facts.maximum_force_N > 0.0)) return Situation::first_maximum;
  return facts.maximum_attempts < 2 ? Situation::next_maximum : Situation::choose_task;
}

/// The entry test bars the hand from virtual objects, not from what comes next in the protocol.
bool does_without(const FlowFacts& facts) {
  return !facts.zero_refusal.empty() && facts.protocol.active &&
         facts.protocol.act == ProtocolFacts::Act::trial && may_do_without_entry(facts);
}

Situation between_trials(const FlowFacts& facts) {
  if (facts.starting) return Situation::starting;
  if ((!facts.recorded || facts.is_seen()) && !facts.zero_refusal.empty() && !does_without(facts))
    return Situation::zero_refused;
  if (!has_zero(facts) && !does_without(facts)) {
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
      if (session::goes_on_by_itself(facts.pause_cause)) return Situation::goes_on_by_itself;
      if (facts.pause_cause == session::PauseCause::therapist)
        return facts.is_seen() || may_go_on(facts) ? Situation::paused : Situation::let_go;
      if (facts.is_seen()) return Situation::paused_by_fault;  // nobody holds a device
      return facts.health.fault == DeviceFault::none && !facts.at_rest ? Situation::let_go
                                                                       : Situation::paused_by_fault;
    case session::Stage::idle:
    case session::Stage::finished: break;
  }
  return facts.zero_asked ? Situation::zeroing : between_trials(facts);
}

}  // namespace

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
    case Situation::choose_patient:
    case Situation::choose_hand:
    case Situation::screen:
    case Situation::ask_earlier:
    case Situation::choose_device:
    case Situation::connect:
    case Situation::paused:
    case Situation::zero_missing:
    case Situation::protocol_zero:
    case Situation::check_platforms:
    case Situation::test_stop:
    case Situation::promise_reach:
    case Situation::strap_in:
    case Situation::strap_again:
    case Situation::rest_left_out:
    case Situation::check_picture: return Mood::turn;
    case Situation::look_only:
    case Situation::confirm_hand:
    case Situation::goes_on_by_itself:
    case Situation::zero_refused:
    case Situation::zero_outdated:
    case Situation::straps_due:
    case Situation::stop_work:
    case Situation::no_act: break;
  }
  return Mood::attention;
}

}  // namespace isograsp::gui
