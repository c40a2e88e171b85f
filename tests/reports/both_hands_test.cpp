// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of both hands says follows from the trials that count.
#include "reports/findings/both_hands.hpp"

#include <gtest/gtest.h>

#include "hand/two_hands_columns.hpp"
#include "tests/support/every.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::reports::both_hands_test {
namespace {

/// Trials of one task of both hands, the left one affected.
struct Clinic {
  explicit Clinic(const std::string& task) {
    section.spec = test::library_task(task);
    section.task = section.spec->name;
    section.hand.reset();
    sessions.resize(3);
    for (storage::SessionRecord& session : sessions) {
      session.hand.reset();
      storage::set_value(session.references, columns::affected_hand, 0.0);
    }
  }
  void add(std::size_t session, std::vector<Measure> measures, double left_N = 10.0,
           double right_N = 30.0) {
    StoredTrial trial;
    trial.session = session;
    trial.session_record = &sessions[session];
    trial.trial.status = storage::TrialStatus::completed;
    storage::set_value(trial.trial.references, columns::hand_maximum_force_N.left, left_N);
    storage::set_value(trial.trial.references, columns::hand_maximum_force_N.right, right_N);
    trial.measures = std::move(measures);
    trials.push_back(std::move(trial));
  }
  [[nodiscard]] BothHands both() const {
    std::vector<const StoredTrial*> all;
    for (const StoredTrial& trial : trials) all.push_back(&trial);
    BothHands both;
    add_both_hands(section, all, both);
    finish_both_hands(both);
    return both;
  }

  TaskSection section;
  std::vector<storage::SessionRecord> sessions;
  std::vector<StoredTrial> trials;
};

Measure measure(const char* name, const char* channel, double value) {
  Measure measure;
  measure.name = name;
  measure.channel = channel;
  measure.value = value;
  return measure;
}

TEST(BothHandsPage, ASessionIsTheMeanOfItsTrialsThatCountWithTheCapacityOfItsMaxima) {
  Clinic clinic("two_hands_sum.toml");
  const auto trial = [](double share, double lag_s) {
    return std::vector{
        measure("share_affected", "left", share), measure("force_above_rest", "left", 2.0),
        measure("force_above_rest", "right", 6.0), measure("hand_lag", "left", lag_s)};
  };
  clinic.add(0, trial(20.0, 0.1));
  clinic.add(0, trial(30.0, 0.2));
  clinic.add(0, trial(90.0, 0.9));
  clinic.trials.back().trial.practice = true;
  clinic.add(2, trial(40.0, -0.1), 20.0, 20.0);
  const BothHands both = clinic.both();
  ASSERT_EQ(both.shared.size(), 2U);
  const HandsShared& first = both.shared.front();
  EXPECT_EQ(first.session, 0U);
  EXPECT_EQ(first.affected, Hand::left);
  EXPECT_DOUBLE_EQ(first.share_percent.value(), 25.0);
  EXPECT_DOUBLE_EQ(first.capacity_percent.value(), 25.0);
  EXPECT_DOUBLE_EQ(first.lag_s.value(), 0.15);
  EXPECT_DOUBLE_EQ(first.above_rest_N.right.value(), 6.0);
  EXPECT_FALSE(first.synergy.has_value()) << "was not measured";
  EXPECT_DOUBLE_EQ(both.shared.back().capacity_percent.value(), 50.0);
  EXPECT_DOUBLE_EQ(both.shared.back().lag_s.value(), -0.1);
  EXPECT_TRUE(both.moved.empty());
}

TEST(BothHandsPage, NoShareIsShownOfAPersonWhoseAffectedSideIsNotKnown) {
  Clinic clinic("two_hands_sum.toml");
  clinic.sessions[0].references = {};
  clinic.add(0, {measure("share_affected", "left", 20.0), measure("hand_lag", "left", 0.1)});
  const HandsShared row = clinic.both().shared.at(0);
  EXPECT_FALSE(row.affected || row.share_percent || row.capacity_percent || row.lag_s);
}

TEST(BothHandsPage, CarriesAreCountedOfAllTrialsWithTheirTechnique) {
  Clinic clinic("two_hands_carry_clutch_pinch.toml");
  for (const double placed : {3.0, 1.0})
    clinic.add(1,
               {measure("targets_reached", "targets", placed), measure("drops", "contact", 2.0)});
  const BothHands both = clinic.both();
  ASSERT_EQ(both.moved.size(), 1U);
  const HandsMoved& row = both.moved.front();
  EXPECT_EQ(row.done, 4);
  EXPECT_EQ(row.asked, 2 * clinic.section.spec->repetitions());
  EXPECT_EQ(row.drops, 4);
  ASSERT_TRUE(row.carry.has_value());
  EXPECT_TRUE(row.carry->clutch && row.carry->pinch);
  EXPECT_TRUE(both.shared.empty());
}

TEST(BothHandsPage, OfSeveralTasksThatAskForASumTheNewestStaysAndTheOthersAreNamed) {
  Clinic first("two_hands_sum.toml");
  first.add(0, {measure("share_affected", "left", 20.0)});
  Clinic second("two_hands_sum.toml");
  second.section.task = "Another sum";
  second.add(1, {measure("share_affected", "left", 30.0)});
  BothHands both;
  for (const Clinic* clinic : {&first, &second})
    add_both_hands(clinic->section, {&clinic->trials.front()}, both);
  finish_both_hands(both);
  ASSERT_EQ(both.shared.size(), 1U);
  EXPECT_EQ(both.shared.front().task, "Another sum");
  EXPECT_EQ(both.other_tasks, std::vector{first.section.task});
}

TEST(BothHandsPage, TasksInWhichEachHandHasItsOwnTargetTellNothingOfSharing) {
  for (const char* task : test::every(
           std::vector{"two_hands_each.toml", "two_hands_turns.toml", "two_hands_maximum.toml"})) {
    Clinic clinic(task);
    clinic.add(0, {measure("share_affected", "left", 50.0)});
    EXPECT_TRUE(clinic.both().shared.empty()) << task;
  }
}

}  // namespace
}  // namespace isograsp::reports::both_hands_test
