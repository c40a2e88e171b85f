// SPDX-License-Identifier: GPL-3.0-or-later
// The default measures of the file format, and the laws they obey.
#include <bit>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::score_pairs_test {
namespace {

using test::find;
using test::sampled;
using test::times;
using test::value_of;

double wander(double s) {
  return 12.0 + 4.0 * std::sin(1.3 * s) + 2.0 * std::sin(2.9 * s + 1.0);
}

/// Grip follows a wandering target 0.2 s later; the hand moves along a curve.
Signals following(const std::vector<double>& t_s) {
  Signals signals;
  signals.add_column("t_s", t_s);
  const double start = t_s.front();
  const auto at = [&](auto&& f) { return sampled(t_s, [&](double t) { return f(t - start); }); };
  signals.add_column("target_force_N", at(wander));
  signals.add_column("actual_force_N", at([](double s) { return 0.9 * wander(s - 0.2); }));
  // One reach in the middle, at rest at both ends of the record.
  signals.add_column("actual_x_m", at([](double s) { return 0.1 * std::tanh(s - 8.0); }));
  signals.add_column("actual_y_m", at([](double s) { return 0.05 * std::tanh(1.3 * (s - 7.5)); }));
  return signals;
}

TEST(ScorePairs, GivesEveryDefaultMeasureWithChannelAndUnit) {
  const auto measures = score_pairs(following(times(2000)));
  const std::tuple<const char*, const char*, const char*> expected[] = {
      {"rmse", "force", "N"},          {"mae", "force", "N"},     {"constant_error", "force", "N"},
      {"time_in_range", "force", "%"}, {"cv", "force", "%"},      {"sample_entropy", "force", ""},
      {"lag", "force", "s"},           {"sparc", "position", ""}, {"ldlj", "position", ""}};
  ASSERT_EQ(measures.size(), std::size(expected));
  for (std::size_t i = 0; i < measures.size(); ++i) {
    EXPECT_EQ(std::tie(measures[i].name, measures[i].channel, measures[i].unit),
              (std::tuple<std::string, std::string, std::string>(expected[i])));
    EXPECT_TRUE(measures[i].value) << measures[i].name << ": " << measures[i].reason;
    EXPECT_EQ(measures[i].samples, 2000);
    EXPECT_EQ(measures[i].excluded, 0);
  }
}

TEST(ScorePairs, ALaterStartOfTheClockChangesNothing) {
  const auto early = score_pairs(following(times(2000)));
  const auto late = score_pairs(following(times(2000, 100.0, 1000.0)));
  // Times near 1000 s carry 1e-13 s of rounding; the second difference in ldlj divides it by dt^2.
  constexpr double kRelative = 1e-6;
  for (std::size_t i = 0; i < early.size(); ++i) {
    ASSERT_TRUE(early[i].value && late[i].value);
    EXPECT_WITHIN(*late[i].value, *early[i].value, kRelative * std::abs(*early[i].value))
        << early[i].name;
  }
}

TEST(ScorePairs, TheSameMovementAtFiveTimesTheRateHasTheSameMeasures) {
  const auto slow = score_pairs(following(times(3000, 100.0)));
  const auto fast = score_pairs(following(times(15000, 500.0)));
  // Sums over a smooth signal differ by O(dt); sample entropy counts samples: it depends on the
  // rate.
  constexpr double kStep = 0.01;
  for (const char* name :
       {"rmse", "mae", "constant_error", "time_in_range", "cv", "lag", "sparc", "ldlj"}) {
    const double a = value_of(slow, name);
    EXPECT_WITHIN(value_of(fast, name), a, kStep * std::abs(a)) << name;
  }
}

TEST(ScorePairs, EmptyFlaggedAndPausedRowsAreLeftOutAndCounted) {
  Signals signals({"t_s", "target_x_m", "actual_x_m", "sample_flags", "phase"});
  const double nan = std::nan("");
  const double rows[][5] = {{0.0, 1, 2, 0, 1},  {0.1, 1, nan, 0, 1}, {0.2, nan, 9, 0, 1},
                            {0.3, 1, 99, 1, 1}, {0.4, 1, 50, 0, 4},  {0.5, 1, 2, 0, 1}};
  for (const auto& row : rows) signals.append_row(row);
  const auto measures = score_pairs(signals);
  const Measure* error = find(measures, "rmse");
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->value, 1.0);
  EXPECT_EQ(error->samples, 2);
  EXPECT_EQ(error->excluded, 4);
}

TEST(ScorePairs, ANullMeasureSaysWhy) {
  Signals signals;
  signals.add_column("t_s", times(50));
  signals.add_column("target_force_N", std::vector<double>(50, 0.0));
  signals.add_column("actual_force_N", std::vector<double>(50, 0.0));
  const auto measures = score_pairs(signals);
  for (const char* name : {"cv", "lag", "sample_entropy"}) {
    EXPECT_FALSE(find(measures, name)->value) << name;
    EXPECT_FALSE(find(measures, name)->reason.empty()) << name;
  }
  EXPECT_EQ(find(measures, "rmse")->value, 0.0);
  EXPECT_EQ(find(measures, "sparc"), nullptr) << "there is no position";
}

TEST(ScorePairs, AColumnWithoutAValueGivesReasonsOnly) {
  Signals signals;
  signals.add_column("t_s", times(5));
  signals.add_column("target_force_N", std::vector<double>(5, 1.0));
  signals.add_column("actual_force_N", std::vector<double>(5, std::nan("")));
  for (const Measure& measure : test::every(score_pairs(signals))) {
    EXPECT_FALSE(measure.value);
    EXPECT_EQ(measure.reason, "no samples");
    EXPECT_EQ(measure.excluded, 5);
  }
}

TEST(ScorePairs, IrregularTimesAreWeightedByHoldAndResampled) {
  auto t = times(3000);
  std::uint64_t state = 1;
  for (std::size_t k = 1; k < t.size(); ++k) {  // jitter of up to a third of a step
    state = (1103515245u * state + 12345u) % (std::uint64_t{1} << 31);
    t[k] += 0.003 * (static_cast<double>(state) / static_cast<double>(std::uint64_t{1} << 31));
  }
  const auto regular = score_pairs(following(times(3000)));
  const auto jittered = score_pairs(following(t));
  constexpr double kLinearInterpolation = 0.01;
  for (const char* name : {"rmse", "mae", "constant_error", "cv", "lag", "sparc"}) {
    const double a = value_of(regular, name);
    EXPECT_WITHIN(value_of(jittered, name), a, kLinearInterpolation * std::abs(a)) << name;
  }
}

TEST(ScorePairs, TimesThatWouldNeedAGridOfTerabytesGiveReasonsOnly) {
  Signals signals;
  signals.add_column("t_s", {0.0, 1e-9, 2e-9, 3e-9, 1e6});
  signals.add_column("target_force_N", {1.0, 1.0, 2.0, 2.0, 2.0});
  signals.add_column("actual_force_N", {2.0, 2.0, 2.0, 3.0, 3.0});
  for (const Measure& measure : test::every(score_pairs(signals))) {
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_NE(measure.reason.find("gaps"), std::string::npos) << measure.name;
  }
}

TEST(ScorePairs, AWrittenAndReadBackRecordHasTheSameScoreBitForBit) {
  const Signals signals = following(times(1500));
  const test::TemporaryFolder folder;
  ASSERT_TRUE(write_signals(signals, folder.path("trial.csv")));
  const auto read = read_signals(folder.path("trial.csv"));
  ASSERT_TRUE(read) << read.error().message();
  const auto before = score_pairs(signals);
  const auto after = score_pairs(*read);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(before[i].value.value()),
              std::bit_cast<std::uint64_t>(after[i].value.value()))
        << before[i].name;
}

}  // namespace
}  // namespace isograsp::tasks::score_pairs_test
