// SPDX-License-Identifier: GPL-3.0-or-later
// What may be pressed now, and what should be.
#include "gui/rules/flow_parts.hpp"

namespace isograsp::gui {

namespace {

/// Pressing Start in a protocol that waits makes it go on by itself, where that is wanted.
bool may_arm(const FlowFacts& facts) {
  const auto& protocol = facts.protocol;
  if (!protocol.active || protocol.goes_on || !protocol.by_itself || !has_zero(facts)) return false;
  if (hands_due(facts)) return false;
  if (protocol.act == ProtocolFacts::Act::pause) return true;
  if (protocol.act == ProtocolFacts::Act::trial && picture_due(facts)) return false;
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
      if (facts.basis_missing && view.may_connect) return NextPress::basis;
      if (view.may_try_again) return NextPress::again;
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
    case Situation::check_platforms:
      return if_possible(view.may_check_platforms && !facts.platforms_pressed,
                         NextPress::platforms);
    case Situation::promise_reach: return if_possible(view.may_promise_reach, NextPress::reach);
    case Situation::straps_due:
    case Situation::strap_in:
    case Situation::strap_again: return if_possible(view.may_strap, NextPress::strap);
    case Situation::check_picture:
      return if_possible(view.may_watch_picture && !facts.picture_watched, NextPress::picture);
    case Situation::paused:
    case Situation::paused_by_fault:
    case Situation::let_go: return if_possible(view.may_resume, NextPress::resume);
    case Situation::stop_work:
    case Situation::protocol_over: return if_possible(view.offers_end, NextPress::end);
    case Situation::device_gone: return if_possible(view.may_try_again, NextPress::again);
    case Situation::settle:
    case Situation::rest_ready:
    case Situation::pause:
    case Situation::next_after_rest:
    case Situation::next_act:
    case Situation::recording_ready:
    case Situation::first_maximum:
    case Situation::next_maximum:
    case Situation::choose_task:
    case Situation::trial_stored:
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

void decide_between_trials(const FlowFacts& facts, bool sound, FlowView& view) {
  const bool open = facts.connection == Connection::open;
  const bool quiet =
      open && facts.stage == session::Stage::idle && !facts.starting && !facts.zero_asked;
  const bool ready = quiet && sound;
  const bool zero = has_zero(facts);
  const bool live = ready && !facts.recorded;
  view.may_zero = (live || (ready && facts.is_seen())) && facts.asks_zero;
  view.may_accept_changed = view.may_zero && facts.zero_only_changed;
  view.may_check = view.may_zero && !facts.is_seen();
  const bool may_put_in = live && facts.asks_rest && zero;
  view.may_check_platforms = may_put_in && hands_due(facts);
  view.may_test_stop =
      may_put_in && hands_due(facts) && facts.platforms_checked && !facts.stop_tested;
  view.may_promise_reach =
      may_put_in && hands_due(facts) && facts.platforms_checked && facts.stop_tested;
  const bool safe = !hands_due(facts) || (facts.platforms_checked && !facts.platforms_pressed &&
                                          facts.stop_tested && facts.within_reach);
  view.may_strap = may_put_in && safe && (!facts.strapped || facts.straps_due);
  view.may_watch_picture = live && facts.is_seen();
  view.may_choose_task = !in_trial(facts) && !facts.starting && !facts.zero_asked;
  view.may_show_how = view.may_choose_task && facts.task_chosen && facts.task_not_shown.empty() &&
                      !facts.recorded && facts.connection != Connection::opening &&
                      facts.connection != Connection::closing &&
                      facts.stage != session::Stage::zeroing &&
                      facts.stage != session::Stage::finished;
  if (facts.task_chosen) view.not_shown = facts.task_not_shown;
  view.may_begin = ready && obstacle_of(facts) == Obstacle::none;
  view.may_start = view.may_begin || (ready && may_arm(facts));
  view.may_repeat =
      ready && (zero || facts.hand_entry) && !hands_due(facts) && facts.last_rested &&
      !(facts.last_in_picture && facts.picture_unsure) &&
      (!*facts.last_rested || facts.recorded || (facts.strapped && facts.settling_s == 0));
  view.may_skip = quiet && facts.protocol.active && facts.protocol.act != ProtocolFacts::Act::none;
  view.may_stand_by = quiet && facts.protocol.active && facts.protocol.goes_on;
}

}  // namespace

Obstacle obstacle_of(const FlowFacts& facts) {
  if (facts.connection != Connection::open) return Obstacle::no_device;
  if (facts.stage == session::Stage::finished) return Obstacle::recording_over;
  if (!has_zero(facts) && !may_do_without_entry(facts)) return Obstacle::no_zero;
  if (facts.stage == session::Stage::zeroing || facts.zero_asked) return Obstacle::zeroing;
  if (in_trial(facts)) return Obstacle::trial_runs;
  const auto& protocol = facts.protocol;
  if (protocol.active && protocol.act == ProtocolFacts::Act::none) return Obstacle::protocol_over;
  if (protocol.active && protocol.act == ProtocolFacts::Act::zero) return Obstacle::zero_again;
  if (hands_due(facts))
    return !facts.platforms_checked ? Obstacle::platforms_unchecked
           : !facts.stop_tested     ? Obstacle::stop_untested
           : !facts.within_reach    ? Obstacle::not_within_reach
                                    : Obstacle::not_strapped;
  const bool rest = facts.task_chosen && facts.task_rests && !facts.recorded;
  if (rest && !facts.strapped) return Obstacle::not_strapped;
  if (rest && facts.settling_s > 0) return Obstacle::settles;
  if (protocol.active && protocol.wait_s > 0) return Obstacle::rests;
  if (protocol.active && protocol.act == ProtocolFacts::Act::pause) return Obstacle::pause_ends;
  if (!facts.task_chosen) return Obstacle::no_task;
  if (picture_due(facts)) return Obstacle::picture_unsure;
  return facts.task_lacks.empty() ? Obstacle::none : Obstacle::task_lacks;
}

void decide_acts(const FlowFacts& facts, FlowView& view) {
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
  view.may_try_again = (view.situation == Situation::session_failed && closed &&
                        (view.may_connect || facts.broken_off)) ||
                       (view.situation == Situation::device_gone && view.may_disconnect);
  view.may_take_other_hand = view.may_disconnect && !facts.both_hands && !facts.recorded;
  decide_between_trials(facts, sound, view);
  view.must_stand_by = view.device_mood == Mood::fault || facts.straps_due || !has_zero(facts) ||
                       !facts.zero_refusal.empty();
  view.may_pause = open && facts.stage == session::Stage::trial;
  view.may_resume = open && facts.stage == session::Stage::paused && sound && may_go_on(facts);
  view.may_let_go = view.may_pause && facts.object_there;
  view.may_stop = open && in_trial(facts);
  view.steps_fold = open && (in_trial(facts) ||
                             (facts.last_rested && view.next().value_or(Step::work) == Step::work));
  view.offers_end = view.may_disconnect && ends_here(view.situation);
  view.closes =
      view.offers_end && facts.last_rested &&
      (view.situation == Situation::protocol_over || view.situation == Situation::stop_work);
  view.press = press_for(view.situation, facts, view);
}

}  // namespace isograsp::gui
