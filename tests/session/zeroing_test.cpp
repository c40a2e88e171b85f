// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/zeroing.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace isograsp {
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
  EXPECT_NEAR(s.mean[0][2], 1000.0 + 0.1 * 0.495, kRounding);
  EXPECT_NEAR(s.slope[0][2], 0.1, kRounding);
  EXPECT_NEAR(s.sd[0][2], 0.1 * kPeriod_s * std::sqrt(100.0 * 101.0 / 12.0), kRounding);
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
  EXPECT_NE(describe(*refusal).find("thumb"), std::string::npos);
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
}  // namespace isograsp
