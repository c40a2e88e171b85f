// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/onset.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::onset_test {
namespace {

using test::sampled;
using test::times;

constexpr double kLsb_N = 0.04;

/// Rest at 1 N with a ripple of 0.01 N, then 20 N/s from `start_s` on.
std::vector<double> ramp_from(const std::vector<double>& t_s, double start_s) {
  return sampled(t_s, [&](double s) {
    return 1.0 + 0.01 * std::sin(40.0 * s) + 20.0 * std::max(0.0, s - start_s);
  });
}

TEST(Onset, TheMarginIsThreeDeviationsButNeverLessThanTwoSteps) {
  EXPECT_DOUBLE_EQ((RestingLevel{5.0, 0.1}.margin(kLsb_N)), 0.3);
  EXPECT_DOUBLE_EQ((RestingLevel{5.0, 0.01}.margin(kLsb_N)), 0.08);
  const auto level = resting_level(std::vector<double>{1.0, 3.0});
  ASSERT_TRUE(level);
  EXPECT_DOUBLE_EQ(level->mean, 2.0);
  EXPECT_DOUBLE_EQ(level->sd, std::sqrt(2.0));
  EXPECT_FALSE(resting_level(std::vector<double>{1.0}));
}

TEST(Onset, IsWhereTheForceStartsToStayAboveAtAnyRateAndAnyOriginOfTime) {
  for (const double rate_Hz : {100.0, 500.0})
    for (const double origin_s : {0.0, 1234.5}) {
      const auto t = times(static_cast<std::size_t>(4.0 * rate_Hz), rate_Hz, origin_s);
      const auto found = onset(t, ramp_from(t, origin_s + 2.0), 1.08, Change::rise);
      ASSERT_TRUE(found);
      // The ramp needs 4 ms for 0.08 N; ripple and sampling add at most half a ms and one sample.
      EXPECT_GE(t[*found], origin_s + 2.0035);
      EXPECT_LE(t[*found], origin_s + 2.0045 + 1.0 / rate_Hz);
    }
}

TEST(Onset, AFallIsAMirroredRise) {
  const auto t = times(400);
  auto x = ramp_from(t, 2.0);
  const auto rise = onset(t, x, 1.08, Change::rise);
  for (double& value : x) value = -value;
  EXPECT_EQ(onset(t, x, -1.08, Change::fall), rise);
  EXPECT_FALSE(onset(t, x, -1.08, Change::rise) == rise);
}

TEST(Onset, WhatLastsLessThan50MillisecondsIsNoOnset) {
  const auto t = times(100);
  std::vector<double> x(100, 0.0);
  for (std::size_t k = 20; k < 24; ++k) x[k] = 1.0;  // 40 ms
  EXPECT_FALSE(onset(t, x, 0.5, Change::rise));
  x[24] = 1.0;  // 50 ms
  EXPECT_EQ(onset(t, x, 0.5, Change::rise), 20u);
}

TEST(Onset, AHoleInTheRecordIsNoTimeAboveTheThreshold) {
  auto t = times(100);
  std::vector<double> x(100, 0.0);
  x[20] = x[21] = 1.0;
  for (std::size_t k = 21; k < t.size(); ++k) t[k] += 0.3;
  EXPECT_FALSE(onset(t, x, 0.5, Change::rise));
  t = times(100);
  for (std::size_t k = 22; k < t.size(); ++k) t[k] += 0.01;  // one lost sample is bridged
  x[22] = x[23] = 1.0;
  EXPECT_EQ(onset(t, x, 0.5, Change::rise), 20u);
}

TEST(Onset, ReactionIsTheTimeFromTheCueAndAnticipationIsNone) {
  const auto t = times(600);
  struct Case {
    double start_s;
    bool anticipated;
  };
  for (const Case& c : {Case{2.25, false}, Case{2.05, true}, Case{1.9, true}}) {
    const auto x = ramp_from(t, c.start_s);
    const auto rest = resting_level(std::span(x).first(100));
    const Reaction found = reaction(t, x, 2.0, rest.value(), kLsb_N, Change::rise);
    constexpr double kRampAndSample_s = 0.015;  // 4 ms to the threshold and one sample
    EXPECT_EQ(found.anticipated_s.has_value(), c.anticipated) << c.start_s;
    EXPECT_EQ(found.time.time_s.value.has_value(), !c.anticipated) << c.start_s;
    EXPECT_FALSE(found.time.longer_than_s);
    const double time_s = c.anticipated ? *found.anticipated_s : *found.time.time_s.value;
    EXPECT_GE(time_s, c.start_s - 2.0);
    EXPECT_LE(time_s, c.start_s - 2.0 + kRampAndSample_s);
  }
}

TEST(Onset, ATwitchThatIsOverBeforeTheCueDoesNotCount) {
  const auto t = times(600);
  auto x = ramp_from(t, 2.3);
  for (std::size_t k = 150; k < 170; ++k) x[k] += 3.0;
  const auto rest = resting_level(std::span(x).first(100));
  const Reaction found = reaction(t, x, 2.0, rest.value(), kLsb_N, Change::rise);
  EXPECT_WITHIN(found.time.time_s.value.value(), 0.31, 1e-9);
  EXPECT_FALSE(found.anticipated_s);
}

TEST(Onset, WithoutAReactionTheTimeIsCensoredAtTheEndOfTheRecord) {
  const auto t = times(501);
  const std::vector<double> x(501, 1.0);
  const Reaction none = reaction(t, x, 2.0, {1.0, 0.0}, kLsb_N, Change::rise);
  EXPECT_FALSE(none.time.time_s.value);
  EXPECT_FALSE(none.anticipated_s);
  EXPECT_WITHIN(none.time.longer_than_s.value(), 3.0, 1e-12);
  const Reaction too_short = reaction(t, x, 9.0, {1.0, 0.0}, kLsb_N, Change::rise);
  EXPECT_FALSE(too_short.time.longer_than_s) << "nobody waited";
}

TEST(Onset, TheLevelBeforeACueIsThatOfItsLastSecond) {
  const auto t = times(400);
  const auto x = sampled(t, [](double s) { return s < 1.0 ? 9.0 : s < 2.0 ? 5.0 : 7.0; });
  EXPECT_DOUBLE_EQ(level_before(t, x, 2.0).value().mean, 5.0);
  EXPECT_FALSE(level_before(t, x, 0.0));
}

}  // namespace
}  // namespace isograsp::tasks::onset_test
