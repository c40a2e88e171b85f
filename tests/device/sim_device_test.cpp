// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/simulated/sim_device.hpp"

#include <gtest/gtest.h>

#include "device/sensors/frame_clock.hpp"
#include "device/simulated/sensor_model.hpp"
#include "tests/device/scripted_source.hpp"
#include "tests/support/within.hpp"

namespace isograsp::sim_device_test {
namespace {

using test::ScriptedSource;

constexpr Timestamp kForever = std::chrono::hours{1};

std::unique_ptr<ForceDevice> opened(const std::string& text, FingerSource& source) {
  const auto uri = Uri::parse(text);
  EXPECT_TRUE(uri);
  auto device = open_sim_device(*uri, {&source, nullptr});
  EXPECT_TRUE(device) << device.error().message();
  return std::move(*device);
}

std::string refusal(const std::string& text, FingerSource* source) {
  const auto uri = Uri::parse(text);
  EXPECT_TRUE(uri) << text;
  const auto device = open_sim_device(*uri, {source, nullptr});
  return device ? "accepted" : device.error().message();
}

TEST(SimDevice, NamesWhatIsWrongWithItsUri) {
  ScriptedSource source;
  EXPECT_NE(refusal("sim://healthy", nullptr).find("nobody presses"), std::string::npos);
  EXPECT_NE(refusal("sim://?seed=7", &source).find("no patient is named"), std::string::npos);
  EXPECT_NE(refusal("sim://healthy?seed=1.5", &source).find("seed: is not a whole number"),
            std::string::npos);
  EXPECT_NE(refusal("sim://healthy?seed=-1", &source).find("seed:"), std::string::npos);
  EXPECT_NE(refusal("sim://healthy?hand=both", &source).find("hand: 'both' is not a hand"),
            std::string::npos);
  EXPECT_NE(refusal("sim://healthy?rate=10", &source).find("rate:"), std::string::npos);
  EXPECT_NE(refusal("sim://healthy?drop=2", &source).find("drop:"), std::string::npos);
  EXPECT_NE(refusal("sim://healthy?sed=7", &source).find("sed:"), std::string::npos);
  EXPECT_EQ(refusal("sim://healthy?seed=7&hand=left&rate=200&drop=0.1", &source), "accepted");
}

TEST(SimDevice, StampsLieExactlyOnTheGrid) {
  for (const int rate_Hz : {50, 100, 120, 1000}) {
    ScriptedSource source;
    ManualClock clock;
    clock.wait_until(Timestamp{123456789});
    auto device = opened("sim://healthy?rate=" + std::to_string(rate_Hz), source);
    ASSERT_TRUE(device->start(clock));
    SensorSample sample;
    for (int k = 0; k < 3 * rate_Hz; ++k)
      for (const Finger finger : kFingers) {
        ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
        EXPECT_EQ(sample.finger, finger);
        EXPECT_EQ(sample.stamp.count(), 123456789 + std::llround(k * (1.0 / rate_Hz) * 1e9));
      }
    EXPECT_TRUE(device->info().on_grid);
    EXPECT_EQ(device->info().frame_period_s, 1.0 / rate_Hz);
  }
}

TEST(SimDevice, PressesAtOneKilohertzAndNeverAheadOfTheSampleBeingRead) {
  ScriptedSource source;
  ManualClock clock;
  auto device = opened("sim://healthy", source);
  ASSERT_TRUE(device->start(clock));
  SensorSample sample;
  for (int k = 0; k < 200; ++k)
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
      EXPECT_DOUBLE_EQ(source.latest_s, 0.01 * k);
      EXPECT_EQ(source.presses, 10 * k + 1);
    }
  EXPECT_FALSE(source.went_back);
}

TEST(SimDevice, MeasuresWhatThePatientPressedThirtyTwoMillisecondsAgo) {
  ScriptedSource source;
  ManualClock clock;
  auto device = opened("sim://healthy?rate=1000", source);
  ASSERT_TRUE(device->start(clock));
  SensorSample sample;
  constexpr double kNoise_N = 3.0 * 0.08;  // three counts: noise of at most 2.4 and rounding
  constexpr double kSettled_s = 0.2;
  ScriptedSource same;
  for (int k = 0; k < 3000; ++k) {
    ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
    const double t_s = to_seconds(sample.stamp) - kSensorDelay_s;
    if (sample.finger != Finger::index || t_s < kSettled_s) continue;
    EXPECT_NEAR(sample.wrench_C.force.z(), same.press(t_s)[1].force.z(), kNoise_N);
  }
}

TEST(SimDevice, DropsTheStatedShareOfSamplesAndCountsThem) {
  ScriptedSource source;
  ManualClock clock;
  auto device = opened("sim://healthy?drop=0.2&seed=3", source);
  ASSERT_TRUE(device->start(clock));
  SensorSample sample;
  int invalid = 0;
  constexpr int kSamples = 3 * 2000;
  for (int k = 0; k < kSamples; ++k) {
    ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
    if (!sample.valid) ++invalid;
  }
  // Binomial: SD 31; five of them.
  EXPECT_NEAR(invalid, 0.2 * kSamples, 155);
  std::uint64_t counted = 0;
  for (const auto& sensor : device->health().sensors) counted += sensor.invalid;
  EXPECT_EQ(counted, static_cast<std::uint64_t>(invalid));
}

TEST(SimDevice, AFinerResolutionMakesStepsAndNoiseFinerAlike) {
  const auto spread_N = [](const std::string& uri) {
    ScriptedSource source;
    source.scale = 0.0;
    ManualClock clock;
    auto device = opened(uri, source);
    EXPECT_TRUE(device->start(clock));
    const Vec6 step = device->info().units_per_count[0];
    double squares = 0.0;
    constexpr int kSamples = 3 * 2000;
    SensorSample sample;
    for (int k = 0; k < kSamples; ++k) {
      EXPECT_EQ(device->read(kForever, sample), ReadStatus::sample);
      EXPECT_EQ(sample.wrench_C.force.z(), sample.raw_counts[2] * step[2]);
      squares += std::pow(sample.wrench_C.force.z(), 2);
    }
    return std::sqrt(squares / kSamples);
  };
  const double usual_N = spread_N("sim://healthy");
  EXPECT_GT(usual_N, 0.02);
  // The same random numbers: the same counts.
  EXPECT_WITHIN(spread_N("sim://healthy?resolution=0.008"), 0.1 * usual_N, 1e-12);
}

TEST(SimDevice, SaturationIsFlaggedAndCounted) {
  ScriptedSource source;
  source.scale = 200.0;
  ManualClock clock;
  auto device = opened("sim://healthy", source);
  ASSERT_TRUE(device->start(clock));
  SensorSample sample;
  for (int k = 0; k < 3 * 20; ++k) ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
  EXPECT_EQ(sample.flags, bit(SampleFlag::saturated));
  EXPECT_EQ(sample.wrench_C.force.z(), 300.0);
  EXPECT_GT(device->health().sensors[2].saturated, 10U);
}

TEST(SimDevice, EveryFrameOfTheFrameClockHoldsItsSample) {
  ScriptedSource source;
  ManualClock clock;
  auto device = opened("sim://healthy", source);
  ASSERT_TRUE(device->start(clock));
  const auto& info = device->info();
  FrameClock frames(info.frame_period_s, info.sample_period_s, info.on_grid, clock.now());
  SensorSample sample;
  FingerFrame frame;
  for (int k = 0; k < 500; ++k) {
    FingerWrenches sent;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      ASSERT_EQ(device->read(kForever, sample), ReadStatus::sample);
      sent[f] = sample.wrench_C;
      frames.push(sample);
    }
    ASSERT_TRUE(frames.pop(device->now(clock), frame));
    EXPECT_EQ(frame.slot, k);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      EXPECT_EQ(frame.wrench_C[f].force, sent[f].force);
      EXPECT_EQ(frame.flags[f], 0);
    }
  }
}

}  // namespace
}  // namespace isograsp::sim_device_test
