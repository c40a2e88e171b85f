// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of an arm that is made familiar with its tasks: what counts, and when it is enough.
#include "gui/rules/practice_clock.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::gui::practice_clock_test {
namespace {

constexpr double kRounding_s = 1e-9;  // sums of some ten times

session::ArmSnapshot frame(int trial, double task_s, int target = -1, bool matched = false) {
  session::ArmSnapshot now;
  now.stage = session::Stage::trial;
  now.trial_number = trial;
  now.task.task_time_s = task_s;
  now.task.target_index = target;
  tasks::ArmView task;
  task.matched = matched;
  now.special.special = task;
  return now;
}
/// A movement to `target` of the trial, from its cue to the match.
void move(PracticeClock& clock, int trial, int target, double cue_s, double takes_s) {
  clock.add(frame(trial, cue_s, target), true);
  clock.add(frame(trial, cue_s + takes_s, target, true), true);
  clock.add(frame(trial, cue_s + takes_s + 1.0, target, true), true);  // it stays in view
}

TEST(PracticeClock, AddsUpTrialsOfPracticeAndNothingElse) {
  PracticeClock clock;
  EXPECT_FALSE(clock.begun());
  clock.add(frame(1, 50.0), false);
  EXPECT_FALSE(clock.begun()) << "a trial that counts is no practice";
  clock.add(frame(2, 100.0), true);
  clock.add(frame(2, 100.0), true);  // the clock of the task stands still in a pause
  clock.add(frame(3, 20.0), true);
  session::ArmSnapshot idle = frame(3, 500.0);
  idle.stage = session::Stage::idle;
  clock.add(idle, true);
  EXPECT_WITHIN(clock.total_s(), 120.0, kRounding_s);
}

TEST(PracticeClock, BoutsAreThreeMinutes) {
  PracticeClock clock;
  clock.add(frame(1, PracticeClock::kBout_s - 1.0), true);
  EXPECT_EQ(clock.bout(), 1);
  clock.add(frame(1, PracticeClock::kBout_s + 5.0), true);
  EXPECT_EQ(clock.bout(), 2);
  EXPECT_WITHIN(clock.bout_s(), 5.0, kRounding_s);
}

TEST(PracticeClock, TwoMovementsThatTakeNearlyTheSameTimeAreEnoughTwoOthersAreNot) {
  PracticeClock clock;
  move(clock, 1, 0, 0.0, 4.0);
  EXPECT_FALSE(clock.difference().has_value());
  EXPECT_FALSE(clock.enough_later());
  move(clock, 1, 1, 10.0, 3.0);
  EXPECT_WITHIN(clock.difference().value(), 0.25, 1e-12);
  EXPECT_FALSE(clock.enough_later());
  move(clock, 2, 0, 0.0, 2.8);  // the first target of the next trial
  EXPECT_EQ(clock.movements(), 3);
  EXPECT_TRUE(clock.enough_later());
}

TEST(PracticeClock, FourMovementsAreTheMost) {
  PracticeClock clock;
  for (int target = 0; target < PracticeClock::kMostMovements; ++target) {
    EXPECT_FALSE(clock.enough_later()) << target;
    move(clock, 1, target, 20.0 * target, 2.0 + 3.0 * target);
  }
  EXPECT_TRUE(clock.enough_later());
}

TEST(PracticeClock, ATargetThatWasGivenUpIsNoMovement) {
  PracticeClock clock;
  clock.add(frame(1, 0.0, 0), true);
  clock.add(frame(1, 15.0, 1), true);
  EXPECT_EQ(clock.movements(), 0);
}

}  // namespace
}  // namespace isograsp::gui::practice_clock_test
