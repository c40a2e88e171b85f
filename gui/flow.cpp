// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/flow.hpp"

#include <QCoreApplication>
#include <QString>

#include "gui/texts.hpp"

namespace isograsp {

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Flow)
};

std::string plain(const QString& words) {
  return words.toStdString();
}

bool in_trial(const FlowFacts& facts) {
  return facts.stage == Stage::trial || facts.stage == Stage::paused;
}

bool is_done(Step step, const FlowFacts& facts) {
  const bool open = facts.connection == Connection::open;
  switch (step) {
    case Step::patient: return facts.patient_chosen;
    case Step::hand: return facts.hand_chosen;
    case Step::screening: return facts.screened;
    case Step::device: return open;
    case Step::zero: return open && (facts.zeroed || facts.recorded);
    case Step::rest: return open && (facts.rest_done || facts.recorded) && !facts.straps_due;
    case Step::work:
      return open && (facts.protocol.active ? facts.protocol.act == ProtocolFacts::Act::none
                                            : facts.task_done);
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
  const auto say = [&](Mood mood, const QString& words) {
    view.device_mood = mood;
    view.device_words = plain(words);
  };
  if (!facts.connection_error.empty())
    return say(Mood::fault, QString::fromStdString(facts.connection_error));
  switch (facts.connection) {
    case Connection::none: return say(Mood::off, Words::tr("Not connected"));
    case Connection::opening: return say(Mood::busy, Words::tr("Connecting …"));
    case Connection::closing: return say(Mood::busy, Words::tr("Saving and disconnecting …"));
    case Connection::open: break;
  }
  if (facts.stage == Stage::finished)
    return say(facts.recorded ? Mood::ready : Mood::fault,
               facts.recorded ? Words::tr("The recording is over")
                              : Words::tr("The device sends no more forces"));
  if (facts.anything_arrived && facts.health.state == DeviceState::faulted)
    return say(Mood::fault, shown(describe(facts.health.fault, facts.health.finger)));
  if (facts.frozen)
    return say(Mood::fault, Words::tr("No forces arrive: check the cable and power of the device"));
  if (!facts.anything_arrived) return say(Mood::busy, Words::tr("Waiting for the first forces …"));
  if (facts.health.fault != DeviceFault::none)
    return say(Mood::attention, shown(describe(facts.health.fault, facts.health.finger)));
  if (facts.stage == Stage::paused && facts.pause_cause == PauseCause::missing_samples)
    return say(Mood::attention, Words::tr("Connected, but samples were missing"));
  if (facts.stage == Stage::zeroing)
    return say(Mood::busy, Words::tr("Measuring the empty device …"));
  if (!facts.zeroed && !facts.recorded)
    return say(Mood::attention, Words::tr("Connected, needs its zero"));
  say(Mood::ready, Words::tr("Ready"));
}

QString maximum_words(const FlowFacts& facts) {
  return Words::tr("Maximum %1 N.").arg(facts.maximum_force_N, 0, 'f', 0);
}

/// The second act, with the hand in; the first one was the zero of the empty device.
QString rest_sentence(const FlowFacts& facts) {
  if (facts.settling_s > 0)
    return Words::tr("Hand strapped. It settles: %1 s until the resting force.")
        .arg(facts.settling_s);
  if (facts.strapped)
    return Words::tr("The hand has settled. It relaxes: start the resting force.");
  return Words::tr("%1 Strap the hand in and say so; after a minute start the resting force.")
      .arg(facts.zero_remark.empty() ? Words::tr("Zero is set.") : shown(facts.zero_remark));
}

QString protocol_sentence(const FlowFacts& facts) {
  const auto& protocol = facts.protocol;
  const auto act = QString::fromStdString(protocol.act_words);
  switch (protocol.act) {
    case ProtocolFacts::Act::none:
      return Words::tr("The protocol is finished. Write the report, or disconnect to end.");
    case ProtocolFacts::Act::zero:
      return Words::tr("Take the hand out, then set the zero of the empty device once more.");
    case ProtocolFacts::Act::pause: return Words::tr("Pause: %1 s to rest.").arg(protocol.wait_s);
    case ProtocolFacts::Act::trial: break;
  }
  if (facts.task_kind == TaskKind::rest && !facts.rest_done) return rest_sentence(facts);
  if (protocol.goes_on && protocol.start_in_s > 0)
    return Words::tr("Next, in %1 s: %2.").arg(protocol.start_in_s).arg(act);
  if (protocol.wait_s > 0)
    return Words::tr("Next: %1, after a rest of %2 s.").arg(act).arg(protocol.wait_s);
  return Words::tr("Next: %1. Press Start.").arg(act);
}

/// Sentence and mood while a session is open and the device is sound.
void decide_session_sentence(const FlowFacts& facts, FlowView& view) {
  const auto say = [&](Mood mood, const QString& words) {
    view.mood = mood;
    view.sentence = plain(words);
  };
  switch (facts.stage) {
    case Stage::zeroing:
      return say(Mood::busy, Words::tr("Setting the zero. Nobody touches the device."));
    case Stage::trial:
      return say(Mood::busy, Words::tr("Recording: %1.").arg(shown(facts.task_name)));
    case Stage::paused:
      if (facts.pause_cause == PauseCause::therapist)
        return say(Mood::attention, Words::tr("Paused. Resume when the patient is ready."));
      if (facts.health.fault == DeviceFault::none && !facts.at_rest)
        return say(Mood::fault,
                   Words::tr("The device works again. The hand lets go; if Resume stays "
                             "closed, stop, set the zero and repeat the trial."));
      return say(Mood::fault, shown(describe(facts.pause_cause)));
    case Stage::finished:
      return say(Mood::ready, Words::tr("The recording is over. Disconnect to end the session."));
    case Stage::idle: break;
  }
  if (!facts.zero_refusal.empty())
    return say(Mood::attention, Words::tr("Zero refused: %1").arg(shown(facts.zero_refusal)));
  if (facts.straps_due)  // also of a hand whose work is over
    return say(Mood::attention,
               Words::tr("The straps have been on for 20 minutes: look at the skin, then confirm "
                         "that the hand is in and strapped."));
  if (!facts.stop_reason.empty()) return say(Mood::attention, shown(facts.stop_reason));
  const auto next = view.next();
  if (next == Step::zero)
    return say(Mood::attention, Words::tr("Device connected. Set the zero with the device empty."));
  if (facts.protocol.active) {
    const bool to_do = facts.protocol.act == ProtocolFacts::Act::zero;
    return say(to_do ? Mood::attention : Mood::ready, protocol_sentence(facts));
  }
  if (next == Step::rest) return say(Mood::ready, rest_sentence(facts));
  if (facts.recorded)
    return say(Mood::ready, Words::tr("Recording ready. Choose a task and press Start."));
  if (next == Step::work && facts.maximum_force_N <= 0.0)
    return say(Mood::ready, Words::tr("%1 Next: the maximum grip force.")
                                .arg(facts.rest_words.empty() ? Words::tr("Resting force is known.")
                                                              : shown(facts.rest_words)));
  if (next == Step::work && facts.maximum_attempts < 2)
    return say(Mood::ready,
               Words::tr("%1 Repeat it after one minute, or choose a task and press Start.")
                   .arg(maximum_words(facts)));
  if (next == Step::work)
    return say(Mood::ready,
               Words::tr("%1 Choose a task and press Start.").arg(maximum_words(facts)));
  say(Mood::ready,
      Words::tr("Trial stored. Repeat it, choose another task, or disconnect to end."));
}

void decide_sentence(const FlowFacts& facts, FlowView& view) {
  const auto say = [&](Mood mood, const QString& words) {
    view.mood = mood;
    view.sentence = plain(words);
  };
  if (!facts.database_error.empty())
    return say(Mood::fault, QString::fromStdString(facts.database_error));
  if (!facts.database_open) return say(Mood::busy, Words::tr("Opening the database …"));
  if (!facts.connection_error.empty())
    return say(Mood::fault, QString::fromStdString(facts.connection_error));
  switch (facts.connection) {
    case Connection::opening: return say(Mood::busy, Words::tr("Connecting to the device …"));
    case Connection::closing: return say(Mood::busy, Words::tr("Saving the session …"));
    case Connection::none:
      if (!facts.patient_chosen)
        return say(Mood::attention, Words::tr("Choose a patient, or add a new one."));
      if (facts.hand_to_confirm)
        return say(Mood::attention,
                   Words::tr("This is not the affected hand. Confirm it, or choose the other."));
      if (!facts.hand_chosen)
        return say(Mood::attention,
                   Words::tr("Which hand is in the device today? Choose right or left."));
      if (!facts.screened)
        return say(Mood::attention, Words::tr("Ask the screening questions before any force."));
      if (facts.earlier_sought)
        return say(Mood::busy, Words::tr("Looking whether this protocol was interrupted today …"));
      if (facts.earlier_undecided)
        return say(Mood::attention,
                   Words::tr("This protocol was interrupted today: go on, or begin anew?"));
      if (!facts.device_chosen) return say(Mood::attention, Words::tr("Choose the device."));
      return say(Mood::attention, Words::tr("Connect the device to begin the session."));
    case Connection::open: break;
  }
  if (view.device_mood == Mood::fault && facts.stage != Stage::finished) {
    const auto words = QString::fromStdString(view.device_words);
    return say(Mood::fault, in_trial(facts)
                                ? Words::tr("%1 The trial waits; nothing is lost.").arg(words)
                                : words);
  }
  decide_session_sentence(facts, view);
}

/// Why no trial can begin at this moment; empty: it can.
QString obstacle(const FlowFacts& facts) {
  if (facts.connection != Connection::open) return Words::tr("Connect the device first.");
  if (facts.stage == Stage::finished) return Words::tr("The recording is over.");
  if (!facts.zeroed && !facts.recorded)
    return Words::tr("Set the zero first, with the device empty.");
  if (facts.stage == Stage::zeroing) return Words::tr("Wait until the zero is set.");
  if (in_trial(facts)) return Words::tr("A trial is running.");
  if (facts.protocol.active) {
    switch (facts.protocol.act) {
      case ProtocolFacts::Act::none: return Words::tr("The protocol is finished.");
      case ProtocolFacts::Act::zero:
        return Words::tr("Set the zero of the empty device once more.");
      case ProtocolFacts::Act::pause:
      case ProtocolFacts::Act::trial: break;
    }
  }
  if (facts.task_kind == TaskKind::rest && facts.settling_s > 0)
    return Words::tr("The strapped hand settles: %1 s.").arg(facts.settling_s);
  if (facts.protocol.active && facts.protocol.wait_s > 0)
    return Words::tr("Rest: %1 s.").arg(facts.protocol.wait_s);
  if (facts.protocol.active && facts.protocol.act == ProtocolFacts::Act::pause)
    return Words::tr("The pause is over in a moment.");
  if (!facts.task_chosen) return Words::tr("Choose a task.");
  return QString::fromStdString(facts.task_lacks);
}

/// Pressing Start in a protocol that waits makes it go on by itself.
bool may_arm(const FlowFacts& facts) {
  const auto& protocol = facts.protocol;
  return protocol.active && !protocol.goes_on && (facts.zeroed || facts.recorded) &&
         (protocol.act == ProtocolFacts::Act::pause ||
          (protocol.act == ProtocolFacts::Act::trial && protocol.wait_s > 0));
}

}  // namespace

std::string word_for(Mood mood) {
  switch (mood) {
    case Mood::off: return plain(Words::tr("Off"));
    case Mood::busy: return plain(Words::tr("Busy"));
    case Mood::ready: return plain(Words::tr("Ready"));
    case Mood::attention: return plain(Words::tr("To do"));
    case Mood::fault: return plain(Words::tr("Fault"));
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
                     facts.screened && !facts.earlier_sought && !facts.earlier_undecided &&
                     facts.device_chosen;
  view.may_cancel_connecting = facts.connection == Connection::opening;
  view.may_disconnect = open && !in_trial(facts) && facts.stage != Stage::zeroing;
  view.may_zero = quiet && sound && !facts.recorded;
  view.may_accept_changed = view.may_zero && facts.zero_only_changed;
  view.may_check = view.may_zero;
  view.may_strap = view.may_zero && facts.zeroed && (!facts.strapped || facts.straps_due);
  view.may_choose_task = !in_trial(facts) && !facts.starting;
  view.may_show_how = view.may_choose_task && facts.task_chosen && !facts.recorded &&
                      facts.connection != Connection::opening &&
                      facts.connection != Connection::closing && facts.stage != Stage::zeroing &&
                      facts.stage != Stage::finished;
  view.start_hint = plain(obstacle(facts));
  view.may_begin = quiet && sound && view.start_hint.empty();
  view.may_start = view.may_begin || (quiet && sound && may_arm(facts));
  view.may_skip = quiet && facts.protocol.active && facts.protocol.act != ProtocolFacts::Act::none;
  view.may_stand_by = quiet && facts.protocol.active && facts.protocol.goes_on;
  view.must_stand_by = view.device_mood == Mood::fault || facts.straps_due;
  view.may_pause = open && facts.stage == Stage::trial;
  // After a fault: from rest only, and with a zero that has not moved.
  view.may_resume = open && facts.stage == Stage::paused && sound &&
                    (facts.pause_cause == PauseCause::therapist || facts.at_rest);
  view.may_stop = open && in_trial(facts);
  return view;
}

}  // namespace isograsp
