// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/jr3_session.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/candump_log.hpp"
#include "device/config/jr3_sensor.hpp"
#include "device/emulator/emulated_jr3.hpp"
#include "tests/device/conversation.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::test::jr3_session_test {
namespace {

using namespace std::chrono_literals;

BusFrame frame(const std::string& text) {
  return parse_candump_line("(1700000000.000000) can0 " + text).value()->frame;
}

DeviceConfig config_of() {
  DeviceConfig config = DeviceConfig::standard(kJr3Family);
  config.rate_Hz = 100.0;
  config.filter_Hz = 31.25;
  return config;
}

/// Three sensors; the force along z is the number of the sample in counts.
struct Jr3Bench : Conversation {
  explicit Jr3Bench(const EmulatedJr3Settings& settings = {}) {
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      auto of_finger = settings;
      of_finger.node = kJr3Nodes[f];
      // Each sensor numbers its frames for itself and at its own speed.
      of_finger.sensor_rate_Hz = f == 0 ? 8000.0 : f == 1 ? 3000.0 : 7999.0;
      of_finger.first_number = static_cast<std::uint16_t>(65'000 + 77 * f);
      add(std::make_unique<Jr3Session>(config_of(), f),
          std::make_unique<EmulatedJr3>(f, of_finger));
    }
    wrench = [](std::size_t finger, double t_s) {
      Wrench w;
      w.force.z() = std::fmod(std::round(t_s * 100.0), 16'000.0) * 300.0 / 16384.0;
      w.torque.x() = static_cast<double>(finger) * 8.0 / 16384.0;
      return w;
    };
  }
  /// Sets up; then all sessions wait, and counters and lists are empty.
  void set_up() {
    go = false;
    begin();
    run_for(400ms);
    for (auto& session : every(sessions)) {
      ASSERT_TRUE(session->ready());
      session->reset_counters();
    }
    asked.clear();
    go = true;
  }
  std::size_t count_of(std::size_t finger) const {
    return static_cast<std::size_t>(std::count_if(
        taken.begin(), taken.end(), [&](const Taken& t) { return t.finger == finger; }));
  }
  std::size_t syncs() const {
    return static_cast<std::size_t>(std::count(asked.begin(), asked.end(), jr3_sync()));
  }
};

TEST(Jr3Session, SetsTheSensorUpAndLetsTheFilterSettle) {
  Jr3Bench bench;
  bench.go = false;
  bench.begin();
  const Timestamp begin = bench.now;
  bench.run_for(100ms);
  EXPECT_FALSE(bench.sessions[0]->ready());
  bench.run_for(100ms);
  ASSERT_TRUE(bench.sessions[0]->ready());
  EXPECT_GE(bench.now - begin, 120ms);
  std::vector<BusFrame> to_index;
  for (const auto& f : bench.asked)
    if (jr3_owns(2, f)) to_index.push_back(f);
  const std::vector<std::string> expected{"282#", "402#", "482#", "502#", "182#350C"};
  ASSERT_EQ(to_index.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(to_index[i], frame(expected[i]));
  EXPECT_EQ(bench.syncs(), 0u) << "nobody has started";
  EXPECT_EQ(bench.sessions[1]->units_per_count()[2], 300.0 / 16384.0);
  EXPECT_EQ(bench.sessions[1]->stop_frame(), frame("282#"));
  EXPECT_DOUBLE_EQ(bench.sessions[1]->sensor_delay_s(), 1.0 / (2.0 * std::numbers::pi * 31.25));
  EXPECT_EQ(bench.sessions[1]->serial_number(), "");
}

TEST(Jr3Session, OneSynchronisationBringsOneSampleOfEachSensorInTheSameInstant) {
  Jr3Bench bench;
  bench.set_up();
  bench.run_for(60s);
  EXPECT_EQ(bench.syncs(), 6000u) << "the conductor sends for all";
  std::array<int, kFingerCount> next{};
  for (const auto& [finger, m] : every(bench.taken)) {
    ASSERT_EQ(m.raw_counts[2], next[finger]++);
    ASSERT_EQ(m.raw_counts[3], static_cast<int>(finger));
    ASSERT_EQ(m.wrench_S.force.z(), m.raw_counts[2] * 300.0 / 16384.0);
    ASSERT_TRUE(m.valid && m.numbered);
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_EQ(next[f], 6000);
    const auto counters = bench.sessions[f]->counters();
    EXPECT_EQ(counters.lost + counters.late + counters.torn + counters.duplicate, 0u) << f;
  }
}

TEST(Jr3Session, EveryLostHalfCostsOneSampleAndIsCountedOnce) {
  Jr3Bench bench;
  bench.set_up();
  std::mt19937_64 random(7);
  std::array<std::uint64_t, kFingerCount> lost{};
  std::array<std::uint64_t, kFingerCount> halves{};
  bench.lose = [&](const Conversation::Sent& sample) {
    // The first and last samples come, so that every gap has two ends.
    if (sample.number == 0 || sample.number == 4999 || random() % 10 != 0) return 0U;
    const auto frames = static_cast<unsigned>(1 + random() % 3);
    ++lost[sample.finger];
    halves[sample.finger] += frames == 3 ? 0 : 1;
    return frames;
  };
  bench.run_for(50s);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_GT(lost[f], 400u);
    EXPECT_EQ(bench.count_of(f), 5000 - lost[f]);
    EXPECT_EQ(bench.sessions[f]->counters().lost, lost[f]);
    // A half that waits is torn when four newer ones came: some still wait.
    EXPECT_LE(bench.sessions[f]->counters().torn, halves[f]);
    EXPECT_GE(bench.sessions[f]->counters().torn + 4, halves[f]);
    EXPECT_EQ(bench.sessions[f]->counters().restarts, 0u);
  }
}

TEST(Jr3Session, ADelayChangesNoValueAndNoOrder) {
  Jr3Bench bench;
  bench.set_up();
  std::mt19937_64 random(3);
  Timestamp held_until{0};
  bench.leave = [&](Timestamp when) {
    if (when > held_until + 100ms && random() % 50 == 0)
      held_until = when + std::chrono::milliseconds(3 + random() % 58);
    return std::max(when, held_until);
  };
  bench.run_for(60s);
  bench.run_for(100ms);
  std::array<int, kFingerCount> next{};
  for (const auto& [finger, m] : every(bench.taken)) ASSERT_EQ(m.raw_counts[2], next[finger]++);
  EXPECT_GE(next[0], 6000);
}

TEST(Jr3Session, AnOlderNumberIsLateAndDropped) {
  Jr3Bench bench;
  bench.set_up();
  bench.mute = true;
  bench.run_for(1ms);
  Measurement out;
  const auto take = [&](std::uint16_t number) {
    Jr3Reading reading;
    reading.number = number;
    const auto frames = jr3_reading_frames(1, reading);
    EXPECT_FALSE(bench.sessions[0]->take(frames[0], bench.now, out));
    return bench.sessions[0]->take(frames[1], bench.now, out);
  };
  EXPECT_TRUE(take(65'534));
  EXPECT_TRUE(take(100)) << "the number wraps";
  EXPECT_FALSE(take(20));
  EXPECT_FALSE(take(65'533));
  EXPECT_TRUE(take(101));
  EXPECT_EQ(bench.sessions[0]->counters().late, 2u);
}

TEST(Jr3Session, ASensorWhoseNumberStandsStillMeasuresNothingNew) {
  Jr3Bench bench;
  bench.set_up();
  bench.mute = true;
  bench.run_for(1ms);
  Measurement out;
  Jr3Reading reading;
  reading.number = 7;
  const auto frames = jr3_reading_frames(1, reading);
  for (int k = 0; k < 20; ++k) {
    EXPECT_FALSE(bench.sessions[0]->take(frames[0], bench.now + k * 10ms, out));
    EXPECT_TRUE(bench.sessions[0]->take(frames[1], bench.now + k * 10ms, out));
    EXPECT_EQ(out.numbered, k == 0);
  }
  EXPECT_EQ(bench.sessions[0]->counters().duplicate, 0u);
}

TEST(Jr3Session, ABootUpIsARestartAndTheConductorGoesOn) {
  for (std::size_t dipped = 0; dipped < kFingerCount; ++dipped) {
    Jr3Bench bench;
    bench.set_up();
    bench.run_for(1s + 3ms);
    bench.sensors[dipped]->power_dip(bench.now, bench);
    bench.run_for(1s - 3ms);
    EXPECT_EQ(bench.syncs(), 200u) << "no gap in the synchronisation";
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      EXPECT_TRUE(bench.sessions[f]->streaming());
      const auto counters = bench.sessions[f]->counters();
      EXPECT_EQ(counters.restarts, f == dipped ? 1u : 0u);
      EXPECT_EQ(bench.count_of(f) + counters.lost, 200u);
      if (f == dipped) {
        EXPECT_LT(counters.lost, 20u);
      } else {
        EXPECT_EQ(counters.lost, 0u) << "the others feel nothing";
      }
    }
  }
}

TEST(Jr3Session, ASilentPowerDipIsFoundBySilence) {
  Jr3Bench bench;
  bench.set_up();
  bench.run_for(1s + 3ms);
  bench.mute = true;
  for (auto& sensor : bench.sensors) sensor->power_dip(bench.now, bench);  // nobody hears it
  bench.mute = false;
  bench.run_for(1s);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_TRUE(bench.sessions[f]->streaming());
    EXPECT_EQ(bench.sessions[f]->counters().restarts, 1u);
    EXPECT_GT(bench.count_of(f), 150u);
  }
}

TEST(Jr3Session, ASensorThatIsNotInitialisedIsRefusedAfterThreeAnswers) {
  EmulatedJr3Settings settings;
  settings.initialised = false;
  Jr3Bench bench(settings);
  bench.begin();
  bench.run_for(100ms);
  EXPECT_EQ(bench.sessions[0]->failure(), SensorSession::Failure::none);
  bench.run_for(300ms);
  EXPECT_EQ(bench.sessions[0]->failure(), SensorSession::Failure::refused);
  const auto message = bench.sessions[0]->error("thumb", "can0").message();
  EXPECT_NE(message.find("not initialised"), std::string::npos) << message;
  EXPECT_NE(message.find("node 1"), std::string::npos) << message;
}

TEST(Jr3Session, RefusesFullScalesOfZero) {
  EmulatedJr3Settings settings;
  settings.calibration.force_N[1] = 0;
  Jr3Bench bench(settings);
  bench.begin();
  bench.run_for(100ms);
  EXPECT_EQ(bench.sessions[2]->failure(), SensorSession::Failure::wrong_calibration);
}

TEST(Jr3Session, AClippedAxisIsSaturatedAndInvalid) {
  Jr3Bench bench;
  bench.wrench = [](std::size_t finger, double) {
    Wrench w;
    w.force.x() = finger == 1 ? 301.0 : 299.0;  // the numbers end at twice the full scale
    return w;
  };
  bench.set_up();
  bench.run_for(100ms);
  ASSERT_FALSE(bench.taken.empty());
  for (const auto& [finger, m] : every(bench.taken)) {
    EXPECT_EQ(m.saturated, finger == 1);
    EXPECT_EQ(m.valid, finger != 1);
  }
}

TEST(Jr3Session, CountsFramesOfStrangers) {
  Jr3Bench bench;
  bench.set_up();
  bench.to_host(frame("601#00"));
  bench.to_host(frame("00000601#0000000000000100"));
  bench.to_host(frame("281#"));  // somebody else commands the sensor
  EXPECT_EQ(bench.sessions[0]->counters().foreign, 3u);
}

TEST(Jr3Emulator, ItsLowPassFollowsTheStepOfAFirstOrderFilter) {
  Jr3Bench bench;
  bench.low_pass = true;
  constexpr double kStep_N = 100.0;
  bench.wrench = [](std::size_t, double t_s) {
    Wrench w;
    w.force.z() = t_s > 0.0 ? kStep_N : 0.0;
    return w;
  };
  bench.set_up();
  bench.run_for(100ms);
  int k = 0;
  for (const auto& [finger, m] : every(bench.taken)) {
    if (finger != 0) continue;
    const double t_s = 0.01 * k++;
    const double expected = kStep_N * (1.0 - std::exp(-2.0 * std::numbers::pi * 31.25 * t_s));
    EXPECT_WITHIN(m.wrench_S.force.z(), expected, 0.51 * 300.0 / 16384.0) << "half a count";
  }
  EXPECT_EQ(k, 10);
}

TEST(Jr3Emulator, ForgetsItsZeroAndItsNumberWhenThePowerDips) {
  Jr3Bench bench;
  bench.wrench = [](std::size_t, double) {
    Wrench w;
    w.force.z() = -30.0;
    return w;
  };
  bench.set_up();
  bench.run_for(50ms);
  const auto loaded = bench.taken.back().measurement.raw_counts[2];
  EXPECT_EQ(loaded, std::lround(-30.0 * 16384.0 / 300.0));
  for (const std::uint8_t node : kJr3Nodes)
    bench.put_on_bus(jr3_request(node, Jr3Opcode::zero_offsets));
  bench.run_for(50ms);
  EXPECT_EQ(bench.taken.back().measurement.raw_counts[2], 0);
  for (auto& sensor : bench.sensors) sensor->power_dip(bench.now, bench);
  bench.run_for(500ms);
  EXPECT_EQ(bench.taken.back().measurement.raw_counts[2], loaded);
}

TEST(Jr3Emulator, RunsOnItsOwnClockWhenItIsStartedThatWay) {
  Jr3Bench bench;
  bench.put_on_bus(jr3_start_async(1, 0, 2500));
  EXPECT_EQ(bench.sensors[0]->next_measurement(), bench.now);
  bench.run_for(1s - 1ms);
  EXPECT_EQ(bench.sent.size(), 400u);
  bench.put_on_bus(jr3_request(1, Jr3Opcode::stop));
  EXPECT_EQ(bench.sensors[0]->next_measurement(), Timestamp::max());
}

TEST(Jr3Session, StreamsWithoutAllocation) {
  Jr3Bench bench;
  bench.set_up();
  bench.mute = true;
  bench.run_for(1ms);
  SensorSession& session = *bench.sessions[0];
  const auto before = allocations();
  Timestamp t = bench.now;
  std::size_t measured = 0;
  Measurement out;
  for (int k = 0; k < 1000; ++k) {
    t += 10ms;
    while (session.poll(t)) {
    }
    Jr3Reading reading;
    reading.number = static_cast<std::uint16_t>(65'100 + 80 * k);
    const auto frames = jr3_reading_frames(1, reading);
    (void)session.take(frames[0], t + 1ms, out);
    measured += session.take(frames[1], t + 1ms, out) ? 1 : 0;
  }
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(measured, 1000u);
}

}  // namespace
}  // namespace isograsp::test::jr3_session_test
