// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/frame_clock.hpp"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::frame_clock_test {
namespace {

constexpr Timestamp kStart{5'000'000'000};

/// A wrench that is a straight line in time, with another slope on every axis.
Wrench ramp(Finger finger, Timestamp t) {
  const double t_s = to_seconds(t - kStart);
  const double base = 1.0 + static_cast<double>(index_of(finger));
  return {Vec3(base, -2.0, 3.0) * t_s + Vec3(0.5, base, 0.0),
          Vec3(0.1, -0.2, 0.3 * base) * t_s + Vec3(0.0, 0.0, 0.01)};
}

SensorSample sample_at(Finger finger, Timestamp t, bool valid = true, std::uint8_t flags = 0) {
  SensorSample sample;
  sample.finger = finger;
  sample.stamp = t;
  sample.wrench_C = ramp(finger, t);
  sample.raw_counts = {static_cast<std::int32_t>((t - kStart).count() / 1000), 0, 0, 0, 0, 0};
  sample.valid = valid;
  sample.flags = flags;
  return sample;
}

/// Samples of three sensors in the order of their stamps.
std::vector<SensorSample> in_order(std::vector<SensorSample> samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const auto& a, const auto& b) { return a.stamp < b.stamp; });
  return samples;
}

std::vector<FingerFrame> run(FrameClock& clock, const std::vector<SensorSample>& samples) {
  std::vector<FingerFrame> frames;
  FingerFrame frame;
  for (const auto& sample : samples) {
    clock.push(sample);
    while (clock.pop(sample.stamp, frame)) frames.push_back(frame);
  }
  return frames;
}

bool missing(const FingerFrame& frame, Finger finger) {
  return (frame.flags[index_of(finger)] & bit(SampleFlag::missing)) != 0;
}

std::vector<SensorSample> drifting(double period_s, double duration_s) {
  std::vector<SensorSample> samples;
  for (const Finger finger : kFingers) {
    const auto f = static_cast<double>(index_of(finger));
    const double own_period_s = period_s * (1.0 + 200e-6 * (f - 1.0));
    for (double t_s = period_s * 0.31 * f; t_s < duration_s; t_s += own_period_s)
      samples.push_back(sample_at(finger, kStart + from_seconds(t_s)));
  }
  return in_order(std::move(samples));
}

TEST(FrameClock, ReproducesARampSeenByThreeDriftingClocksToRounding) {
  // Stamps are whole nanoseconds; values up to 200: rounding of a few hundred ulp.
  constexpr double kRounding = 1e-12;
  for (const double period_s : {0.010, 0.003, 0.001, 0.020}) {
    FrameClock clock(0.010, period_s, false, kStart);
    const auto frames = run(clock, drifting(period_s, 60.0));
    ASSERT_GT(frames.size(), 5990u);
    for (const auto& frame : test::every(frames)) {
      if (frame.t_s < period_s) continue;  // no sample before the first slots
      for (const Finger finger : kFingers) {
        ASSERT_FALSE(missing(frame, finger)) << period_s << ' ' << frame.slot;
        const Wrench expected = ramp(finger, kStart + from_seconds(frame.t_s));
        const Wrench& got = frame.wrench_C[index_of(finger)];
        ASSERT_LE((got.force - expected.force).norm(), kRounding * (1 + expected.force.norm()));
        ASSERT_LE((got.torque - expected.torque).norm(), kRounding * (1 + expected.torque.norm()));
      }
    }
  }
}

TEST(FrameClock, ClosesEverySlotOnceAndInOrderWhateverIsLost) {
  std::mt19937_64 random(1);
  auto samples = drifting(0.010, 20.0);
  std::erase_if(samples, [&](const auto&) { return random() % 3 == 0; });
  FrameClock clock(0.010, 0.010, false, kStart);
  const auto frames = run(clock, samples);
  ASSERT_GT(frames.size(), 1990u);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    EXPECT_EQ(frames[k].slot, static_cast<std::int64_t>(k));
    EXPECT_EQ(frames[k].t_s, static_cast<double>(k) / 100.0);
  }
}

TEST(FrameClock, BridgesOneLostSampleAndInventsNothingAcrossTwo) {
  std::vector<SensorSample> samples;
  for (const Finger finger : kFingers)
    for (int k = 0; k < 20; ++k) {
      const bool lost = finger == Finger::index && (k == 5 || k == 10 || k == 11);
      if (!lost) samples.push_back(sample_at(finger, kStart + from_seconds(0.003 + 0.010 * k)));
    }
  FrameClock clock(0.010, 0.010, false, kStart);
  const auto frames = run(clock, in_order(samples));
  ASSERT_GE(frames.size(), 18u);
  test::AtLeast in_the_gap(3);
  for (const auto& frame : test::every(frames)) {
    // Slots between samples 9 and 12: 100, 110, 120 ms.
    const bool in_gap = frame.slot >= 10 && frame.slot <= 12;
    EXPECT_EQ(missing(frame, Finger::index), in_gap || frame.slot == 0) << frame.slot;
    EXPECT_EQ(missing(frame, Finger::thumb), frame.slot == 0) << frame.slot;
    if (missing(frame, Finger::index)) {
      EXPECT_EQ(frame.wrench_C[1].force, Vec3::Zero());
      ++in_the_gap;
    }
  }
}

TEST(FrameClock, IgnoresInvalidSamplesOfFreeRunningSensors) {
  FrameClock clock(0.010, 0.010, false, kStart);
  for (const Finger finger : kFingers) {
    clock.push(sample_at(finger, kStart));
    clock.push(sample_at(finger, kStart + from_seconds(0.010), finger != Finger::middle));
    clock.push(sample_at(finger, kStart + from_seconds(0.020)));
  }
  FingerFrame frame;
  ASSERT_TRUE(clock.pop(kStart, frame));
  ASSERT_TRUE(clock.pop(kStart, frame));
  EXPECT_FALSE(missing(frame, Finger::middle));  // its neighbours are two periods apart
  EXPECT_WITHIN(frame.wrench_C[2].force.x(),
                ramp(Finger::middle, kStart + from_seconds(0.010)).force.x(), 1e-12);
}

TEST(FrameClock, WaitsForItsDeadlineAndNoLonger) {
  FrameClock clock(0.010, 0.010, false, kStart);
  EXPECT_EQ(clock.deadline(), kStart + from_seconds(0.020));
  EXPECT_EQ(FrameClock(0.010, 0.002, false, kStart).deadline(), kStart + from_seconds(0.010));
  EXPECT_EQ(FrameClock(0.010, 0.010, true, kStart).deadline(), kStart + from_seconds(0.010));
  FingerFrame frame;
  EXPECT_FALSE(clock.pop(kStart + from_seconds(0.0199), frame));
  EXPECT_TRUE(clock.pop(kStart + from_seconds(0.020), frame));
  for (const Finger finger : kFingers) EXPECT_TRUE(missing(frame, finger));
  EXPECT_EQ(clock.late(), 0u);
  clock.push(sample_at(Finger::thumb, kStart));  // its slot is closed
  EXPECT_EQ(clock.late(), 1u);
}

TEST(FrameClock, TakesTheNearerCountsAndAllFlags) {
  FrameClock clock(0.010, 0.010, false, kStart);
  const auto overload = bit(SampleFlag::overload);
  for (const Finger finger : kFingers) {
    clock.push(sample_at(finger, kStart + from_seconds(0.002)));
    clock.push(sample_at(finger, kStart + from_seconds(0.012), true, overload));
  }
  FingerFrame frame;
  ASSERT_TRUE(clock.pop(kStart, frame));
  ASSERT_TRUE(clock.pop(kStart, frame));
  EXPECT_EQ(frame.raw_counts[0][0], 12'000);  // 2 ms away, the other is 8 ms away
  EXPECT_EQ(frame.flags[0], overload);
}

TEST(FrameClock, OnTheGridTakesExactlyTheSampleOfTheSlotAtOnce) {
  FrameClock clock(0.010, 0.010, true, kStart);
  FingerFrame frame;
  for (int k = 0; k < 500; ++k) {
    const Timestamp t = kStart + from_seconds(k * 0.010);
    for (const Finger finger : kFingers) {
      EXPECT_FALSE(clock.pop(t, frame));
      clock.push(sample_at(finger, t, !(finger == Finger::index && k % 7 == 3)));
    }
    ASSERT_TRUE(clock.pop(t, frame));  // all arrived: no waiting, also not for the invalid one
    EXPECT_EQ(frame.slot, k);
    EXPECT_EQ(missing(frame, Finger::index), k % 7 == 3);
    EXPECT_EQ(frame.wrench_C[0].force, ramp(Finger::thumb, t).force);  // the very same bits
    EXPECT_FALSE(clock.pop(t, frame));
  }
}

TEST(FrameClock, OnTheGridNeverInterpolates) {
  FrameClock clock(0.010, 0.010, true, kStart);
  for (const Finger finger : kFingers) {
    clock.push(sample_at(finger, kStart));
    if (finger != Finger::thumb) clock.push(sample_at(finger, kStart + from_seconds(0.010)));
    clock.push(sample_at(finger, kStart + from_seconds(0.020)));
  }
  FingerFrame frame;
  ASSERT_TRUE(clock.pop(kStart, frame));
  ASSERT_TRUE(clock.pop(kStart, frame));
  EXPECT_TRUE(missing(frame, Finger::thumb));
  EXPECT_FALSE(missing(frame, Finger::index));
  ASSERT_TRUE(clock.pop(kStart, frame));
  EXPECT_FALSE(missing(frame, Finger::thumb));
  EXPECT_FALSE(clock.pop(kStart, frame));
}

TEST(FrameClock, AllocatesNothing) {
  FrameClock clock(0.010, 0.003, false, kStart);
  const auto samples = drifting(0.003, 5.0);
  FingerFrame frame;
  std::int64_t frames = 0;
  const auto before = test::allocations();
  for (const auto& sample : samples) {
    clock.push(sample);
    while (clock.pop(sample.stamp, frame)) ++frames;
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(frames, 490);
}

}  // namespace
}  // namespace isograsp::frame_clock_test
