// SPDX-License-Identifier: GPL-3.0-or-later
// Long hours in virtual time with faults by chance: what the driver counts is what the emulated
// sensors did, nothing piles up, and no state sticks.
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/device/families.hpp"
#include "tests/device/sensor_bench.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::soak_test {
namespace {

using namespace std::chrono_literals;

EmulatorOptions with_faults(const FamilyFacts& family, std::initializer_list<const char*> faults,
                            std::uint64_t seed) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(family);
  options.seed = seed;
  constexpr int kSensorNoise = 3;
  options.noise_counts = kSensorNoise;
  for (const char* text : faults) options.faults.push_back(Fault::parse(text).value());
  return options;
}

FingerPlay constant_play() {
  FingerPlay play;
  play.t_s = {0.0};
  FingerWrenches wrenches{};
  for (auto& wrench : wrenches) wrench.force = Vec3(0.5, -0.5, 6.0);
  play.wrench_C = {wrenches};
  return play;
}

struct Taken {
  std::array<std::uint64_t, kFingerCount> samples{};
  std::array<std::uint64_t, kFingerCount> valid{};
  double worst_N = 0.0;  ///< of a valid sample from the force that was played
};

/// Reads on; what the wire holds at the end is read too.
Taken read_for(test::SensorBench& bench, Timestamp duration) {
  Taken taken;
  const Timestamp end = bench.clock.now() + duration;
  const Vec3 played_N(0.5, -0.5, 6.0);
  SensorSample sample;
  while (bench.device->read(end, sample) == ReadStatus::sample) {
    const auto f = index_of(sample.finger);
    ++taken.samples[f];
    if (!sample.valid) continue;
    ++taken.valid[f];
    taken.worst_N =
        std::max(taken.worst_N, (sample.wrench_C.force - played_N).cwiseAbs().maxCoeff());
  }
  return taken;
}

class Soak : public ::testing::TestWithParam<const FamilyFacts*> {};

TEST_P(Soak, WhatIsCountedIsWhatHappened) {
  const FamilyFacts& family = *GetParam();
  test::SensorBench bench(
      with_faults(
          family,
          {"lose=thumb:all:0.002", "lose=index:tx1:0.002", "lose=middle:tx2:0.002",
           "duplicate=all:0.002", "foreign=all:0.002", "length=index:0.001", "answer=all:0.002"},
          11),
      DeviceConfig::standard(family), constant_play());
  bench.bus->log_sent = false;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto emulated_before = bench.bus->emulator().counters();
  const auto allocations = test::allocations();
  const Taken taken = read_for(bench, 1h);
  EXPECT_EQ(test::allocations(), allocations);
  const DeviceHealth health = bench.device->health();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const EmulatorCounters& now = bench.bus->emulator().counters()[f];
    const EmulatorCounters& before = emulated_before[f];
    const SensorCounters& counted = health.sensors[f];
    EXPECT_EQ(counted.good + counted.invalid, taken.samples[f]);
    const std::uint64_t arrived = now.samples - before.samples - (now.broken - before.broken);
    EXPECT_GT(now.broken, before.broken);
    // What is on its way when the reading begins and ends.
    constexpr std::uint64_t kUnderWay = 2;
    EXPECT_NEAR(static_cast<double>(taken.samples[f]), static_cast<double>(arrived), kUnderWay);
    EXPECT_NEAR(static_cast<double>(counted.lost), static_cast<double>(now.broken - before.broken),
                kUnderWay);
    EXPECT_EQ(counted.restarts, 0u);
    EXPECT_EQ(counted.stale, 0u);
  }
  // Three counts of noise; through the matrix of an ATI sensor three counts of six gages.
  constexpr double kNoise_N = 0.25;
  EXPECT_LT(taken.worst_N, kNoise_N);
}

TEST_P(Soak, NoStateSticks) {
  const FamilyFacts& family = *GetParam();
  std::vector<std::string> texts;
  constexpr double kEvery_s = 7.0;
  const Timestamp whole = std::getenv("ISOGRASP_LONG") != nullptr ? 1h : 10min;
  const double total_s = to_seconds(whole);
  const std::array<const char*, 3> kFingersInTurn{"thumb", "index", "middle"};
  int number = 0;
  for (double at_s = 3.0; at_s + kEvery_s < total_s; at_s += kEvery_s, ++number) {
    const std::string finger = kFingersInTurn[static_cast<std::size_t>(number % 3)];
    const std::string at = "@" + std::to_string(at_s) + "s";
    switch (number % 4) {
      case 0: texts.push_back("dip=" + finger + at); break;
      case 1: texts.push_back("silence=" + finger + ":1.5s" + at); break;
      case 2: texts.push_back("freeze=" + finger + ":1.2s" + at); break;
      default: texts.push_back("burst=" + finger + ":300" + at); break;
    }
  }
  EmulatorOptions options = with_faults(family, {}, 12);
  for (const auto& text : texts) options.faults.push_back(Fault::parse(text).value());
  test::SensorBench bench(options, DeviceConfig::standard(family), constant_play());
  bench.bus->log_sent = false;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  Timestamp faulted_since = Timestamp::max();
  std::uint64_t faults_told = 0;
  const Timestamp end = bench.clock.now() + whole;
  while (bench.clock.now() < end) {
    (void)read_for(bench, 100ms);
    const DeviceHealth health = bench.device->health();
    if (health.state != DeviceState::faulted) {
      faulted_since = Timestamp::max();
      continue;
    }
    if (faulted_since == Timestamp::max()) {
      faulted_since = bench.clock.now();
      ++faults_told;
      EXPECT_TRUE(health.finger.has_value());
    }
    // The longest fault lasts 1.5 s; a second after its end the sensor is back.
    ASSERT_LT(bench.clock.now() - faulted_since, 2600ms)
        << name_of(health.fault) << " at " << to_seconds(bench.clock.now()) << " s";
  }
  // Every silence and every frozen sensor is told; a short power dip may pass unseen where the next
  // question sets the sensor right again.
  EXPECT_GE(faults_told, texts.size() / 4);
}

INSTANTIATE_TEST_SUITE_P(Protocols, Soak, ::testing::ValuesIn(test::emulated_families()),
                         test::name_of_family);

}  // namespace
}  // namespace isograsp::soak_test
