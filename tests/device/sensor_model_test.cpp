// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/simulated/sensor_model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::sensor_model_test {
namespace {

constexpr double kDt_s = 1.0 / kSensorModelRate_Hz;

Wrench normal_force(double fz_N) {
  return {Vec3(0, 0, fz_N), Vec3::Zero()};
}

TEST(SensorModel, IsTheReferenceFilterFollowedByThePureDelay) {
  SensorModel sensor(1);
  const LowPass2 filter = butterworth2(kSensorModelRate_Hz, kSensorCutoff_Hz);
  std::vector<double> filtered;
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (int n = 0; n < 200; ++n) {
    const double x = std::sin(0.07 * n) + 3.0;
    const double y =
        filter.b0 * x + filter.b1 * x1 + filter.b2 * x2 - filter.a1 * y1 - filter.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    filtered.push_back(y);
    sensor.step(normal_force(x));
    if (n < 25) continue;
    const auto k = static_cast<std::size_t>(n);
    constexpr double kRounding = 1e-14;  // a few ulp of values near 3
    EXPECT_WITHIN(sensor.delayed()[2], 0.2 * filtered[k - 24] + 0.8 * filtered[k - 25], kRounding);
  }
}

TEST(SensorModel, AStepIsHalfWayAfter32Milliseconds) {
  SensorModel sensor(1);
  double before = 0.0;
  double half_way_s = 0.0;
  double missing_area_s = 0.0;  // of a unit step: the mean delay
  for (int n = 0; n < 2000; ++n) {
    sensor.step(normal_force(1.0));
    const double now = sensor.delayed()[2];
    if (before < 0.5 && now >= 0.5) half_way_s = (n - 1 + (0.5 - before) / (now - before)) * kDt_s;
    missing_area_s += (1.0 - now) * kDt_s;
    before = now;
  }
  constexpr double kMillisecond = 0.001;  // one step of the model
  EXPECT_WITHIN(half_way_s, kSensorDelay_s, kMillisecond);
  constexpr double kTenthOfAMillisecond = 0.0001;
  EXPECT_WITHIN(missing_area_s, kSensorDelay_s, kTenthOfAMillisecond);
}

/// Gain of the model at a frequency, from the largest output of a long unit sine.
double gain_at(double frequency_Hz) {
  SensorModel sensor(1);
  double square_sum = 0.0;
  constexpr int kSettled = 1000;
  constexpr int kLast = kSettled + 32000;  // whole periods of 31.25 Hz and of its multiples
  for (int n = 0; n < kLast; ++n) {
    sensor.step(normal_force(std::sin(2.0 * std::numbers::pi * frequency_Hz * n * kDt_s)));
    if (n >= kSettled) square_sum += sensor.delayed()[2] * sensor.delayed()[2];
  }
  return std::sqrt(2.0 * square_sum / (kLast - kSettled));
}

TEST(SensorModel, LosesThreeDecibelsAtTheCutOff) {
  constexpr double kTolerance_dB = 0.05;  // 0.027 dB is the linear interpolation of the delay
  EXPECT_WITHIN(20.0 * std::log10(gain_at(31.25)), 20.0 * std::log10(std::sqrt(0.5)),
                kTolerance_dB);
  EXPECT_WITHIN(20.0 * std::log10(gain_at(3.125)), 0.0, kTolerance_dB);
  EXPECT_LT(gain_at(312.5), 0.01);
}

TEST(SensorModel, ReadingsAreWholeCountsWithinTheRange) {
  SensorModel sensor(3);
  const Vec6 resolution = sensor_resolution();
  for (int n = 0; n < 400; ++n) {
    sensor.step({Vec3(1.234, -200.0, 400.0), Vec3(0.1, -9.0, 0.0)});
    const auto reading = sensor.read();
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const double value = axis < 3 ? reading.wrench_C.force[i] : reading.wrench_C.torque[i - 3];
      EXPECT_EQ(value, reading.raw_counts[axis] * resolution[i]);
      EXPECT_LE(std::abs(value), sensor_range()[i]);
    }
  }
  const auto last = sensor.read();
  EXPECT_EQ(last.wrench_C.force.y(), -150.0);
  EXPECT_EQ(last.wrench_C.force.z(), 300.0);
  EXPECT_EQ(last.wrench_C.torque.y(), -8.0);
  EXPECT_NEAR(last.wrench_C.force.x(), 1.234, 3 * 0.04);
}

TEST(SensorModel, FlagsSaturationFrom98PercentOfTheRange) {
  const auto flags_at = [](double fz_N) {
    SensorModel sensor(5);
    for (int n = 0; n < 500; ++n) sensor.step(normal_force(fz_N));
    return sensor.read().flags;
  };
  constexpr double kNoise_N = 0.5;  // six counts: the noise never reaches so far
  EXPECT_EQ(flags_at(294.0 - kNoise_N), 0);
  EXPECT_EQ(flags_at(294.0 + kNoise_N), bit(SampleFlag::saturated));
  EXPECT_EQ(flags_at(-294.0 - kNoise_N), bit(SampleFlag::saturated));
}

TEST(SensorModel, AnEmptySensorIsQuietToWithinOneCount) {
  SensorModel sensor(11);
  double sum = 0.0;
  double square_sum = 0.0;
  constexpr int kReadings = 4000;
  for (int n = 0; n < kReadings; ++n) {
    sensor.step({});
    const double fz = sensor.read().wrench_C.force.z();
    sum += fz;
    square_sum += fz * fz;
  }
  const double sd_N = std::sqrt(square_sum / kReadings);
  EXPECT_LT(std::abs(sum / kReadings), 0.004);
  EXPECT_GT(sd_N, 0.02);  // not suspiciously silent
  EXPECT_LT(sd_N, 0.08);  // below one count
}

TEST(SensorModel, SameSeedGivesTheSameReadingsAndAnotherStreamDoesNot) {
  SensorModel a(7, 0), b(7, 0), c(7, 1);
  int differing = 0;
  for (int n = 0; n < 200; ++n) {
    const Wrench wrench = normal_force(0.1 * n);
    a.step(wrench);
    b.step(wrench);
    c.step(wrench);
    const auto counts = a.read().raw_counts;
    EXPECT_EQ(counts, b.read().raw_counts);
    if (counts != c.read().raw_counts) ++differing;
  }
  EXPECT_GT(differing, 100);
}

TEST(SensorModel, NeverAllocates) {
  SensorModel sensor(1);
  const auto before = test::allocations();
  for (int n = 0; n < 100; ++n) {
    sensor.step(normal_force(2.0));
    (void)sensor.read();
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::sensor_model_test
