// SPDX-License-Identifier: GPL-3.0-or-later
// A protocol as the windows follow it: order, rests, what begins by itself, when patients are
// asked.
#include "gui/rules/protocol_guide.hpp"

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::gui::protocol_guide_test {
namespace {

using Kind = session::ProtocolWalk::Act::Kind;

session::ReadyProtocol shipped(const std::string& name) {
  const std::string library = std::string(ISOGRASP_SOURCE_DIR) + "/library";
  auto protocol = session::read_protocol(library + "/protocols/" + name + ".toml", library);
  EXPECT_TRUE(protocol.ok());
  return *std::move(protocol);
}

session::TrialOutcome outcome_of(const session::ProtocolWalk::Act& act,
                                 storage::TrialStatus status = storage::TrialStatus::completed) {
  session::TrialOutcome outcome;
  outcome.trial.task_name = act.task->name;
  outcome.trial.place = act.place;
  outcome.trial.status = status;
  return outcome;
}

/// Follows the guide to its end; returns the words of its acts.
std::vector<std::string> follow(ProtocolGuide& guide) {
  std::vector<std::string> acts;
  double now_s = 0.0;
  while (const auto act = guide.act()) {
    now_s += guide.wait_s(now_s) + 1.0;
    switch (act->kind) {
      case Kind::instrument_zero:
      case Kind::start_posture:
      case Kind::hand_entry: guide.zeroed(now_s); break;
      case Kind::pause: guide.tick(now_s + act->duration_s); break;
      case Kind::trial: guide.trial_ended(outcome_of(*act), now_s); break;
    }
    acts.push_back(english(act->words()));
    EXPECT_LE(guide.acts_done(), guide.acts());
    if (acts.size() > 200) break;
  }
  return acts;
}

TEST(ProtocolGuide, LeadsThroughEveryActOfTheProtocolOnce) {
  ProtocolGuide guide;
  guide.begin(shipped("battery"), {}, 7);
  const int planned = guide.acts();
  const auto acts = follow(guide);
  EXPECT_TRUE(guide.over());
  EXPECT_EQ(guide.acts_done(), guide.acts());
  EXPECT_GE(static_cast<int>(acts.size()), planned) << "maxima that do not agree come again";
  EXPECT_EQ(acts.front(), "Instrument zero");
  EXPECT_EQ(acts.back(), "Instrument zero");
  for (const auto& row : test::every(guide.rows()))
    EXPECT_EQ(row.state, ProtocolGuide::RowState::done);
}

TEST(ProtocolGuide, HasExactlyOneCurrentRowUntilItIsOver) {
  ProtocolGuide guide;
  guide.begin(shipped("short"), {}, 7);
  while (guide.act()) {
    int current = 0;
    for (const auto& row : guide.rows()) current += row.state == ProtocolGuide::RowState::current;
    EXPECT_EQ(current, 1);
    guide.skip(0.0);
  }
}

TEST(ProtocolGuide, AsksForEffortAndPainAtPausesAndAtTheEndButNotWithoutWork) {
  ProtocolGuide guide;
  guide.begin(shipped("battery"), {}, 7);
  int asked = 0;
  double now_s = 0.0;
  while (const auto act = guide.act()) {
    now_s += guide.wait_s(now_s) + 1.0;
    EXPECT_FALSE(guide.rating_due() && act->kind != Kind::pause) << "asked at once, in the pause";
    if (guide.rating_due()) {
      ++asked;
      guide.rated();
    }
    if (act->kind == Kind::trial)
      guide.trial_ended(outcome_of(*act), now_s);
    else if (act->kind == Kind::pause)
      guide.tick(now_s + act->duration_s);
    else
      guide.zeroed(now_s);
  }
  EXPECT_TRUE(guide.rating_due());
  EXPECT_EQ(asked, 1) << "the battery has one pause";
  ProtocolGuide idle;
  idle.begin(shipped("battery"), {}, 7);
  while (idle.act()) idle.skip(0.0);
  EXPECT_FALSE(idle.rating_due());
}

TEST(ProtocolGuide, AsksAfterEachBoutOfPlacementsOfATrackedHand) {
  ProtocolGuide guide;
  guide.begin(shipped("hand_training"), {}, 7);
  int bouts = 0;
  double now_s = 0.0;
  while (const auto act = guide.act()) {
    now_s += guide.wait_s(now_s) + 1.0;
    EXPECT_FALSE(guide.rating_due());
    if (act->kind != Kind::trial) {
      guide.zeroed(now_s);
      continue;
    }
    guide.trial_ended(outcome_of(*act), now_s);
    EXPECT_TRUE(guide.rating_due()) << "after bout " << bouts;
    guide.rated();
    ++bouts;
  }
  EXPECT_EQ(bouts, 4);
}

TEST(ProtocolGuide, ATrialThatWasBrokenOffIsAskedAgainAndNothingBeginsByItself) {
  ProtocolGuide guide;
  guide.begin(shipped("short"), {}, 7);
  guide.zeroed(1.0);
  guide.go_on(true);
  const auto act = *guide.act();
  guide.trial_ended(outcome_of(act, storage::TrialStatus::aborted), 5.0);
  EXPECT_EQ(guide.act()->words(), act.words());
  EXPECT_FALSE(guide.goes_on());
}

TEST(ProtocolGuide, TrialsChosenByHandDoNotCount) {
  ProtocolGuide guide;
  guide.begin(shipped("short"), {}, 7);
  guide.zeroed(1.0);
  const auto act = *guide.act();
  session::TrialOutcome other = outcome_of(act);
  other.trial.place.reset();
  guide.trial_ended(other, 5.0);
  EXPECT_EQ(guide.act()->words(), act.words());
}

TEST(ProtocolGuide, LeavesTimeToReadANewInstructionButNotAKnownOne) {
  ProtocolGuide guide;
  guide.begin(shipped("battery"), {}, 7);
  guide.zeroed(1.0);
  guide.trial_ended(outcome_of(*guide.act()), 20.0);  // rest
  EXPECT_EQ(guide.wait_s(20.0), 0.0) << "whoever presses need not wait";
  EXPECT_DOUBLE_EQ(guide.start_in_s(20.0), tasks::kInstruction_s);
  EXPECT_EQ(guide.start_in_s(20.0 + tasks::kInstruction_s), 0.0);
}

TEST(ProtocolGuide, TheSameMaximumWaitsForItsMinute) {
  ProtocolGuide guide;
  guide.begin(shipped("battery"), {}, 7);
  guide.zeroed(1.0);
  guide.trial_ended(outcome_of(*guide.act()), 20.0);  // rest
  guide.trial_ended(outcome_of(*guide.act()), 60.0);  // familiarisation
  const auto first = guide.act()->task->name;
  double now_s = 70.0;
  std::optional<double> ended_s;
  for (int i = 0; i < 12; ++i) {
    now_s += guide.wait_s(now_s);
    if (guide.act()->task->name == first) {
      if (ended_s) {
        EXPECT_GE(now_s - *ended_s, 60.0);
        return;
      }
      ended_s = now_s + 4.0;
    }
    now_s += 4.0;
    guide.trial_ended(outcome_of(*guide.act()), now_s);
  }
  FAIL() << "it never came again";
}

}  // namespace
}  // namespace isograsp::gui::protocol_guide_test
