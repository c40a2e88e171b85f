// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/zeroing.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::zeroing_test {
namespace {

constexpr double kPeriod_s = 0.01;
using Why = ZeroRefusal::Why;

/// A second of frames whose thumb normal force is force(t).
template <class Force>
Zeroing second_of(Force force) {
  Zeroing zeroing(kPeriod_s);
  for (int k = 0; !zeroing.complete(); ++k) {
    FingerFrame frame;
    frame.wrench_C[0].force.z() = force(k * kPeriod_s);
    zeroing.add(frame);
  }
  return zeroing;
}

TEST(Zeroing, MeanSdAndSlopeOfAStraightLineAreExact) {
  const auto s = second_of([](double t) { return 1000.0 + 0.1 * t; }).statistics();
  // The sums are relative to the first value, so an offset of 1000 N costs no digits of the rest.
  constexpr double kRounding = 1e-9;
  EXPECT_WITHIN(s.mean[0][2], 1000.0 + 0.1 * 0.495, kRounding);
  EXPECT_WITHIN(s.slope[0][2], 0.1, kRounding);
  EXPECT_WITHIN(s.sd[0][2], 0.1 * kPeriod_s * std::sqrt(100.0 * 101.0 / 12.0), kRounding);
}

TEST(Zeroing, StatisticsOfKnownNoiseLieWithinTheirConfidenceBounds) {
  constexpr double kSd = 0.05;
  constexpr int kZeros = 400;
  constexpr double n = 100.0;
  constexpr double kAll = 18.0 * kZeros;
  const double slope_sd = kSd / (kPeriod_s * std::sqrt(n * (n * n - 1.0) / 12.0));
  Random random(5);
  double mean_inside = 0.0;
  double slope_inside = 0.0;
  double variance_sum = 0.0;
  for (int k = 0; k < kZeros; ++k) {
    Zeroing zeroing(kPeriod_s);
    while (!zeroing.complete()) {
      FingerFrame frame;
      for (auto& wrench : frame.wrench_C)
        for (const int axis : {0, 1, 2}) {
          wrench.force[axis] = 7.0 + kSd * random.gaussian();
          wrench.torque[axis] = kSd * random.gaussian();
        }
      zeroing.add(frame);
    }
    const auto s = zeroing.statistics();
    constexpr double kNinetyFive = 1.96;  // percent of a normal distribution lie within
    for (std::size_t f = 0; f < kFingerCount; ++f)
      for (Eigen::Index axis = 0; axis < 6; ++axis) {
        const double truth = axis < 3 ? 7.0 : 0.0;
        mean_inside += std::abs(s.mean[f][axis] - truth) < kNinetyFive * kSd / std::sqrt(n);
        slope_inside += std::abs(s.slope[f][axis]) < kNinetyFive * slope_sd;
        variance_sum += s.sd[f][axis] * s.sd[f][axis];
      }
  }
  // Four standard errors each: wrong once in 16,000 seeds.
  const double share_bound = 4.0 * std::sqrt(0.95 * 0.05 / kAll);
  EXPECT_NEAR(mean_inside / kAll, 0.95, share_bound);
  EXPECT_NEAR(slope_inside / kAll, 0.95, share_bound);
  EXPECT_NEAR(variance_sum / kAll / (kSd * kSd), 1.0, 4.0 * std::sqrt(2.0 / (n - 1.0) / kAll));
}

TEST(Zeroing, TheSlopeLimitIsWhereItIsSaidToBe) {
  const ZeroLimits limits;
  for (const double share : {0.99, 1.01}) {
    const auto drifting =
        second_of([&](double t) { return share * limits.force_slope_N_s * t; }).statistics();
    const auto refusal = check_zero(drifting, std::nullopt);
    EXPECT_EQ(refusal.has_value(), share > 1.0);
    if (refusal) {
      EXPECT_EQ(refusal->why, Why::drift);
    }
  }
}

TEST(Zeroing, AQuietEmptyDeviceIsAccepted) {
  std::mt19937_64 bits(1);
  const auto noise = [&](double) { return 0.04 * (static_cast<double>(bits() >> 11) * 0x1p-53); };
  EXPECT_FALSE(check_zero(second_of(noise).statistics(), std::nullopt));
}

TEST(Zeroing, AHandInTheDeviceIsRefusedWithTheReason) {
  const auto tremor = second_of([](double t) { return 3.0 + std::sin(2 * M_PI * 9 * t); });
  EXPECT_EQ(check_zero(tremor.statistics(), std::nullopt)->why, Why::noisy_force);
  const auto leaving = second_of([](double t) { return 3.0 - 0.5 * t; });
  EXPECT_EQ(check_zero(leaving.statistics(), std::nullopt)->why, Why::drift);
  const auto leaning = second_of([](double) { return 40.0; });
  EXPECT_EQ(check_zero(leaning.statistics(), std::nullopt)->why, Why::loaded);
  std::array<Vec6, kFingerCount> last;
  for (auto& mean : last) mean.setZero();
  const auto changed = second_of([](double) { return 2.5; });
  const auto refusal = check_zero(changed.statistics(), last);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->why, Why::changed);
  EXPECT_NE(english(words_of(*refusal)).find("thumb"), std::string::npos);
}

TEST(Zeroing, ALostSampleIsLeftOutAGapStartsAnewAndEndlessGapsAreGivenUp) {
  Zeroing zeroing(kPeriod_s);
  FingerFrame good;
  FingerFrame gap;
  gap.flags[1] = bit(SampleFlag::missing);
  for (int k = 0; k < 90; ++k) zeroing.add(k % 10 == 5 ? gap : good);
  EXPECT_EQ(zeroing.progress(), 0.81);
  Zeroing half(kPeriod_s);
  for (int k = 0; k < 300; ++k) half.add(k % 2 == 0 ? gap : good);
  EXPECT_FALSE(half.complete()) << "half the samples are not a quiet second";
  for (int k = 0; k < 6; ++k) zeroing.add(gap);
  EXPECT_EQ(zeroing.progress(), 0.0);
  while (!zeroing.hopeless()) zeroing.add(gap);
  EXPECT_FALSE(zeroing.complete());
}

}  // namespace
}  // namespace isograsp::session::zeroing_test
