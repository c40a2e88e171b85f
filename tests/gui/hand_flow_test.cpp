// SPDX-License-Identifier: GPL-3.0-or-later
// The logic of a session with a tracked hand: its entry test in the place of a zero, what a barred
// hand may still do, and no word of a device that somebody holds.
#include <gtest/gtest.h>

#include "gui/rules/flow.hpp"
#include "tests/support/every.hpp"

namespace isograsp::gui::hand_flow_test {
namespace {

FlowFacts before_a_tracker() {
  FlowFacts facts;
  facts.database_open = facts.patient_chosen = facts.hand_chosen = facts.screened = true;
  facts.device_chosen = facts.hand_entry = true;
  facts.asks_rest = facts.task_rests = false;
  facts.rest_done = true;
  facts.task_chosen = facts.task_needs_entry = true;
  return facts;
}

FlowFacts connected_tracker() {
  FlowFacts facts = before_a_tracker();
  facts.connection = Connection::open;
  facts.anything_arrived = true;
  facts.health.state = DeviceState::streaming;
  facts.at_rest = true;
  return facts;
}

FlowFacts barred() {
  FlowFacts facts = connected_tracker();
  facts.zero_refusal = "This hand opens too little."_text;
  return facts;
}

TEST(HandFlow, TheEntryTestComesBeforeObjectsAndARecordingAsksForItToo) {
  for (const bool recorded : {false, true}) {
    FlowFacts facts = connected_tracker();
    facts.recorded = recorded;
    const FlowView view = decide(facts);
    EXPECT_EQ(view.next(), Step::zero) << recorded;
    EXPECT_EQ(view.press, NextPress::zero) << recorded;
    EXPECT_FALSE(view.may_start) << recorded;
    EXPECT_FALSE(view.may_check || view.may_strap) << recorded;
    facts.zeroed = true;
    EXPECT_EQ(decide(facts).next(), Step::work) << recorded;
    EXPECT_TRUE(decide(facts).may_start) << recorded;
  }
}

TEST(HandFlow, NoObjectComesBeforeThePictureIsKnownToMoveAsTheHandDoes) {
  FlowFacts facts = connected_tracker();
  facts.zeroed = facts.picture_unsure = facts.task_in_picture = true;
  const FlowView due = decide(facts);
  EXPECT_EQ(due.situation, Situation::check_picture);
  EXPECT_EQ(due.press, NextPress::picture);
  EXPECT_FALSE(due.may_start);
  EXPECT_EQ(due.sentence,
            "Before the first object: check that the picture moves as the hand does.");
  EXPECT_EQ(due.start_hint, "Check the picture first, in Live hand.");
  facts.task_in_picture = false;
  EXPECT_TRUE(decide(facts).may_start) << "opening the hand needs no picture";
  facts.task_in_picture = true;
  facts.picture_unsure = false;
  EXPECT_TRUE(decide(facts).may_start);
}

TEST(HandFlow, WithoutThatTestAHandMayOpenAndCloseButHasNoObjects) {
  FlowFacts facts = connected_tracker();
  EXPECT_FALSE(decide(facts).may_start);
  facts.task_needs_entry = false;
  EXPECT_TRUE(decide(facts).may_start);
  // Others need their zero for every task.
  facts.hand_entry = false;
  EXPECT_FALSE(decide(facts).may_start);
}

TEST(HandFlow, ABarredHandHearsWhyAndNothingBeginsByItselfButItsProtocolGoesOnWhereItMay) {
  FlowFacts facts = barred();
  EXPECT_EQ(decide(facts).situation, Situation::zero_refused);
  EXPECT_EQ(decide(facts).sentence, "This hand opens too little.");
  EXPECT_FALSE(decide(facts).may_start);
  EXPECT_TRUE(decide(facts).may_zero) << "the test can be repeated";
  EXPECT_TRUE(decide(facts).must_stand_by);
  facts.protocol.active = true;
  facts.protocol.act = ProtocolFacts::Act::zero;
  EXPECT_EQ(decide(facts).situation, Situation::zero_refused);
  EXPECT_TRUE(decide(facts).may_skip);
  facts.protocol.act = ProtocolFacts::Act::trial;
  EXPECT_EQ(decide(facts).situation, Situation::zero_refused) << "an object comes next";
  facts.task_needs_entry = false;
  EXPECT_EQ(decide(facts).situation, Situation::next_act);
  EXPECT_TRUE(decide(facts).may_start);
}

TEST(HandFlow, ALostHandWaitsAndABrokenTrackerIsResumedByTheTherapist) {
  FlowFacts facts = connected_tracker();
  facts.zeroed = true;
  facts.stage = session::Stage::paused;
  facts.pause_cause = session::PauseCause::occluded;
  EXPECT_EQ(decide(facts).situation, Situation::goes_on_by_itself);
  EXPECT_FALSE(decide(facts).may_resume);
  facts.pause_cause = session::PauseCause::device_fault;
  facts.hand_fault = HandFault::silence;
  facts.at_rest = false;
  EXPECT_FALSE(decide(facts).may_resume);
  EXPECT_NE(decide(facts).device_words.find("sends nothing"), std::string::npos)
      << decide(facts).device_words;
  facts.hand_fault = HandFault::none;
  facts.at_rest = true;
  EXPECT_EQ(decide(facts).situation, Situation::paused_by_fault);
  EXPECT_TRUE(decide(facts).may_resume);
}

TEST(HandFlow, AnObjectIsLetGoOnlyWhileATrialRunsThatHasOne) {
  FlowFacts facts = connected_tracker();
  facts.object_there = true;
  EXPECT_FALSE(decide(facts).may_let_go);
  facts.stage = session::Stage::trial;
  EXPECT_TRUE(decide(facts).may_let_go);
  facts.object_there = false;
  EXPECT_FALSE(decide(facts).may_let_go);
  facts.object_there = true;
  facts.stage = session::Stage::paused;
  EXPECT_FALSE(decide(facts).may_let_go);
}

TEST(HandFlow, NoSentenceSpeaksOfForcesOrOfADeviceThatSomebodyHolds) {
  std::vector<FlowFacts> all{before_a_tracker(), connected_tracker(), barred()};
  const auto add = [&](auto change) {
    FlowFacts facts = connected_tracker();
    change(facts);
    all.push_back(facts);
  };
  add([](FlowFacts& f) { f.anything_arrived = false; });
  add([](FlowFacts& f) { f.frozen = true; });
  add([](FlowFacts& f) { f.stage = session::Stage::zeroing; });
  add([](FlowFacts& f) { f.stage = session::Stage::finished; });
  add([](FlowFacts& f) { f.zeroed = true; });
  add([](FlowFacts& f) {
    f.zeroed = true;
    f.task_chosen = false;
  });
  add([](FlowFacts& f) { f.connection = Connection::opening; });
  add([](FlowFacts& f) {
    f.stage = session::Stage::paused;
    f.pause_cause = session::PauseCause::occluded;
  });
  for (const FlowFacts& facts : test::every(all)) {
    const FlowView view = decide(facts);
    EXPECT_FALSE(view.sentence.empty());
    for (const std::string& words : {view.sentence, view.device_words, view.start_hint})
      for (const char* foreign : {"force", "strap", "sensor", "device", "zero", "samples"})
        EXPECT_EQ(words.find(foreign), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace isograsp::gui::hand_flow_test
