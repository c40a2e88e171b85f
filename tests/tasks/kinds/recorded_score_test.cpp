// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings made elsewhere: known answers, and laws of the measures.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::recorded_score_test {
namespace {

using test::edited;
using test::find;
using test::value_of;

constexpr double kRounding = 1e-12;

std::string task_text(const std::string& keys) {
  return "format = \"isograsp-task-1\"\nname = \"Recorded\"\ninstruction = \"As recorded.\"\n"
         "kind = \"recorded\"\nduration_s = 3.5\n" +
         keys;
}
TaskSpec task(const std::string& keys) {
  auto spec = parse_task(task_text(keys), "recorded.toml");
  EXPECT_TRUE(spec) << spec.error().message();
  return *std::move(spec);
}
const std::string kCorridor = "measures = \"corridor\"\n";
const std::string kFingers =
    "measures = \"finger_forces\"\nfingers = [\"index\", \"middle\", \"ring\", \"little\"]\n"
    "beats_per_cycle = 2\ncycles_left_out = 1\n";

TEST(Recorded, ATaskFileSaysHowLongItLasts) {
  EXPECT_EQ(task(kCorridor).duration().nominal_s, 3.5);
  EXPECT_EQ(task(kCorridor).duration().worst_s, 3.5);
  EXPECT_TRUE(task(kCorridor).scene().empty());
  EXPECT_FALSE(task(kCorridor).needs_maximum());
}

TEST(Recorded, NobodyCanDoItLive) {
  TaskContext context;
  context.period_s = 0.01;
  const auto live = make_task(task(kCorridor), context);
  ASSERT_FALSE(live);
  EXPECT_NE(english(live.error().what).find("nobody can do live"), std::string::npos);
  EXPECT_NE(english(live.error().remedy).find("isograsp import"), std::string::npos);
}

TEST(Recorded, KeysThatDoNotFitAreRefusedWithTheirName) {
  for (const auto& [keys, field] :
       {std::pair<std::string, std::string>{"measures = \"beauty\"\n", "measures"},
        {"measures = \"maximum\"\n", "window_from_end_rows"},
        {"measures = \"maximum\"\nwindow_from_end_rows = [50, 200]\n", "window_from_end_rows"},
        {"measures = \"maximum\"\nwindow_from_end_rows = [20.5, 2]\n", "window_from_end_rows"},
        {"measures = \"finger_forces\"\nfingers = [\"ring\"]\n", "fingers"},
        {"measures = \"finger_forces\"\nfingers = [\"a\", \"b\"]\ncycles_left_out = -1\n",
         "cycles_left_out"},
        {kCorridor + "fingers = [\"index\", \"ring\"]\n", "fingers"}}) {
    const auto spec = parse_task(task_text(keys), "recorded.toml");
    ASSERT_FALSE(spec) << keys;
    EXPECT_NE(spec.error().field.find(field), std::string::npos) << spec.error().message();
  }
}

/// Half of the time inside, a quarter 3 N above the corridor, a quarter 1 N below.
Signals corridor_rows(const std::vector<double>& t_s) {
  Signals signals({"t_s", "actual_force_N", "corridor_error_N"});
  const double errors_N[] = {0.0, 3.0, 0.0, -1.0};
  for (std::size_t k = 0; k < t_s.size(); ++k)
    signals.append_row(std::vector{t_s[k], 10.0 + errors_N[k % 4], errors_N[k % 4]});
  return signals;
}

TEST(Recorded, TheCorridorCountsOnlyWhatIsOutside) {
  const auto measures = score(task(kCorridor), corridor_rows(test::times(400)));
  EXPECT_WITHIN(value_of(measures, "corridor_rms"), std::sqrt(10.0 / 4.0), kRounding);
  EXPECT_WITHIN(value_of(measures, "corridor_distance"), 1.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "time_in_corridor"), 50.0, 1e-10);
}

TEST(Recorded, TheCorridorWeighsRowsWithTheTimeTheyHold) {
  std::vector<double> t_s{0.0};
  const double holds_s[] = {0.01, 0.03, 0.01, 0.01};  // the row 3 N above lasts three times as long
  for (int k = 0; k < 399; ++k) t_s.push_back(t_s.back() + holds_s[k % 4]);
  const auto measures = score(task(kCorridor), corridor_rows(t_s));
  EXPECT_WITHIN(value_of(measures, "corridor_rms"), std::sqrt((3.0 * 9.0 + 1.0) / 6.0), 1e-10);
  EXPECT_WITHIN(value_of(measures, "time_in_corridor"), 100.0 / 3.0, 1e-10);
}

TEST(Recorded, WhatIsMissingIsSaidAndNeverZero) {
  for (const std::string& keys :
       {kCorridor, std::string("measures = \"maximum\"\nwindow_from_end_rows = [2, 0]\n"),
        std::string("measures = \"tracking\"\n"), kFingers}) {
    Signals nothing({"t_s", "other_N"});
    for (const double t : test::times(10)) nothing.append_row(std::vector{t, 1.0});
    const auto measures = score(task(keys), nothing);
    ASSERT_FALSE(measures.empty());
    for (const Measure& measure : test::every(measures)) {
      EXPECT_FALSE(measure.value) << measure.name;
      EXPECT_NE(measure.reason.find("is missing"), std::string::npos) << measure.name;
    }
  }
}

TEST(Recorded, TheMaximumIsTheMeanSizeOfTheForceInTheStatedRows) {
  const TaskSpec spec = task("measures = \"maximum\"\nwindow_from_end_rows = [200, 50]\n");
  Signals signals({"t_s", "actual_force_N"});
  // 300 rows: only 100 to 249 are in the window, half of them pulled.
  for (std::size_t k = 0; k < 300; ++k) {
    const double inside_N = k % 2 == 0 ? 80.0 : -40.0;
    signals.append_row(
        std::vector{static_cast<double>(k) * 0.02, k >= 100 && k < 250 ? inside_N : 1000.0});
  }
  const auto measures = score(spec, signals);
  EXPECT_WITHIN(value_of(measures, "maximum_window_mean"), 60.0, kRounding * 60.0);
  EXPECT_EQ(find(measures, "maximum_window_mean")->samples, 150);
  const auto few = score(spec, edited(signals, [](std::size_t k, std::vector<double>& row) {
                           if (k >= 199) row.clear();
                         }));
  EXPECT_EQ(find(few, "maximum_window_mean")->reason, "fewer than 200 rows");
}

TEST(Recorded, TrackingComparesTheForceWithItsTarget) {
  Signals signals({"t_s", "target_force_N", "actual_force_N"});
  for (const double t : test::times(100)) signals.append_row(std::vector{t, 20.0, 22.0});
  const auto measures = score(task("measures = \"tracking\"\n"), signals);
  EXPECT_WITHIN(value_of(measures, "rmse"), 2.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "constant_error"), 2.0, kRounding);
  EXPECT_WITHIN(value_of(measures, "relative_rmse"), 10.0, 1e-10);
  EXPECT_EQ(value_of(measures, "time_in_range"), 0.0);
}

constexpr double kRate_Hz = 200.0;
constexpr std::size_t kRowsPerBeat = 150;
constexpr double kCycle_Hz = kRate_Hz / (2.0 * kRowsPerBeat);
constexpr double kShares[] = {0.4, 0.3, 0.2, 0.1};

/// Four fingers share a force that swings about 12 N; `between_N` moves force from ring to index,
/// `together_N` adds the same to all, both another amount in every cycle.
Signals finger_rows(double between_N, double together_N, double rate_Hz = kRate_Hz,
                    double from_s = 0.0) {
  Signals signals({"t_s", "index_fz_N", "middle_fz_N", "ring_fz_N", "little_fz_N", "beat"});
  const auto per_beat = static_cast<std::size_t>(std::lround(kRowsPerBeat * rate_Hz / kRate_Hz));
  for (std::size_t k = 0; k < 40 * per_beat; ++k) {
    const double t_s = static_cast<double>(k) / rate_Hz;
    const double sum_N = 12.0 + 6.0 * std::sin(2.0 * std::numbers::pi * kCycle_Hz * t_s);
    const auto cycle = static_cast<double>(k / (2 * per_beat));
    const double between = between_N * std::sin(2.4 * cycle);
    const double together = together_N * std::sin(2.4 * cycle);
    signals.append_row(std::vector{from_s + t_s, kShares[0] * sum_N + between + together,
                                   kShares[1] * sum_N + together,
                                   kShares[2] * sum_N - between + together,
                                   kShares[3] * sum_N + together, k % per_beat == 0 ? 1.0 : 0.0});
  }
  return signals;
}

TEST(Recorded, TheRhythmIsThatOfTheSumAtAnyRate) {
  constexpr double kNear_Hz = 0.005;  // a parabola through the lines of a Hann window
  for (const double rate_Hz : {100.0, 200.0, 400.0})
    EXPECT_WITHIN(value_of(score(task(kFingers), finger_rows(0.0, 0.0, rate_Hz)), "rhythm"),
                  kCycle_Hz, kNear_Hz)
        << rate_Hz;
}

TEST(Recorded, TheFingersShareAllOfTheForce) {
  const auto measures = score(task(kFingers), finger_rows(0.0, 0.0));
  std::size_t finger = 0;
  for (const char* name : {"index", "middle", "ring", "little"})
    EXPECT_WITHIN(value_of(measures, "sharing", name), 100.0 * kShares[finger++], 1e-10) << name;
}

TEST(Recorded, FingersThatCorrectEachOtherAreASynergyAndThoseThatMoveTogetherAreNot) {
  // All variance within the manifold of equal sums: n / (n - 1). All across it: -n.
  constexpr double kHalfRow = 1e-6;  // the forces repeat but for the rounding of their phase
  const auto correcting = score(task(kFingers), finger_rows(1.0, 0.0));
  EXPECT_WITHIN(value_of(correcting, "synergy_index"), 4.0 / 3.0, kHalfRow);
  const auto together = score(task(kFingers), finger_rows(0.0, 1.0));
  EXPECT_WITHIN(value_of(together, "synergy_index"), -4.0, kHalfRow);
  EXPECT_WITHIN(value_of(together, "variance_within"), 0.0, kHalfRow);
  EXPECT_GT(value_of(together, "variance_across"), 1.0);
}

TEST(Recorded, TheSynergyDoesNotDependOnTheBeginningOfTime) {
  const auto early = score(task(kFingers), finger_rows(1.0, 0.5));
  const auto late = score(task(kFingers), finger_rows(1.0, 0.5, kRate_Hz, 1000.0));
  EXPECT_WITHIN(value_of(early, "synergy_index"), value_of(late, "synergy_index"), 1e-9);
  EXPECT_GT(value_of(early, "synergy_index"), -4.0);
  EXPECT_LT(value_of(early, "synergy_index"), 4.0 / 3.0);
}

TEST(Recorded, TooFewCyclesGiveNoSynergy) {
  std::string keys = kFingers;
  keys.replace(keys.find("cycles_left_out = 1"), 19, "cycles_left_out = 5");
  const auto measures = score(task(keys), finger_rows(1.0, 0.5));
  EXPECT_EQ(find(measures, "synergy_index")->reason, "fewer than 15 trials");
}

}  // namespace
}  // namespace isograsp::tasks::recorded_score_test
