// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/coupling.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::coupling_test {
namespace {

using test::sampled;
using test::times;

constexpr double kRounding = 1e-9;

double load_at(double t) {
  return 3.0 + std::sin(4.1 * t) + 0.4 * std::sin(9.7 * t + 1.0);
}
Coupling coupling_of(double lag_s, double gain, double rate_Hz) {
  const auto t = times(static_cast<std::size_t>(20.0 * rate_Hz), rate_Hz);
  return grip_load_coupling(
      {1.0 / rate_Hz, sampled(t, [&](double s) { return 5.0 + gain * load_at(s - lag_s); })},
      {1.0 / rate_Hz, sampled(t, load_at)});
}

TEST(Coupling, AGripThatFollowsLoadHasItsLagInBothDirectionsAtAnyRate) {
  constexpr double kParabola = 3e-4;
  for (const double lag_s : {0.0, 0.06, -0.113, 0.3})
    for (const double rate_Hz : {100.0, 500.0}) {
      const Coupling found = coupling_of(lag_s, 1.7, rate_Hz);
      EXPECT_WITHIN(found.correlation.value.value(), 1.0, kParabola);
      EXPECT_WITHIN(found.lag_s.value.value(), lag_s, kParabola) << rate_Hz;
    }
  EXPECT_WITHIN(coupling_of(0.0, 1.7, 100.0).slope.value.value(), 1.7, kRounding);
}

TEST(Coupling, CorrelationIsPearsonsOfTheOverlapAtTheBestLag) {
  Random random(9);
  statistics::UniformSamples grip{0.01, {}};
  statistics::UniformSamples load{0.01, {}};
  double wander = 0.0;
  for (int k = 0; k < 400; ++k) {
    wander = 0.9 * wander + random.gaussian();
    load.values.push_back(100.0 + wander);
    grip.values.push_back(5.0 + 0.5 * wander + random.gaussian());
  }
  double best = -1.0;
  for (int shift = -50; shift <= 50; ++shift) {
    double n = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (int k = std::max(0, -shift); k < 400 - std::max(0, shift); ++k) {
      const double a = load.values[static_cast<std::size_t>(k)] - 100.0;
      const double b = grip.values[static_cast<std::size_t>(k + shift)] - 5.0;
      n += 1, x += a, y += b, xx += a * a, yy += b * b, xy += a * b;
    }
    best = std::max(best, (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y)));
  }
  EXPECT_WITHIN(grip_load_coupling(grip, load).correlation.value.value(), best, kRounding);
}

TEST(Coupling, WithoutVariationOrTimeThereIsAReason) {
  const statistics::UniformSamples flat{0.01, std::vector<double>(500, 0.1)};
  const statistics::UniformSamples moving{0.01, sampled(times(500), load_at)};
  EXPECT_EQ(english(grip_load_coupling(flat, moving).correlation.reason),
            "grip or load does not vary");
  EXPECT_EQ(english(grip_load_coupling(moving, flat).slope.reason), "grip or load does not vary");
  const statistics::UniformSamples brief{0.01, std::vector<double>(50, 0.1)};
  EXPECT_EQ(english(grip_load_coupling(brief, brief).lag_s.reason),
            "shorter than the lags that are tried");
  // A single rise, answered too late: correlation still grows at the largest lag tried.
  const auto rise = [](double t) { return std::tanh(t - 5.0); };
  const Coupling late =
      grip_load_coupling({0.01, sampled(times(1000), [&](double t) { return rise(t - 0.9); })},
                         {0.01, sampled(times(1000), rise)});
  EXPECT_EQ(english(late.lag_s.reason), "the correlation has no peak within 0.5 s");
  EXPECT_TRUE(late.correlation.value);
}

TEST(Coupling, GripIsTheMeanOfBothSides) {
  EXPECT_EQ(opposing_mean(std::vector<double>{4.0, 2.0}, std::vector<double>{6.0, 0.0}),
            (std::vector<double>{5.0, 1.0}));
}

TEST(Coupling, SafetyMarginIsZeroWhereTheGripIsTheOneThatIsNeeded) {
  const std::vector<double> weight{1.0, 3.0};
  const std::vector<double> grip{10.0, 20.0};
  EXPECT_WITHIN(safety_margin(grip, grip, weight).value.value(), 0.0, kRounding);
  // Margins 1 - 5 / 10 and 1 - 0.
  EXPECT_WITHIN(safety_margin(grip, std::vector<double>{5.0, 0.0}, weight).value.value(),
                100.0 * (0.5 + 3.0) / 4.0, kRounding);
  EXPECT_LT(safety_margin(grip, std::vector<double>{22.0, 22.0}, weight).value.value(), 0.0);
  EXPECT_EQ(english(safety_margin(std::vector<double>{0.0}, std::vector<double>{1.0},
                                  std::vector<double>{1.0})
                        .reason),
            "there was no grip");
}

}  // namespace
}  // namespace isograsp::tasks::coupling_test
