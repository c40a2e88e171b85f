// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/survival.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::statistics::survival_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kLimit_s = 30.0;
constexpr Completion kTimeOut{kLimit_s, false};

TEST(Survival, WithoutTimeOutsTheRestrictedMeanIsTheMeanAndTheMedianTheMiddle) {
  const std::vector<Completion> all{{9.0, true}, {4.0, true}, {6.0, true}};
  EXPECT_WITHIN(restricted_mean_time(all, kLimit_s).value.value(), 19.0 / 3.0, kRounding);
  EXPECT_EQ(median_completion(all).value, 6.0);
}

TEST(Survival, ATimeOutCountsAsTheLimitInTheMeanAndNeverShortensTheMedian) {
  const std::vector<Completion> some{{4.0, true}, kTimeOut, {6.0, true}, kTimeOut, {9.0, true}};
  const Reached reached = reached_of(some);
  EXPECT_EQ(reached.count, 3);
  EXPECT_EQ(reached.of, 5);
  EXPECT_EQ(median_completion(some).value, 9.0);
  EXPECT_WITHIN(restricted_mean_time(some, kLimit_s).value.value(), (4.0 + 6.0 + 9.0 + 60.0) / 5.0,
                kRounding);
}

TEST(Survival, FailingMoreOftenNeverLooksFaster) {
  std::vector<Completion> trials{{4.0, true}, {25.0, true}, {6.0, true}};
  const double mean_s = *restricted_mean_time(trials, kLimit_s).value;
  const double median_s = *median_completion(trials).value;
  trials[1] = kTimeOut;  // the mean of the successes would fall from 11.7 to 5 s
  EXPECT_GT(*restricted_mean_time(trials, kLimit_s).value, mean_s);
  EXPECT_GE(*median_completion(trials).value, median_s);
}

TEST(Survival, WhenFewerThanHalfArriveTheMedianIsLongerThanTheLimit) {
  const std::vector<Completion> few{{4.0, true}, kTimeOut, kTimeOut};
  EXPECT_EQ(english(median_completion(few).reason), "longer than the limit");
  EXPECT_EQ(median_completion(std::vector<Completion>{{4.0, true}, kTimeOut}).value, 4.0);
  EXPECT_EQ(english(median_completion({}).reason), "nothing was tried");
  EXPECT_FALSE(restricted_mean_time({}, kLimit_s).value);
}

TEST(Survival, AttemptsThatEndEarlyCountAsLongAsTheyLasted) {
  // By hand: S = 5/6 at 2, 5/6 3/4 = 5/8 at 4 (3 stopped), 5/16 at 7 (5 stopped), 0 at 10.
  const std::vector<Completion> mixed{{2.0, true},  {3.0, false}, {4.0, true},
                                      {5.0, false}, {7.0, true},  {10.0, true}};
  const auto steps = survival(mixed);
  ASSERT_EQ(steps.size(), 4u);
  const double shares[] = {5.0 / 6.0, 5.0 / 8.0, 5.0 / 16.0, 0.0};
  const double at_s[] = {2.0, 4.0, 7.0, 10.0};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_WITHIN(steps[k].share, shares[k], kRounding);
    EXPECT_EQ(steps[k].time_s, at_s[k]);
  }
  EXPECT_EQ(median_completion(mixed).value, 7.0);
  EXPECT_WITHIN(restricted_mean_time(mixed, kLimit_s).value.value(),
                2.0 + 2.0 * 5.0 / 6.0 + 3.0 * 5.0 / 8.0 + 3.0 * 5.0 / 16.0, kRounding);
  EXPECT_WITHIN(restricted_mean_time(mixed, 5.0).value.value(), 2.0 + 2.0 * 5.0 / 6.0 + 5.0 / 8.0,
                kRounding);
}

TEST(Survival, WhoStopsWhenAnotherArrivesWasStillTrying) {
  const auto steps = survival(std::vector<Completion>{{4.0, false}, {4.0, true}, {8.0, true}});
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_WITHIN(steps[0].share, 2.0 / 3.0, kRounding);
}

TEST(Survival, TheLastBitOfATimeDoesNotSayWhoWasStillTrying) {
  // Reached in the very last moment, while two others were tried to the limit: three tried.
  for (const double last_s :
       {std::nextafter(kLimit_s, 0.0), kLimit_s, std::nextafter(kLimit_s, 99.0)}) {
    const std::vector<Completion> all{{last_s, true}, kTimeOut, kTimeOut};
    const auto steps = survival(all);
    ASSERT_EQ(steps.size(), 1u);
    EXPECT_WITHIN(steps[0].share, 2.0 / 3.0, kRounding) << last_s - kLimit_s;
    EXPECT_EQ(english(median_completion(all).reason), "longer than the limit");
  }
}

TEST(Survival, BeyondTheLastAttemptTheMeanIsNotKnown) {
  const std::vector<Completion> stopped{{4.0, true}, {12.0, false}};
  EXPECT_EQ(english(restricted_mean_time(stopped, kLimit_s).reason),
            "the last attempts ended before the limit");
  EXPECT_WITHIN(restricted_mean_time(stopped, 12.0).value.value(), 4.0 + 0.5 * 8.0, kRounding);
}

TEST(Survival, RanksTieTimeOutsWorstHoweverLongTheyTried) {
  const std::vector<Completion> some{{9.0, true}, kTimeOut, {4.0, true}, {2.0, false}, {9.0, true}};
  EXPECT_EQ(ranks(some), (std::vector<double>{2.5, 4.5, 1.0, 4.5, 2.5}));
  std::vector<Completion> a_bit_later = some;
  a_bit_later[0].time_s = std::nextafter(9.0, 99.0);
  EXPECT_EQ(ranks(a_bit_later), ranks(some));
}

}  // namespace
}  // namespace isograsp::statistics::survival_test
