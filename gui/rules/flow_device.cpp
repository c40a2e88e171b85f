// SPDX-License-Identifier: GPL-3.0-or-later
// How the device stands, its zero, and whether a trial may go on with it.
#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

bool in_trial(const FlowFacts& facts) {
  return facts.stage == session::Stage::trial || facts.stage == session::Stage::paused;
}

session::ZeroStanding zero_of(const FlowFacts& facts) {
  if (!facts.asks_zero) return session::ZeroStanding::good;
  if (facts.is_seen())
    return facts.zeroed ? session::ZeroStanding::good : session::ZeroStanding::missing;
  return session::standing_of_zero(facts.recorded, facts.zeroed, facts.restarted.has_value());
}

bool has_zero(const FlowFacts& facts) {
  return zero_of(facts) == session::ZeroStanding::good;
}

bool may_do_without_entry(const FlowFacts& facts) {
  return facts.hand_entry && !facts.task_needs_entry;
}

bool picture_due(const FlowFacts& facts) {
  return facts.picture_unsure && facts.task_chosen && facts.task_in_picture;
}

bool may_go_on(const FlowFacts& facts) {
  if (session::goes_on_by_itself(facts.pause_cause)) return false;
  return facts.at_rest || (facts.pause_cause == session::PauseCause::therapist && has_zero(facts));
}

bool hands_due(const FlowFacts& facts) {
  return facts.both_hands && !facts.strapped;
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
  if (facts.camera_fault != MarkerFault::none || facts.hand_fault != HandFault::none)
    return Condition::degraded;
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
    case Condition::no_zero: return Mood::turn;
    case Condition::outdated:
    case Condition::degraded:
    case Condition::gap: return Mood::attention;
    case Condition::recording_over:
    case Condition::ready: break;
  }
  return Mood::ready;
}

}  // namespace isograsp::gui
