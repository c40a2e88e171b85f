// SPDX-License-Identifier: GPL-3.0-or-later
// The logic of a session: one sensible next step, nothing possible that must not be.
#include "gui/rules/flow.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace isograsp::gui::flow_test {
namespace {

FlowFacts fresh() {
  FlowFacts facts;
  facts.database_open = true;
  facts.task_chosen = true;
  return facts;
}

FlowFacts connected() {
  FlowFacts facts = fresh();
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  facts.connection = Connection::open;
  facts.anything_arrived = true;
  facts.health.state = DeviceState::streaming;
  return facts;
}

FlowFacts zeroed() {
  FlowFacts facts = connected();
  facts.zeroed = true;
  return facts;
}

/// The hand is in, too: a resting force can begin.
FlowFacts settled() {
  FlowFacts facts = zeroed();
  facts.strapped = true;
  return facts;
}

TEST(Flow, LeadsFromPatientToTaskInOrder) {
  FlowFacts facts = fresh();
  EXPECT_EQ(decide(facts).next(), Step::patient);
  facts.patient_chosen = true;
  EXPECT_EQ(decide(facts).next(), Step::hand);
  facts.hand_chosen = true;
  EXPECT_EQ(decide(facts).next(), Step::screening);
  facts.screened = true;
  EXPECT_EQ(decide(facts).next(), Step::device);
  facts = connected();
  EXPECT_EQ(decide(facts).next(), Step::zero);
  facts.zeroed = true;
  EXPECT_EQ(decide(facts).next(), Step::rest);
  facts.strapped = facts.rest_done = true;
  facts.task_rests = false;
  EXPECT_EQ(decide(facts).next(), Step::work);
  EXPECT_NE(decide(facts).sentence.find("maximum grip force"), std::string::npos);
  facts.maximum_force_N = 40.0;
  EXPECT_EQ(decide(facts).next(), Step::work);
  facts.task_done = true;
  EXPECT_EQ(decide(facts).next(), Step::work);
  EXPECT_EQ(decide(facts).press, facts.task_chosen ? NextPress::start : NextPress::none);
}

TEST(Flow, HasAtMostOneNextStepAndAlwaysASentence) {
  // Every combination of the facts that steps depend on.
  for (int bits = 0; bits < 256; ++bits) {
    FlowFacts facts = fresh();
    facts.patient_chosen = (bits & 1) != 0;
    facts.hand_chosen = (bits & 2) != 0;
    facts.device_chosen = (bits & 4) != 0;
    facts.connection = (bits & 8) != 0 ? Connection::open : Connection::none;
    facts.zeroed = (bits & 16) != 0;
    facts.rest_done = (bits & 32) != 0;
    facts.maximum_force_N = (bits & 64) != 0 ? 40.0 : 0.0;
    facts.anything_arrived = (bits & 128) != 0;
    const FlowView view = decide(facts);
    EXPECT_LE(std::count(view.steps.begin(), view.steps.end(), StepState::next), 1) << bits;
    EXPECT_FALSE(view.sentence.empty()) << bits;
    EXPECT_FALSE(view.device_words.empty()) << bits;
    EXPECT_FALSE(view.may_start && view.may_stop) << bits;
    EXPECT_FALSE(view.may_connect && view.may_disconnect) << bits;
  }
}

TEST(Flow, ConnectingAndNothingElseCanBeCancelledWhileItLasts) {
  for (const auto connection :
       {Connection::none, Connection::opening, Connection::open, Connection::closing}) {
    FlowFacts facts = connected();
    facts.connection = connection;
    const FlowView view = decide(facts);
    EXPECT_EQ(view.may_cancel_connecting, connection == Connection::opening);
    EXPECT_LE(view.may_connect + view.may_cancel_connecting + view.may_disconnect, 1)
        << "one button does all three";
  }
}

TEST(Flow, ConnectsOnlyWithPatientHandScreeningAndDevice) {
  FlowFacts facts = fresh();
  facts.patient_chosen = facts.device_chosen = true;
  EXPECT_FALSE(decide(facts).may_connect);
  facts.hand_chosen = true;
  EXPECT_FALSE(decide(facts).may_connect) << "the screening comes before any force";
  facts.screened = true;
  EXPECT_TRUE(decide(facts).may_connect);
  facts.patient_chosen = false;
  EXPECT_FALSE(decide(facts).may_connect);
}

TEST(Flow, StartsNoTrialBeforeTheZero) {
  EXPECT_FALSE(decide(connected()).may_start);
  EXPECT_NE(decide(connected()).start_hint.find("zero"), std::string::npos);
  EXPECT_TRUE(decide(settled()).may_start);
}

TEST(Flow, ARecordingNeedsNoZero) {
  FlowFacts facts = connected();
  facts.recorded = true;
  EXPECT_TRUE(decide(facts).may_start);
  EXPECT_FALSE(decide(facts).may_zero);
}

TEST(Flow, AScaledTaskWaitsForTheForceThatItIsScaledTo) {
  FlowFacts facts = settled();
  facts.maximum_force_N = 25.0;
  facts.task_lacks = "The target is a share of the maximum force of 'index'.";
  EXPECT_FALSE(decide(facts).may_start) << "the maximum of the grip does not stand for it";
  EXPECT_EQ(decide(facts).start_hint, facts.task_lacks);
  facts.task_lacks.clear();
  EXPECT_TRUE(decide(facts).may_start);
}

TEST(Flow, NothingElseMayBePressedDuringATrial) {
  FlowFacts facts = zeroed();
  facts.stage = session::Stage::trial;
  const FlowView view = decide(facts);
  EXPECT_TRUE(view.may_pause && view.may_stop);
  EXPECT_FALSE(view.may_start || view.may_zero || view.may_disconnect || view.may_choose_task ||
               view.may_change_patient || view.may_change_hand || view.may_change_device);
}

TEST(Flow, AFaultDuringATrialSaysThatNothingIsLost) {
  FlowFacts facts = zeroed();
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::device_fault;
  facts.health.state = DeviceState::faulted;
  facts.health.fault = DeviceFault::silence;
  const FlowView view = decide(facts);
  EXPECT_EQ(view.mood, Mood::fault);
  EXPECT_NE(view.sentence.find("cable"), std::string::npos) << view.sentence;
  EXPECT_NE(view.sentence.find("nothing is lost"), std::string::npos) << view.sentence;
  EXPECT_FALSE(view.may_resume) << "only a sound device can go on";
  EXPECT_TRUE(view.may_stop);
}

TEST(Flow, FrozenForcesAreAFaultInWords) {
  FlowFacts facts = zeroed();
  facts.frozen = true;
  const FlowView view = decide(facts);
  EXPECT_EQ(view.device_mood, Mood::fault);
  EXPECT_NE(view.sentence.find("No forces arrive"), std::string::npos) << view.sentence;
  EXPECT_FALSE(view.may_start);
}

TEST(Flow, AZeroThatDiffersMayBeAcceptedAsServicedAndNoOther) {
  FlowFacts facts = connected();
  EXPECT_FALSE(decide(facts).may_accept_changed);
  facts.zero_refusal = Known{"The index sensor differs."};
  EXPECT_FALSE(decide(facts).may_accept_changed) << "refused for another reason";
  facts.zero_only_changed = true;
  EXPECT_TRUE(decide(facts).may_accept_changed);
  facts.zeroed = true;
  EXPECT_NE(decide(facts).sentence.find("The index sensor differs"), std::string::npos)
      << "also when an older zero is in force";
  facts.stage = session::Stage::trial;
  EXPECT_FALSE(decide(facts).may_accept_changed);
}

TEST(Flow, AStrappedHandSettlesBeforeItRestsAndNothingElseWaits) {
  FlowFacts facts = zeroed();
  EXPECT_FALSE(decide(connected()).may_strap) << "zero first, with the hand out";
  EXPECT_TRUE(decide(facts).may_strap);
  facts.strapped = true;
  facts.settling_s = 42;
  EXPECT_FALSE(decide(facts).may_strap);
  EXPECT_FALSE(decide(facts).may_start);
  EXPECT_NE(decide(facts).sentence.find("42 s"), std::string::npos) << decide(facts).sentence;
  facts.task_rests = false;
  EXPECT_TRUE(decide(facts).may_start);
  facts.task_rests = true;
  facts.settling_s = 0;
  EXPECT_TRUE(decide(facts).may_start);
}

TEST(Flow, ARestingForceWaitsForTheWordThatTheHandIsIn) {
  FlowFacts facts = zeroed();
  EXPECT_FALSE(decide(facts).may_start) << "F8 would skip the minute of settling";
  EXPECT_EQ(decide(facts).press, NextPress::strap) << "one button is filled, and it is not Start";
  EXPECT_FALSE(decide(facts).start_hint.empty());
  facts.strapped = true;
  EXPECT_EQ(decide(facts).press, NextPress::start);
}

TEST(Flow, AfterTheMinuteOfSettlingTheProtocolGoesOnByItself) {
  FlowFacts facts = zeroed();
  facts.protocol.active = facts.protocol.by_itself = true;
  facts.protocol.act = ProtocolFacts::Act::trial;
  facts.strapped = true;
  facts.settling_s = 42;
  EXPECT_TRUE(decide(facts).may_start) << "pressed while it settles, Start waits for its time";
  EXPECT_FALSE(decide(facts).may_begin);
  facts.protocol.goes_on = true;
  EXPECT_FALSE(decide(facts).may_start);
  EXPECT_TRUE(decide(facts).may_stand_by);
  EXPECT_NE(decide(facts).sentence.find("then the resting force begins"), std::string::npos)
      << decide(facts).sentence;
  facts.settling_s = 0;
  EXPECT_TRUE(decide(facts).may_begin);
}

TEST(Flow, StartIsNotOfferedWhereItDoesNothing) {
  FlowFacts facts = settled();
  facts.rest_done = true;
  facts.task_rests = false;
  facts.protocol.active = true;
  facts.protocol.act = ProtocolFacts::Act::trial;
  facts.protocol.wait_s = 20;
  EXPECT_FALSE(decide(facts).may_start) << "nothing goes on by itself";
  facts.protocol.by_itself = true;
  EXPECT_TRUE(decide(facts).may_start);
}

TEST(Flow, AZeroOlderThanARestartIsNone) {
  FlowFacts facts = settled();
  facts.rest_done = true;
  facts.task_rests = false;
  ASSERT_TRUE(decide(facts).may_start);
  facts.restarted = Finger::index;
  const FlowView view = decide(facts);
  EXPECT_FALSE(view.may_start || view.may_begin || view.may_strap || view.may_repeat);
  EXPECT_EQ(view.next(), Step::zero) << "the step opens again";
  EXPECT_EQ(view.press, NextPress::zero);
  EXPECT_EQ(view.mood, Mood::attention);
  EXPECT_EQ(view.device_mood, Mood::attention);
  EXPECT_EQ(view.sentence, view.device_words) << "light and sentence say the same";
  EXPECT_NE(view.sentence.find("index"), std::string::npos) << view.sentence;
  EXPECT_TRUE(view.must_stand_by);
}

TEST(Flow, AZeroYoungerThanTheRestartIsTheAnswerToIt) {
  FlowFacts facts = settled();
  facts.health.fault = DeviceFault::restarted;  // told for some seconds
  facts.health.state = DeviceState::degraded;
  EXPECT_EQ(decide(facts).device_mood, Mood::ready) << decide(facts).device_words;
}

TEST(Flow, AHandThatWasTakenOutForAZeroGoesInAgainBeforeWorkGoesOn) {
  FlowFacts facts = zeroed();
  facts.rest_done = facts.hand_out = true;
  facts.task_rests = false;
  EXPECT_EQ(decide(facts).next(), Step::rest);
  EXPECT_EQ(decide(facts).press, NextPress::strap);
}

TEST(Flow, AnOverloadInATrialIsSaidBesideIt) {
  FlowFacts facts = settled();
  facts.stage = session::Stage::trial;
  facts.task_name = "Grip force";
  facts.health.state = DeviceState::degraded;
  facts.health.fault = DeviceFault::overload;
  const FlowView view = decide(facts);
  EXPECT_EQ(view.mood, Mood::attention);
  EXPECT_NE(view.sentence.find("overloaded"), std::string::npos) << view.sentence;
  EXPECT_NE(view.sentence.find("Grip force"), std::string::npos) << view.sentence;
}

TEST(Flow, TheEndOfTheWorkOffersReportAndDisconnecting) {
  FlowFacts facts = settled();
  EXPECT_FALSE(decide(facts).offers_end);
  facts.protocol.active = true;
  facts.protocol.act = ProtocolFacts::Act::none;
  EXPECT_TRUE(decide(facts).offers_end && decide(facts).may_disconnect);
  EXPECT_EQ(decide(facts).press, NextPress::end);
  facts.protocol.act = ProtocolFacts::Act::trial;
  facts.stop_reason = Known{"Pain 5 of 10: stop the work of this hand for today."};
  EXPECT_TRUE(decide(facts).offers_end);
}

TEST(Flow, TheStepsFoldOnceTrialsRunAndNothingOfThemIsToBeDone) {
  FlowFacts facts = settled();
  EXPECT_FALSE(decide(facts).steps_fold) << "no trial has begun";
  facts.stage = session::Stage::trial;
  EXPECT_TRUE(decide(facts).steps_fold);
  facts.stage = session::Stage::idle;
  facts.rest_done = true;
  facts.task_rests = false;
  facts.last_rested = true;
  EXPECT_EQ(decide(facts).next(), Step::work);
  EXPECT_TRUE(decide(facts).steps_fold);
  facts.restarted = Finger::thumb;
  EXPECT_EQ(decide(facts).next(), Step::zero);
  EXPECT_FALSE(decide(facts).steps_fold) << "a zero is to be set";
  facts.restarted.reset();
  facts.straps_due = true;
  EXPECT_FALSE(decide(facts).steps_fold) << "straps are to be looked at";
}

TEST(Flow, WhatCameOfASessionIsShownAtTheEndOfTheWorkOnly) {
  FlowFacts facts = settled();
  facts.protocol.active = true;
  facts.protocol.act = ProtocolFacts::Act::none;
  EXPECT_FALSE(decide(facts).closes) << "no trial: nothing came of it";
  facts.last_rested = false;
  EXPECT_TRUE(decide(facts).closes);
  facts.protocol.act = ProtocolFacts::Act::trial;
  EXPECT_FALSE(decide(facts).closes);
  facts.stop_reason = Known{"Pain 5 of 10: stop the work of this hand for today."};
  EXPECT_TRUE(decide(facts).closes);
  EXPECT_EQ(decide(facts).press, NextPress::end);
}

TEST(Flow, AFileThatAnotherProgramHasOpenIsOnlyLookedAt) {
  FlowFacts facts = fresh();
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  ASSERT_TRUE(decide(facts).may_connect);
  facts.look_only = true;
  EXPECT_FALSE(decide(facts).may_connect);
  EXPECT_TRUE(decide(facts).may_change_patient);
  EXPECT_NE(decide(facts).sentence.find("another program"), std::string::npos);
}

TEST(Flow, WhatTheRestingForceSuggestsIsSaid) {
  FlowFacts facts = zeroed();
  facts.task_rests = false;
  facts.rest_done = true;
  facts.rest_words = Known{"At rest thumb 2.1 N."};
  EXPECT_EQ(decide(facts).sentence, "At rest thumb 2.1 N. Next: the maximum grip force.");
}

TEST(Flow, ARefusedZeroSaysWhy) {
  FlowFacts facts = connected();
  facts.zero_refusal = Known{"the thumb was not quiet"};
  EXPECT_NE(decide(facts).sentence.find("the thumb was not quiet"), std::string::npos);
  EXPECT_TRUE(decide(facts).may_zero);
}

TEST(Flow, AFailedDatabaseAllowsNothing) {
  FlowFacts facts;
  facts.database_error = "clinic.db: not a database; choose another file";
  const FlowView view = decide(facts);
  EXPECT_EQ(view.mood, Mood::fault);
  EXPECT_EQ(view.sentence, facts.database_error);
  EXPECT_FALSE(view.may_connect || view.may_change_patient);
}

TEST(Flow, EveryMoodHasItsOwnWord) {
  const std::array moods{Mood::off,  Mood::busy,      Mood::ready,
                         Mood::turn, Mood::attention, Mood::fault};
  for (const Mood a : moods)
    for (const Mood b : moods) EXPECT_EQ(word_for(a) == word_for(b), a == b);
}

FlowFacts in_protocol(ProtocolFacts::Act act) {
  FlowFacts facts = settled();
  facts.rest_done = true;
  facts.task_rests = false;
  facts.protocol.active = facts.protocol.by_itself = true;
  facts.protocol.act = act;
  facts.protocol.act_words = "Grip force, sine";
  return facts;
}

TEST(Flow, AProtocolThatRestsCanBeToldToGoOnButBeginsNothingBeforeItsTime) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.protocol.wait_s = 20;
  FlowView view = decide(facts);
  EXPECT_TRUE(view.may_start);
  EXPECT_FALSE(view.may_begin);
  facts.protocol.goes_on = true;
  facts.protocol.start_in_s = 20;
  view = decide(facts);
  EXPECT_FALSE(view.may_start) << "it goes on already";
  EXPECT_TRUE(view.may_stand_by);
  EXPECT_NE(view.sentence.find("in 20 s: Grip force, sine"), std::string::npos) << view.sentence;
  facts.protocol.wait_s = facts.protocol.start_in_s = 0;
  EXPECT_TRUE(decide(facts).may_begin);
}

TEST(Flow, TheZeroOfAProtocolIsNothingThatStartCanBegin) {
  const FlowView view = decide(in_protocol(ProtocolFacts::Act::zero));
  EXPECT_FALSE(view.may_start);
  EXPECT_TRUE(view.may_zero);
  EXPECT_EQ(view.mood, Mood::turn) << "nothing is wrong";
}

TEST(Flow, AProtocolThatIsOverHasNothingLeftToDo) {
  const FlowView view = decide(in_protocol(ProtocolFacts::Act::none));
  EXPECT_FALSE(view.next().has_value());
  EXPECT_FALSE(view.may_start || view.may_skip || view.may_stand_by);
}

TEST(Flow, AReasonToStopIsSaidBeforeWhatComesNext) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.stop_reason = Known{"Pain 5 of 10: stop the work of this hand for today."};
  EXPECT_EQ(decide(facts).sentence, english(facts.stop_reason));
  EXPECT_EQ(decide(facts).mood, Mood::attention);
}

TEST(Flow, StrapsThatAreDueComeBeforeTheNextTaskAndCanBeConfirmed) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  EXPECT_FALSE(decide(facts).may_strap);
  facts.straps_due = true;
  const FlowView view = decide(facts);
  EXPECT_TRUE(view.may_strap);
  EXPECT_TRUE(view.must_stand_by);
  EXPECT_EQ(view.next(), Step::rest);
  EXPECT_NE(view.sentence.find("look at the skin"), std::string::npos);
  facts.stop_reason = Known{"30 minutes of work are done: end the session for today."};
  EXPECT_EQ(decide(facts).sentence, view.sentence) << "the skin of a hand whose work is over, too";
  facts.stage = session::Stage::trial;
  EXPECT_EQ(decide(facts).mood, Mood::busy) << "a trial that runs is not interrupted";
}

TEST(Flow, ASessionThatBreaksOffSaysWhyWhileItIsStillBeingSaved) {
  FlowFacts facts = fresh();
  facts.connection_error = "the disk is full";
  for (const auto connection : {Connection::closing, Connection::none}) {
    facts.connection = connection;
    EXPECT_EQ(decide(facts).mood, Mood::fault);
    EXPECT_EQ(decide(facts).device_mood, Mood::fault);
    EXPECT_NE(decide(facts).sentence.find("disk"), std::string::npos);
  }
}

TEST(Flow, AfterAFaultATrialGoesOnFromRestOnly) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.stage = session::Stage::paused;
  for (const auto cause :
       {session::PauseCause::missing_samples, session::PauseCause::device_fault}) {
    facts.pause_cause = cause;
    facts.at_rest = false;
    EXPECT_FALSE(decide(facts).may_resume);
    EXPECT_NE(decide(facts).sentence.find("lets go"), std::string::npos);
    facts.at_rest = true;
    EXPECT_TRUE(decide(facts).may_resume);
  }
  facts.at_rest = false;
  facts.pause_cause = session::PauseCause::therapist;
  EXPECT_TRUE(decide(facts).may_resume) << "a pause of the therapist";
}

TEST(Flow, OutOfSightIsNoFaultAndTheTrialGoesOnByItself) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::occluded;
  for (const bool at_rest : {false, true}) {
    facts.at_rest = at_rest;
    const FlowView view = decide(facts);
    EXPECT_EQ(view.situation, Situation::goes_on_by_itself);
    EXPECT_EQ(view.device_mood, Mood::ready) << "the device works";
    EXPECT_EQ(view.mood, Mood::attention);
    EXPECT_NE(view.sentence.find("goes on by itself"), std::string::npos) << view.sentence;
    EXPECT_EQ(view.press, NextPress::none);
    EXPECT_FALSE(view.may_resume) << "nobody needs to";
    EXPECT_TRUE(view.may_stop);
  }
}

TEST(Flow, AStepThatTheDeviceDoesNotAskForIsNotThere) {
  const auto state = [](const FlowView& view, Step step) {
    return view.steps[static_cast<std::size_t>(step)];
  };
  FlowFacts facts = connected();
  facts.task_rests = false;
  facts.asks_zero = facts.asks_rest = false;
  facts.rest_done = true;
  FlowView view = decide(facts);
  EXPECT_EQ(state(view, Step::zero), StepState::absent);
  EXPECT_EQ(state(view, Step::rest), StepState::absent);
  EXPECT_EQ(view.next(), Step::work) << "at once";
  EXPECT_FALSE(view.may_zero || view.may_strap);
  EXPECT_TRUE(view.may_start);
  EXPECT_EQ(view.sentence, "Choose a task.") << "no maximum is asked for";
  facts.asks_zero = true;
  view = decide(facts);
  EXPECT_EQ(view.next(), Step::zero);
  EXPECT_EQ(state(view, Step::rest), StepState::absent);
  EXPECT_TRUE(view.may_zero);
  EXPECT_FALSE(view.may_start);
  facts.zeroed = true;
  view = decide(facts);
  EXPECT_EQ(state(view, Step::zero), StepState::done);
  EXPECT_EQ(view.next(), Step::work);
  EXPECT_TRUE(view.may_start);
}

TEST(Flow, ASensorThatStartsAnewWhileTheTherapistPausesAsksForRestToo) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::therapist;
  facts.restarted = Finger::middle;
  EXPECT_FALSE(decide(facts).may_resume);
  EXPECT_NE(decide(facts).sentence.find("lets go"), std::string::npos) << decide(facts).sentence;
  facts.at_rest = true;
  EXPECT_TRUE(decide(facts).may_resume);
}

TEST(Flow, ATaskThatNoScreenShowsSaysWhy) {
  FlowFacts facts = connected();
  EXPECT_TRUE(decide(facts).may_show_how);
  EXPECT_TRUE(decide(facts).not_shown.empty());
  facts.task_not_shown = "Show it yourself."_text;
  EXPECT_FALSE(decide(facts).may_show_how);
  EXPECT_EQ(decide(facts).not_shown, facts.task_not_shown);
  facts.task_chosen = false;
  EXPECT_TRUE(decide(facts).not_shown.empty()) << "of no task there is nothing to say";
}

TEST(Flow, UntilItIsKnownWhatMeasuresTheWordsFitADeviceAndCameras) {
  FlowFacts facts = fresh();
  facts.patient_chosen = true;
  EXPECT_FALSE(decide(facts).device_known);
  for (int done = 0; done < 3; ++done) {
    facts.hand_chosen = done > 0;
    facts.screened = done > 1;
    const FlowView view = decide(facts);
    for (const std::string& said : {view.sentence, view.start_hint})
      for (const char* of_one : {"the device first", "in the device", "force", "movement"})
        EXPECT_EQ(said.find(of_one), std::string::npos) << said;
  }
  EXPECT_NE(decide(facts).sentence.find("cameras"), std::string::npos);
  facts.device_chosen = true;
  EXPECT_TRUE(decide(facts).device_known);
  EXPECT_NE(decide(facts).start_hint.find("the device"), std::string::npos);
  facts.start_posture = true;
  EXPECT_NE(decide(facts).start_hint.find("the cameras"), std::string::npos);
}

TEST(Flow, AfterAFaultNothingBeginsByItself) {
  FlowFacts facts = in_protocol(ProtocolFacts::Act::trial);
  facts.protocol.goes_on = true;
  EXPECT_FALSE(decide(facts).must_stand_by);
  facts.health.state = DeviceState::faulted;
  facts.health.fault = DeviceFault::silence;
  EXPECT_TRUE(decide(facts).must_stand_by);
  EXPECT_FALSE(decide(facts).may_begin);
}

TEST(Flow, ConnectsOnlyWhenItIsKnownWhetherAProtocolWasInterrupted) {
  FlowFacts facts = fresh();
  facts.patient_chosen = facts.hand_chosen = facts.screened = facts.device_chosen = true;
  facts.earlier_sought = true;
  EXPECT_FALSE(decide(facts).may_connect);
  facts.earlier_sought = false;
  facts.earlier_undecided = true;
  EXPECT_FALSE(decide(facts).may_connect);
  facts.earlier_undecided = false;
  EXPECT_TRUE(decide(facts).may_connect);
}

}  // namespace
}  // namespace isograsp::gui::flow_test
