// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/flow.hpp"

#include <cstdio>

namespace isograsp {

namespace {

bool in_trial(const FlowFacts& facts) {
  return facts.stage == Stage::trial || facts.stage == Stage::paused;
}

bool is_done(Step step, const FlowFacts& facts) {
  const bool open = facts.connection == Connection::open;
  switch (step) {
    case Step::patient: return facts.patient_chosen;
    case Step::hand: return facts.hand_chosen;
    case Step::device: return open;
    case Step::zero: return open && (facts.zeroed || facts.recorded);
    case Step::rest: return open && (facts.rest_done || facts.recorded);
    case Step::maximum: return open && (facts.maximum_force_N > 0.0 || facts.recorded);
    case Step::task: return open && facts.task_done;
  }
  return false;
}

void decide_steps(const FlowFacts& facts, FlowView& view) {
  bool found = false;
  for (std::size_t i = 0; i < kStepCount; ++i) {
    if (is_done(static_cast<Step>(i), facts)) {
      view.steps[i] = StepState::done;
    } else if (!found) {
      view.steps[i] = StepState::next;
      found = true;
    }
  }
}

void decide_device(const FlowFacts& facts, FlowView& view) {
  const auto say = [&](Mood mood, std::string words) {
    view.device_mood = mood;
    view.device_words = std::move(words);
  };
  switch (facts.connection) {
    case Connection::none:
      if (!facts.connection_error.empty()) return say(Mood::fault, facts.connection_error);
      return say(Mood::off, "Not connected");
    case Connection::opening: return say(Mood::busy, "Connecting …");
    case Connection::closing: return say(Mood::busy, "Saving and disconnecting …");
    case Connection::open: break;
  }
  if (facts.stage == Stage::finished)
    return say(facts.recorded ? Mood::ready : Mood::fault,
               facts.recorded ? "The recording is over" : "The device sends no more forces");
  if (facts.anything_arrived && facts.health.state == DeviceState::faulted)
    return say(Mood::fault, std::string(describe(facts.health.fault, facts.health.finger)));
  if (facts.frozen)
    return say(Mood::fault, "No forces arrive: check the cable and power of the device");
  if (!facts.anything_arrived) return say(Mood::busy, "Waiting for the first forces …");
  if (facts.health.fault != DeviceFault::none)
    return say(Mood::attention, std::string(describe(facts.health.fault, facts.health.finger)));
  if (facts.stage == Stage::paused && facts.pause_cause == PauseCause::missing_samples)
    return say(Mood::attention, "Connected, but samples were missing");
  if (facts.stage == Stage::zeroing) return say(Mood::busy, "Measuring the empty device …");
  if (!facts.zeroed && !facts.recorded) return say(Mood::attention, "Connected, needs its zero");
  say(Mood::ready, "Ready");
}

std::string maximum_words(const FlowFacts& facts) {
  char words[96];
  std::snprintf(words, sizeof words, "Maximum %.0f N.", facts.maximum_force_N);
  return words;
}

/// The second act, with the hand in; the first one was the zero of the empty device.
std::string rest_sentence(const FlowFacts& facts) {
  if (facts.settling_s > 0)
    return "Hand strapped. It settles: " + std::to_string(facts.settling_s) +
           " s until the resting force.";
  if (facts.strapped) return "The hand has settled. It relaxes: start the resting force.";
  return (facts.zero_remark.empty() ? "Zero is set." : facts.zero_remark) +
         " Strap the hand in and say so; after a minute start the resting force.";
}

/// Sentence and mood while a session is open and the device is sound.
void decide_session_sentence(const FlowFacts& facts, FlowView& view) {
  const auto say = [&](Mood mood, std::string words) {
    view.mood = mood;
    view.sentence = std::move(words);
  };
  switch (facts.stage) {
    case Stage::zeroing: return say(Mood::busy, "Setting the zero. Nobody touches the device.");
    case Stage::trial: return say(Mood::busy, "Recording: " + facts.task_name + ".");
    case Stage::paused:
      if (facts.pause_cause == PauseCause::therapist)
        return say(Mood::attention, "Paused. Resume when the patient is ready.");
      return say(Mood::fault, std::string(describe(facts.pause_cause)));
    case Stage::finished:
      return say(Mood::ready, "The recording is over. Disconnect to end the session.");
    case Stage::idle: break;
  }
  if (!facts.zero_refusal.empty())
    return say(Mood::attention, "Zero refused: " + facts.zero_refusal);
  const auto next = view.next();
  if (next == Step::zero)
    return say(Mood::attention, "Device connected. Set the zero with the device empty.");
  if (next == Step::rest) return say(Mood::ready, rest_sentence(facts));
  if (next == Step::maximum)
    return say(Mood::ready,
               (facts.rest_words.empty() ? "Resting force is known." : facts.rest_words) +
                   " Next: the maximum grip force.");
  if (facts.recorded) return say(Mood::ready, "Recording ready. Choose a task and press Start.");
  if (next == Step::task && facts.maximum_attempts < 2)
    return say(Mood::ready, maximum_words(facts) +
                                " Repeat it after one minute, or choose a task and press Start.");
  if (next == Step::task)
    return say(Mood::ready, maximum_words(facts) + " Choose a task and press Start.");
  say(Mood::ready, "Trial stored. Repeat it, choose another task, or disconnect to end.");
}

void decide_sentence(const FlowFacts& facts, FlowView& view) {
  const auto say = [&](Mood mood, std::string words) {
    view.mood = mood;
    view.sentence = std::move(words);
  };
  if (!facts.database_error.empty()) return say(Mood::fault, facts.database_error);
  if (!facts.database_open) return say(Mood::busy, "Opening the database …");
  switch (facts.connection) {
    case Connection::opening: return say(Mood::busy, "Connecting to the device …");
    case Connection::closing: return say(Mood::busy, "Saving the session …");
    case Connection::none:
      if (!facts.connection_error.empty()) return say(Mood::fault, facts.connection_error);
      if (!facts.patient_chosen) return say(Mood::attention, "Choose a patient, or add a new one.");
      if (!facts.hand_chosen)
        return say(Mood::attention, "Which hand is in the device today? Choose right or left.");
      if (!facts.device_chosen) return say(Mood::attention, "Choose the device.");
      return say(Mood::attention, "Connect the device to begin the session.");
    case Connection::open: break;
  }
  if (view.device_mood == Mood::fault && facts.stage != Stage::finished) {
    const bool waits = in_trial(facts);
    return say(Mood::fault,
               view.device_words + (waits ? " The trial waits; nothing is lost." : ""));
  }
  decide_session_sentence(facts, view);
}

std::string start_hint(const FlowFacts& facts) {
  if (facts.connection != Connection::open) return "Connect the device first.";
  if (facts.stage == Stage::finished) return "The recording is over.";
  if (!facts.zeroed && !facts.recorded) return "Set the zero first, with the device empty.";
  if (facts.stage == Stage::zeroing) return "Wait until the zero is set.";
  if (in_trial(facts)) return "A trial is running.";
  if (!facts.task_chosen) return "Choose a task.";
  if (facts.task_kind == TaskKind::rest && facts.settling_s > 0)
    return "The strapped hand settles: " + std::to_string(facts.settling_s) + " s.";
  return facts.task_lacks;
}

}  // namespace

std::string word_for(Mood mood) {
  switch (mood) {
    case Mood::off: return "Off";
    case Mood::busy: return "Busy";
    case Mood::ready: return "Ready";
    case Mood::attention: return "To do";
    case Mood::fault: return "Fault";
  }
  return "";
}

std::optional<Step> FlowView::next() const {
  for (std::size_t i = 0; i < kStepCount; ++i)
    if (steps[i] == StepState::next) return static_cast<Step>(i);
  return std::nullopt;
}

FlowView decide(const FlowFacts& facts) {
  FlowView view;
  decide_steps(facts, view);
  decide_device(facts, view);
  decide_sentence(facts, view);

  const bool closed = facts.connection == Connection::none;
  const bool open = facts.connection == Connection::open;
  const bool quiet = open && facts.stage == Stage::idle && !facts.starting;
  const bool sound = view.device_mood != Mood::fault && facts.anything_arrived;
  view.may_change_patient = facts.database_open && closed;
  view.may_change_hand = closed;
  view.may_change_device = closed;
  view.may_connect = facts.database_open && closed && facts.patient_chosen && facts.hand_chosen &&
                     facts.device_chosen;
  view.may_cancel_connecting = facts.connection == Connection::opening;
  view.may_disconnect = open && !in_trial(facts) && facts.stage != Stage::zeroing;
  view.may_zero = quiet && sound && !facts.recorded;
  view.may_accept_changed = view.may_zero && facts.zero_only_changed;
  view.may_strap = view.may_zero && facts.zeroed && !facts.strapped;
  view.may_choose_task = !in_trial(facts) && !facts.starting;
  view.may_show_how = view.may_choose_task && facts.task_chosen && !facts.recorded &&
                      facts.connection != Connection::opening &&
                      facts.connection != Connection::closing && facts.stage != Stage::zeroing &&
                      facts.stage != Stage::finished;
  view.start_hint = start_hint(facts);
  view.may_start = quiet && sound && view.start_hint.empty();
  view.may_pause = open && facts.stage == Stage::trial;
  view.may_resume = open && facts.stage == Stage::paused && sound;
  view.may_stop = open && in_trial(facts);
  return view;
}

}  // namespace isograsp
