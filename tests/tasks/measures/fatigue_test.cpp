// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/fatigue.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::fatigue_test {
namespace {

using test::sampled;
using test::times;

/// Steady for 5 s, then falling by `rate` of the force per second.
std::vector<double> fading(const std::vector<double>& t_s, double force_N, double rate) {
  return sampled(
      t_s, [&](double s) { return force_N * (1.0 - rate * std::max(0.0, s - t_s.front() - 5.0)); });
}

TEST(Fatigue, SlopeOfALineIsItsShareOfTheFirstFiveSecondsAtAnyRateUnitAndDirection) {
  for (const double rate_Hz : {100.0, 500.0})
    for (const double force_N : {40.0, 40000.0, -40.0}) {
      const auto t = times(static_cast<std::size_t>(30.0 * rate_Hz), rate_Hz, 7.0);
      const auto x = sampled(t, [&](double s) { return force_N * (1.0 - 0.01 * (s - 7.0)); });
      const double fresh = 1.0 - 0.01 * (2.5 - 0.5 / rate_Hz);  // mean of the samples before 5 s
      EXPECT_WITHIN(fatigue_slope(t, x).value.value(), -1.0 / fresh, 1e-10);
    }
}

TEST(Fatigue, EnduranceEndsWhereTheForceFallsBelowEightyPercentForGood) {
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto t = times(static_cast<std::size_t>(30.0 * rate_Hz), rate_Hz, 7.0);
    auto x = fading(t, 40.0, 0.02);  // 80 % at 15 s
    for (std::size_t k = 0; k < static_cast<std::size_t>(0.9 * rate_Hz); ++k)
      x[static_cast<std::size_t>(8.0 * rate_Hz) + k] = 1.0;  // a lapse of 0.9 s
    const statistics::EventTime found = time_to_fatigue(t, x);
    EXPECT_GE(found.time_s.value.value(), 15.0 - 1e-9);
    EXPECT_LE(found.time_s.value.value(), 15.0 + 1.0 / rate_Hz + 1e-9);
    EXPECT_FALSE(found.longer_than_s);
  }
}

TEST(Fatigue, WhoHoldsOutIsCensoredAtTheEnd) {
  const auto t = times(3001);
  const statistics::EventTime found = time_to_fatigue(t, fading(t, 40.0, 0.001));
  EXPECT_FALSE(found.time_s.value);
  EXPECT_WITHIN(found.longer_than_s.value(), 30.0, 1e-12);
}

TEST(Fatigue, WithoutFiveSecondsOfForceThereIsAReason) {
  const auto t = times(450);
  EXPECT_FALSE(fatigue_slope(t, fading(t, 40.0, 0.0)).value);
  EXPECT_FALSE(time_to_fatigue(t, fading(t, 40.0, 0.0)).longer_than_s);
  const auto longer = times(900);
  EXPECT_EQ(english(fatigue_slope(longer, std::vector<double>(900, 0.0)).reason),
            "the first 5 s have no force");
  EXPECT_FALSE(fatigue_slope({}, {}).value);
}

}  // namespace
}  // namespace isograsp::tasks::fatigue_test
