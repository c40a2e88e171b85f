// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the flow: one sentence for each situation.
#include <QCoreApplication>
#include <QString>

#include "gui/rules/flow_parts.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

struct FlowTexts {
  Q_DECLARE_TR_FUNCTIONS(Flow)
};

std::string plain(const QString& words) {
  return words.toStdString();
}

QString restart_words(const FlowFacts& facts) {
  return translated(words_of(DeviceFault::restarted, facts.restarted));
}

/// Of cameras that see an arm, where it differs from what is said of forces; empty: it does not.
QString camera_words(const FlowFacts& facts, DeviceCondition condition) {
  using Condition = DeviceCondition;
  if (!facts.start_posture) return {};
  switch (condition) {
    case Condition::gone: return FlowTexts::tr("The cameras send no more pictures");
    case Condition::frozen:
      return FlowTexts::tr("No pictures arrive: check the computer of the cameras");
    case Condition::waiting: return FlowTexts::tr("Waiting for the first picture …");
    case Condition::faulted:
    case Condition::degraded:
      if (facts.camera_fault == MarkerFault::none) return {};
      return translated(words_of(facts.camera_fault));
    case Condition::gap: return FlowTexts::tr("Connected, but pictures were missing");
    case Condition::zeroing: return FlowTexts::tr("Measuring the start posture …");
    case Condition::no_zero: return FlowTexts::tr("Connected, needs the start posture");
    default: return {};
  }
}

QString device_words(const FlowFacts& facts, DeviceCondition condition) {
  using Condition = DeviceCondition;
  if (const auto words = camera_words(facts, condition); !words.isEmpty()) return words;
  if (const auto words = hand_device_words(facts, condition); !words.isEmpty()) return words;
  if (const auto words = both_device_words(facts, condition); !words.isEmpty()) return words;
  switch (condition) {
    case Condition::absent: return FlowTexts::tr("Not connected");
    case Condition::failed: return QString::fromStdString(facts.connection_error);
    case Condition::connecting: return FlowTexts::tr("Connecting …");
    case Condition::saving: return FlowTexts::tr("Saving and disconnecting …");
    case Condition::recording_over: return FlowTexts::tr("The recording is over");
    case Condition::gone: return FlowTexts::tr("The device sends no more forces");
    case Condition::frozen:
      return FlowTexts::tr("No forces arrive: check the cable and power of the device");
    case Condition::waiting: return FlowTexts::tr("Waiting for the first forces …");
    case Condition::outdated: return restart_words(facts);
    case Condition::faulted:
    case Condition::degraded: return translated(words_of(facts.health.fault, facts.health.finger));
    case Condition::gap: return FlowTexts::tr("Connected, but samples were missing");
    case Condition::zeroing: return FlowTexts::tr("Measuring the empty device …");
    case Condition::no_zero: return FlowTexts::tr("Connected, needs its zero");
    case Condition::ready: break;
  }
  return FlowTexts::tr("Ready");
}

QString maximum_words(const FlowFacts& facts) {
  return FlowTexts::tr("Maximum %1 N.").arg(facts.maximum_force_N.value_or(0.0), 0, 'f', 0);
}

QString strap_words(const FlowFacts& facts) {
  const auto zero =
      facts.zero_remark.empty() ? FlowTexts::tr("Zero is set.") : translated(facts.zero_remark);
  if (facts.protocol.active && facts.protocol.by_itself)
    return FlowTexts::tr(
               "%1 Strap the hand in and say so; after a minute the resting force begins.")
        .arg(zero);
  return FlowTexts::tr("%1 Strap the hand in and say so; after a minute start the resting force.")
      .arg(zero);
}

QString settle_words(const FlowFacts& facts) {
  if (facts.protocol.active && facts.protocol.goes_on)
    return FlowTexts::tr("Hand strapped. It settles: %1 s, then the resting force begins.")
        .arg(facts.settling_s);
  return FlowTexts::tr("Hand strapped. It settles: %1 s until the resting force.")
      .arg(facts.settling_s);
}

QString fault_words(const FlowFacts& facts, const FlowView& view) {
  const auto words = QString::fromStdString(view.device_words);
  return facts.stage == session::Stage::trial || facts.stage == session::Stage::paused
             ? FlowTexts::tr("%1 The trial waits; nothing is lost.").arg(words)
             : words;
}

QString words_before_session(Situation situation, const FlowFacts& facts) {
  switch (situation) {
    case Situation::database_failed: return QString::fromStdString(facts.database_error);
    case Situation::database_opening: return FlowTexts::tr("Opening the database …");
    case Situation::look_only:
      return FlowTexts::tr(
          "Only to look: another program has this file open. Sessions begin there.");
    case Situation::session_failed: return QString::fromStdString(facts.connection_error);
    case Situation::connecting:
      return facts.start_posture ? FlowTexts::tr("Connecting to the cameras …")
                                 : FlowTexts::tr("Connecting to the device …");
    case Situation::saving: return FlowTexts::tr("Saving the session …");
    case Situation::choose_patient: return FlowTexts::tr("Choose a patient, or add a new one.");
    case Situation::confirm_hand:
      return FlowTexts::tr("This is not the affected hand. Confirm it, or choose the other.");
    case Situation::choose_hand:
      if (facts.start_posture) return FlowTexts::tr("Which arm works today? Choose right or left.");
      if (facts.device_chosen)
        return FlowTexts::tr("Which hand is in the device today? Choose right or left.");
      return FlowTexts::tr("Which hand works today? Choose right or left.");
    case Situation::screen:
      if (facts.follows_other_hand)
        return facts.start_posture
                   ? FlowTexts::tr(
                         "Ask the screening questions for the other arm. The cameras then "
                         "connect by themselves.")
                   : FlowTexts::tr(
                         "Ask the screening questions for the other hand. The device then "
                         "connects by itself.");
      if (facts.start_posture)
        return FlowTexts::tr("Ask the screening questions before any movement.");
      if (facts.device_chosen)
        return FlowTexts::tr("Ask the screening questions before any force.");
      return FlowTexts::tr("Ask the screening questions before any work.");
    case Situation::seek_earlier:
      return FlowTexts::tr("Looking whether this protocol was interrupted today …");
    case Situation::ask_earlier:
      return FlowTexts::tr("This protocol was interrupted today: go on, or begin anew?");
    case Situation::choose_device:
      return FlowTexts::tr("Choose the device, or the cameras that see an arm.");
    case Situation::connect:
      return facts.start_posture ? FlowTexts::tr("Connect the cameras to begin the session.")
                                 : FlowTexts::tr("Connect the device to begin the session.");
    default: return {};
  }
}

QString words_in_work(Situation situation, const FlowFacts& facts) {
  const auto act = QString::fromStdString(facts.protocol.act_words);
  switch (situation) {
    case Situation::protocol_over:
      return facts.last_rested
                 ? FlowTexts::tr(
                       "The protocol is finished. Print or write the report, then end the session.")
                 : FlowTexts::tr(
                       "The protocol is finished. Write the report, or disconnect to end.");
    case Situation::protocol_zero:
      return FlowTexts::tr("Take the hand out, then set the zero of the empty device once more.");
    case Situation::pause: return FlowTexts::tr("Pause: %1 s to rest.").arg(facts.protocol.wait_s);
    case Situation::next_by_itself:
      return FlowTexts::tr("Next, in %1 s: %2.").arg(facts.protocol.start_in_s).arg(act);
    case Situation::next_after_rest:
      return FlowTexts::tr("Next: %1, after a rest of %2 s.").arg(act).arg(facts.protocol.wait_s);
    case Situation::next_act: return FlowTexts::tr("Next: %1. Press Start.").arg(act);
    case Situation::no_act:
      return FlowTexts::tr("Next: %1, which cannot be made. Skip it.").arg(act);
    case Situation::recording_ready:
      return FlowTexts::tr("Recording ready. Choose a task and press Start.");
    case Situation::first_maximum:
      return FlowTexts::tr("%1 Next: the maximum grip force.")
          .arg(facts.rest_words.empty() ? FlowTexts::tr("Resting force is known.")
                                        : translated(facts.rest_words));
    case Situation::next_maximum:
      return FlowTexts::tr("%1 Repeat it after one minute, or choose a task and press Start.")
          .arg(maximum_words(facts));
    case Situation::choose_task:
      if (!(facts.maximum_force_N > 0.0)) return FlowTexts::tr("Choose a task.");
      return FlowTexts::tr("%1 Choose a task and press Start.").arg(maximum_words(facts));
    case Situation::trial_stored:
      return FlowTexts::tr("Trial stored. Repeat it, choose another task, or disconnect to end.");
    default: return {};
  }
}

QString words_with_hand(Situation situation, const FlowFacts& facts) {
  switch (situation) {
    case Situation::zero_refused:
      return FlowTexts::tr("Zero refused: %1").arg(translated(facts.zero_refusal));
    case Situation::zero_outdated: return restart_words(facts);
    case Situation::zero_missing:
      return FlowTexts::tr("Device connected. Set the zero with the device empty.");
    case Situation::straps_due:
      return FlowTexts::tr(
          "The straps have been on for 20 minutes: look at the skin, then confirm that the hand is "
          "in and strapped.");
    case Situation::stop_work: return translated(facts.stop_reason);
    case Situation::strap_in: return strap_words(facts);
    case Situation::strap_again:
      return FlowTexts::tr("Zero is set. Strap the hand in again and say so.");
    case Situation::settle: return settle_words(facts);
    case Situation::rest_ready:
      return FlowTexts::tr("The hand has settled. It relaxes: start the resting force.");
    case Situation::rest_left_out:
      return FlowTexts::tr("The resting force is not known: choose it first, or go on without it.");
    default: return words_in_work(situation, facts);
  }
}

/// Before cameras that see an arm, where it differs; empty: it does not.
QString words_of_arm(Situation situation, const FlowFacts& facts) {
  if (!facts.start_posture) return {};
  switch (situation) {
    case Situation::device_gone:
      return FlowTexts::tr("The cameras send no more pictures. Disconnect to end the session.");
    case Situation::wait_for_forces: return FlowTexts::tr("Waiting for the first picture …");
    case Situation::zeroing: return FlowTexts::tr("The start posture: the arm is held still.");
    case Situation::paused_by_fault:
      return FlowTexts::tr("Paused: the cameras sent no pictures. Resume when they are back.");
    case Situation::zero_refused:
      return FlowTexts::tr("Start posture refused: %1").arg(translated(facts.zero_refusal));
    case Situation::zero_missing:
    case Situation::protocol_zero:
      return FlowTexts::tr(
          "The arm in the start posture, held still: measure it when the light says so.");
    case Situation::check_picture:
      return facts.picture_watched
                 ? FlowTexts::tr("The object is moved as Live arm says, seen by the patient.")
                 : FlowTexts::tr(
                       "Before the first target: check that the picture moves as the object does.");
    default: return {};
  }
}

QString words_in_session(Situation situation, const FlowFacts& facts, const FlowView& view) {
  if (const auto words = words_of_arm(situation, facts); !words.isEmpty()) return words;
  switch (situation) {
    case Situation::device_fault: return fault_words(facts, view);
    case Situation::device_gone:
      return FlowTexts::tr("The device sends no more forces. Disconnect to end the session.");
    case Situation::recording_over:
      return FlowTexts::tr("The recording is over. Disconnect to end the session.");
    case Situation::wait_for_forces: return FlowTexts::tr("Waiting for the first forces …");
    case Situation::zeroing: return FlowTexts::tr("Setting the zero. Nobody touches the device.");
    case Situation::in_trial:
      return FlowTexts::tr("Recording: %1.").arg(translated(facts.task_name));
    case Situation::paused: return FlowTexts::tr("Paused. Resume when the patient is ready.");
    case Situation::goes_on_by_itself:
    case Situation::paused_by_fault: return translated(session::words_of(facts.pause_cause));
    case Situation::let_go:
      return FlowTexts::tr(
          "The device works again. The hand lets go; if Resume stays closed, stop, set the zero "
          "and repeat the trial.");
    case Situation::starting: return FlowTexts::tr("One moment …");
    default: return words_with_hand(situation, facts);
  }
}

QString words_for_situation(const FlowFacts& facts, const FlowView& view) {
  auto of_other = hand_words(view.situation, facts);
  if (of_other.isEmpty()) of_other = both_words(view.situation, facts);
  const auto before = of_other.isEmpty() ? words_before_session(view.situation, facts) : of_other;
  const auto words = before.isEmpty() ? words_in_session(view.situation, facts, view) : before;
  const auto device = QString::fromStdString(view.device_words);
  return view.device_speaks ? QStringLiteral("%1 %2").arg(device, words) : words;
}

/// Why no trial can begin at this moment; empty: it can.
QString hint_of(const FlowFacts& facts) {
  const Obstacle obstacle = obstacle_of(facts);
  if (const auto words = hand_hint(facts, obstacle); !words.isEmpty()) return words;
  if (const auto words = both_hint(facts, obstacle); !words.isEmpty()) return words;
  if (facts.start_posture && obstacle == Obstacle::zeroing)
    return FlowTexts::tr("Wait until the start posture is measured.");
  if (facts.start_posture && (obstacle == Obstacle::no_zero || obstacle == Obstacle::zero_again))
    return FlowTexts::tr("Measure the start posture first.");
  switch (obstacle) {
    case Obstacle::none: break;
    case Obstacle::no_device:
      if (facts.start_posture) return FlowTexts::tr("Connect the cameras first.");
      return facts.device_chosen ? FlowTexts::tr("Connect the device first.")
                                 : FlowTexts::tr("Connect a device or cameras first.");
    case Obstacle::recording_over: return FlowTexts::tr("The recording is over.");
    case Obstacle::no_zero: return FlowTexts::tr("Set the zero first, with the device empty.");
    case Obstacle::zeroing: return FlowTexts::tr("Wait until the zero is set.");
    case Obstacle::trial_runs: return FlowTexts::tr("A trial is running.");
    case Obstacle::protocol_over: return FlowTexts::tr("The protocol is finished.");
    case Obstacle::zero_again: return FlowTexts::tr("Set the zero of the empty device once more.");
    case Obstacle::platforms_unchecked:
    case Obstacle::stop_untested:
    case Obstacle::not_within_reach: break;  // of two platforms
    case Obstacle::not_strapped:
      return FlowTexts::tr("Say first that the hand is in and strapped.");
    case Obstacle::settles:
      return FlowTexts::tr("The strapped hand settles: %1 s.").arg(facts.settling_s);
    case Obstacle::rests: return FlowTexts::tr("Rest: %1 s.").arg(facts.protocol.wait_s);
    case Obstacle::pause_ends: return FlowTexts::tr("The pause is over in a moment.");
    case Obstacle::no_task: return FlowTexts::tr("Choose a task.");
    case Obstacle::picture_unsure: return FlowTexts::tr("Check the picture first, in Live arm.");
    case Obstacle::task_lacks: return QString::fromStdString(facts.task_lacks);
  }
  return {};
}

}  // namespace

std::string word_for(Mood mood) {
  switch (mood) {
    case Mood::off: return plain(FlowTexts::tr("Off"));
    case Mood::busy: return plain(FlowTexts::tr("Busy"));
    case Mood::ready: return plain(FlowTexts::tr("Ready"));
    case Mood::turn: return plain(FlowTexts::tr("To do"));
    case Mood::attention: return plain(FlowTexts::tr("Attention"));
    case Mood::fault: return plain(FlowTexts::tr("Fault"));
  }
  return "";
}

FlowView decide(const FlowFacts& facts) {
  FlowView view = judge(facts);
  view.device_words = plain(device_words(facts, view.device));
  view.sentence = plain(words_for_situation(facts, view));
  view.start_hint = plain(hint_of(facts));
  view.fault = fault_of(facts, view);
  return view;
}

}  // namespace isograsp::gui
