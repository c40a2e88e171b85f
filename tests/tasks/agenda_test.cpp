// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/agenda.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tasks/kinds/force/maximum.hpp"
#include "tasks/staircase.hpp"

namespace isograsp::tasks::agenda_test {
namespace {

ProtocolStep step_of(std::vector<std::string> tasks, int repetitions, Order order) {
  ProtocolStep step;
  step.tasks = std::move(tasks);
  step.repetitions = repetitions;
  step.order = order;
  return step;
}

ProtocolSpec protocol_of(std::vector<ProtocolStep> steps) {
  ProtocolSpec protocol;
  protocol.steps = std::move(steps);
  return protocol;
}

/// Tasks in the order in which they come; every trial takes ten seconds.
struct Played {
  std::string order;
  std::vector<double> begun_s;
};
template <class Value>
Played play(const ProtocolSpec& protocol, std::uint64_t seed, Value&& value) {
  Agenda agenda(protocol, seed);
  Played played;
  double now_s = 0.0;
  while (const auto item = agenda.next()) {
    now_s = std::max(now_s, item->not_before_s);
    played.begun_s.push_back(now_s);
    played.order += protocol.steps[item->step].tasks[item->task];
    now_s += 10.0;
    agenda.record({true, value(*item), now_s});
  }
  return played;
}
std::optional<double> no_value(const Agenda::Item&) {
  return std::nullopt;
}

TEST(Agenda, EveryOrderGivesEveryTaskItsRepetitions) {
  for (const auto& [order, expected] :
       {std::pair{Order::ordered, "aabbcc"}, std::pair{Order::interleaved, "abcabc"}})
    EXPECT_EQ(play(protocol_of({step_of({"a", "b", "c"}, 2, order)}), 1, no_value).order, expected);
  const auto shuffled = protocol_of({step_of({"a", "b"}, 20, Order::random)});
  std::string first = play(shuffled, 1, no_value).order;
  EXPECT_EQ(first, play(shuffled, 1, no_value).order) << "the seed decides";
  EXPECT_NE(first, play(shuffled, 2, no_value).order);
  EXPECT_EQ(std::count(first.begin(), first.end(), 'a'), 20);
  EXPECT_EQ(first.size(), 40u);
}

TEST(Agenda, TheSameTaskRecursAfterItsTimeAndEveryTaskAfterItsRest) {
  ProtocolStep step = step_of({"a", "b"}, 2, Order::interleaved);
  step.rest_s = 5.0;
  step.recurrence_s = 60.0;
  const Played played = play(protocol_of({step}), 1, no_value);
  EXPECT_EQ(played.begun_s, (std::vector<double>{0.0, 15.0, 70.0, 85.0}));
}

TEST(Agenda, AttemptsAreRepeatedUntilTheBestTwoAgreeAndNotBeyondTheMost) {
  ProtocolStep step = step_of({"a", "b"}, 2, Order::interleaved);
  step.agreement = Agreement{10.0, "maximum_force", 4};
  const auto protocol = protocol_of({step});
  EXPECT_EQ(play(protocol, 1, [](const auto&) { return 20.0; }).order, "abab");
  // b agrees at its third attempt, a never.
  const auto values = [](const Agenda::Item& item) {
    if (item.task == 0) return 10.0 * item.attempt * item.attempt;
    return item.attempt == 1 ? 5.0 : 9.0;
  };
  EXPECT_EQ(play(protocol, 1, values).order, "abababa");
}

TEST(Agenda, PracticeLooksAtTheLastTwoAndAssessmentAtTheBestTwo) {
  ProtocolStep step = step_of({"a"}, 3, Order::ordered);
  step.agreement = Agreement{10.0, "maximum_force", 4};
  const std::vector<double> attempts{20.0, 20.5, 9.0, 9.0};  // the best two agree at once
  const auto values = [&](const Agenda::Item& item) {
    return attempts[static_cast<std::size_t>(item.attempt - 1)];
  };
  EXPECT_EQ(play(protocol_of({step}), 1, values).order, "aaa");
  step.practice = true;
  EXPECT_EQ(play(protocol_of({step}), 1, values).order, "aaaa");
}

/// Each attempt works for 50 of its seconds.
std::vector<double> begun_in_bouts(const ProtocolSpec& protocol) {
  Agenda agenda(protocol, 1);
  std::vector<double> begun_s;
  double now_s = 0.0;
  while (const auto item = agenda.next()) {
    now_s = std::max(now_s, item->not_before_s);
    begun_s.push_back(now_s);
    now_s += 55.0;
    agenda.record({true, std::nullopt, now_s, 50.0});
  }
  return begun_s;
}

TEST(Agenda, WorkInBoutsGoesOnUntilItsTimeIsDoneAndRestsBetweenThem) {
  ProtocolStep step = step_of({"a"}, 1, Order::ordered);
  step.practice = true;
  step.rest_s = 10.0;
  step.bouts = Bouts{210.0, 100.0, 60.0};
  // 50 s and 50 s are a bout; five attempts are the first to have worked for 210 s.
  EXPECT_EQ(begun_in_bouts(protocol_of({step})),
            (std::vector<double>{0.0, 65.0, 180.0, 245.0, 360.0}));
  step.bouts = Bouts{50.0, 50.0, 60.0};
  EXPECT_EQ(begun_in_bouts(protocol_of({step})).size(), 1u);
}

TEST(Agenda, WorkInBoutsThatNeverCountsEnds) {
  ProtocolStep step = step_of({"a"}, 1, Order::ordered);
  step.bouts = Bouts{210.0, 100.0, 60.0};
  EXPECT_EQ(play(protocol_of({step}), 1, no_value).order.size(), 200u);
}

TEST(Agenda, ARefusedTaskIsNotAskedAgain) {
  ProtocolStep step = step_of({"a", "b"}, 3, Order::interleaved);
  step.agreement = Agreement{10.0, "maximum_force", 4};
  const auto protocol = protocol_of({step});
  Agenda agenda(protocol, 1);
  std::string order;
  while (const auto item = agenda.next()) {
    order += step.tasks[item->task];
    agenda.record({item->task != 0, 20.0, 0.0});
  }
  EXPECT_EQ(order, "abbb");
}

TEST(Agenda, ToldItsOutcomesAgainItStandsWhereItStood) {
  ProtocolStep step = step_of({"a", "b", "c"}, 3, Order::random);
  step.agreement = Agreement{10.0, "maximum_force", 5};
  const auto protocol = protocol_of({step, step_of({"d"}, 2, Order::ordered)});
  Agenda live(protocol, 7);
  std::vector<Agenda::Outcome> told;
  const auto outcome = [](int k) { return Agenda::Outcome{true, 10.0 + 3.0 * (k % 4), 10.0 * k}; };
  for (int k = 0; const auto item = live.next(); ++k) {
    Agenda again(protocol, 7);
    for (const auto& one : told) again.record(one);
    const auto same = again.next();
    ASSERT_TRUE(same);
    EXPECT_EQ(same->step, item->step);
    EXPECT_EQ(same->task, item->task);
    EXPECT_EQ(same->attempt, item->attempt);
    EXPECT_EQ(same->not_before_s, item->not_before_s);
    told.push_back(outcome(k));
    live.record(told.back());
  }
  EXPECT_GT(told.size(), 11u);
}

TEST(Agenda, DurationsCountTrialsRestsInstructionsAndFurtherAttempts) {
  TaskSpec task;
  MaximumSpec maximum;
  maximum.lead_in_s = 1.0;
  maximum.squeeze_s = 3.0;
  task.kind = maximum;
  ProtocolStep step = step_of({"a"}, 2, Order::ordered);
  step.rest_s = 6.0;
  step.agreement = Agreement{10.0, "maximum_force", 4};
  const Duration duration = duration_of(protocol_of({step}), {{task}});
  constexpr double kInstruction_s = 6.0;
  EXPECT_DOUBLE_EQ(duration.nominal_s, kInstruction_s + 2 * 4.0 + 6.0);
  EXPECT_DOUBLE_EQ(duration.worst_s, kInstruction_s + 4 * 4.0 + 3 * 6.0);
}

TEST(Staircase, SettlesWhereThreeOfFourTrialsSucceed) {
  // A person who succeeds surely below their level and never above it.
  for (const double skill : {0.2, 0.5, 0.9}) {
    Staircase staircase{0.5};
    int successes = 0;
    double sum = 0.0;
    constexpr int kTrials = 4000;
    for (int k = 0; k < kTrials; ++k) {
      const bool success = staircase.level <= skill;
      successes += success ? 1 : 0;
      sum += staircase.level;
      staircase = staircase.after(success);
    }
    constexpr double kCount = 0.01;  // one step of the start over all trials
    EXPECT_NEAR(static_cast<double>(successes) / kTrials, Staircase::kSuccess, kCount);
    EXPECT_NEAR(sum / kTrials, skill, Staircase::kDown);
  }
}

TEST(Staircase, StaysBetweenEasiestAndHardest) {
  EXPECT_EQ(Staircase{0.05}.after(false).level, 0.0);
  EXPECT_EQ(Staircase{0.99}.after(true).level, 1.0);
}

}  // namespace
}  // namespace isograsp::tasks::agenda_test
