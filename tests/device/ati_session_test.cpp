// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/ati_session.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/candump_log.hpp"
#include "device/config/ati_sensor.hpp"
#include "device/emulator/emulated_ati.hpp"
#include "tests/device/conversation.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::test::ati_session_test {
namespace {

using namespace std::chrono_literals;

constexpr double kRate_Hz = 100.0;

BusFrame frame(const std::string& text) {
  return parse_candump_line("(1700000000.000000) can0 " + text).value()->frame;
}

DeviceConfig config_of(std::uint8_t slot = 0, double rate_Hz = kRate_Hz) {
  DeviceConfig config = DeviceConfig::standard(kAtiFamily);
  config.rate_Hz = rate_Hz;
  config.sensors[0].connection = AtiSensor{0x20, slot};
  return config;
}

/// One sensor that feels a force that tells the time.
struct AtiBench : Conversation {
  explicit AtiBench(const DeviceConfig& config = config_of(), EmulatedAtiSettings settings = {}) {
    auto owned = std::make_unique<AtiSession>(config, 0);
    session = owned.get();
    calibration = settings.calibration;
    add(std::move(owned), std::make_unique<EmulatedAti>(0, settings));
    wrench = [](std::size_t, double t_s) {
      const double slot = std::fmod(std::round(t_s * 100.0), 997.0);
      Wrench w;
      w.force = {5.0, -3.0, -50.0 + 0.1 * slot};  // 1.6 counts of three gages per sample
      w.torque = {0.05, -0.1, 0.02};
      return w;
    };
  }
  /// Sets up; then a session waits, and counters and lists are empty.
  void set_up() {
    go = false;
    begin();
    run_for(100ms);
    ASSERT_TRUE(session->ready());
    session->reset_counters();
    sent.clear();
    asked.clear();
    go = true;
  }
  AtiReading reading_of(const Sent& sample) const {
    AtiPairing pairing;
    (void)pairing.push(sample.frames[0], 1s);
    return pairing.push(sample.frames[1], 1s)->reading;
  }
  std::size_t polls() const {
    return static_cast<std::size_t>(
        std::count(asked.begin(), asked.end(), ati_request(0x20, AtiOpcode::gages)));
  }

  AtiSession* session = nullptr;
  AtiCalibration calibration;
};

TEST(AtiSession, SetsTheSensorUpInTheOrderOfTheManual) {
  AtiBench bench;
  bench.go = false;
  bench.begin();
  bench.run_for(100ms);
  ASSERT_TRUE(bench.session->ready());
  const std::vector<std::string> expected{"206#00", "205#",   "20F#",   "202#00",
                                          "202#01", "202#02", "202#03", "202#04",
                                          "202#05", "207#",   "208#",   "200#"};
  ASSERT_EQ(bench.asked.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(bench.asked[i], frame(expected[i])) << i;
  EXPECT_EQ(bench.session->serial_number(), "FT00001");
  EXPECT_EQ(bench.session->calibration(), synthetic_ati_calibration());
  EXPECT_EQ(bench.session->firmware(), (AtiFirmware{3, 8, 2}));
  EXPECT_EQ(bench.session->units_per_count(), Vec6::Zero().eval());
  EXPECT_TRUE(bench.taken.empty());
}

TEST(AtiSession, EverySampleArrivesInOrderWithItsValue) {
  EmulatedAtiSettings settings;
  settings.bias = {112, -87, 45, 301, -260, 19};
  settings.calibration.units = {1, 1};
  settings.calibration.counts = {400'000, 700'000};
  AtiBench bench(config_of(), settings);
  bench.set_up();
  bench.run_for(60s);
  ASSERT_EQ(bench.polls(), 6000u);
  ASSERT_EQ(bench.taken.size(), 6000u);
  for (std::size_t k = 0; k < bench.taken.size(); ++k) {
    const auto& m = bench.taken[k].measurement;
    const auto reading = bench.reading_of(bench.sent[k]);
    ASSERT_EQ(m.raw_counts, reading.gages);
    const Wrench expected = wrench_of(reading.gages, Vec6::Zero(), settings.calibration);
    ASSERT_EQ(m.wrench_S.force, expected.force);
    ASSERT_EQ(m.wrench_S.torque, expected.torque);
    ASSERT_TRUE(m.valid);
    ASSERT_EQ(bench.sent[k].when, bench.sent[0].when + static_cast<int>(k) * 10ms) << "grid";
  }
  const auto counters = bench.session->counters();
  EXPECT_EQ(counters.lost + counters.late + counters.torn + counters.duplicate, 0u);
}

TEST(AtiSession, EveryLostAnswerCostsOneSampleAndIsCountedOnce) {
  AtiBench bench;
  bench.set_up();
  std::mt19937_64 random(11);
  std::uint64_t lost = 0;
  std::uint64_t first_only = 0;
  std::uint64_t second_only = 0;
  std::vector<RawCounts> complete;
  bench.lose = [&](const Conversation::Sent& sample) {
    const unsigned frames = random() % 20 == 0 ? static_cast<unsigned>(1 + random() % 3) : 0U;
    lost += frames != 0 ? 1 : 0;
    first_only += frames == 1 ? 1 : 0;
    second_only += frames == 2 ? 1 : 0;
    if (frames == 0) complete.push_back(bench.reading_of(sample).gages);
    return frames;
  };
  bench.run_for(100s);
  ASSERT_GT(lost, 400u);
  EXPECT_EQ(bench.polls(), 10'000u) << "a lost answer does not cost the next question";
  ASSERT_EQ(bench.taken.size(), 10'000u - lost);
  for (std::size_t k = 0; k < complete.size(); ++k)
    ASSERT_EQ(bench.taken[k].measurement.raw_counts, complete[k]);
  const auto counters = bench.session->counters();
  EXPECT_EQ(counters.lost, lost);
  EXPECT_EQ(counters.torn, first_only + second_only);
  EXPECT_EQ(counters.late, 0u);
  EXPECT_EQ(counters.restarts, 0u);
}

TEST(AtiSession, AnAnswerThatComesLateIsDroppedAndNeverMakesLaterSamplesOld) {
  AtiBench bench;
  bench.set_up();
  // The adapter holds everything for 3 to 60 ms now and then, and keeps the order.
  std::mt19937_64 random(3);
  Timestamp held_until{0};
  bench.leave = [&](Timestamp when) {
    if (when > held_until + 100ms && random() % 50 == 0)
      held_until = when + std::chrono::milliseconds(3 + random() % 58);
    return std::max(when, held_until);
  };
  bench.run_for(200s);
  const auto counters = bench.session->counters();
  EXPECT_GT(counters.late, 100u);
  EXPECT_GE(counters.lost, counters.late);
  EXPECT_EQ(counters.restarts, 0u);
  // One grid slot is one sample or one that is lost.
  EXPECT_EQ(bench.taken.size() + counters.lost, 20'000u);
  std::size_t k = 0;
  for (const auto& [finger, m] : every(bench.taken)) {
    while (k < bench.sent.size() && bench.reading_of(bench.sent[k]).gages != m.raw_counts) ++k;
    ASSERT_LT(k, bench.sent.size());
    ASSERT_LE(m.stamp - bench.sent[k].when, 5ms) << "older than an answer may be";
    ++k;
  }
}

TEST(AtiSession, AnAnswerInTimeThatIsReadLateCounts) {
  // The stamp of the kernel decides, not the moment at which this program reads.
  AtiBench bench;
  bench.set_up();
  bench.mute = true;
  bench.run_for(1ms);
  ASSERT_EQ(bench.polls(), 1u);
  const Timestamp asked = bench.now - 1ms;
  const auto frames = ati_reading_frames(0x20, AtiReading{});
  Measurement out;
  EXPECT_FALSE(bench.session->take(frames[0], asked + 4ms, out));
  EXPECT_TRUE(bench.session->take(frames[1], asked + 5ms, out));
  bench.run_for(9ms + 1us);
  ASSERT_EQ(bench.polls(), 2u);
  EXPECT_FALSE(bench.session->take(frames[0], asked + 14ms, out));
  EXPECT_FALSE(bench.session->take(frames[1], asked + 15ms + 1ns, out));
  EXPECT_EQ(bench.session->counters().late, 1u);
  EXPECT_EQ(bench.session->counters().lost, 1u);
}

TEST(AtiSession, APowerDipIsNoticedAndTheSensorSetUpAgain) {
  for (const std::uint8_t slot : {std::uint8_t{0}, std::uint8_t{5}})
    for (const auto boot_time : {Timestamp{0}, Timestamp{30ms}, Timestamp{200ms}, Timestamp{3s}}) {
      EmulatedAtiSettings settings;
      settings.good_slot = slot;
      settings.boot_time = boot_time;
      AtiBench bench(config_of(slot), settings);
      bench.set_up();
      bench.run_for(1s + 3ms);
      bench.sensors[0]->power_dip(bench.now, bench);
      const std::size_t before = bench.taken.size();
      bench.run_for(boot_time + 1s);
      // An instant reset of a board whose slot is the one that every reset chooses changes nothing,
      // and a short one is over when the calibration is selected again.
      const std::uint64_t restarts = boot_time >= 100ms || (boot_time == 0ns && slot != 0) ? 1 : 0;
      EXPECT_EQ(bench.session->counters().restarts, restarts) << int{slot} << boot_time.count();
      EXPECT_TRUE(bench.session->streaming());
      EXPECT_GT(bench.taken.size(), before + 40);
      for (const auto& taken : every(bench.taken)) ASSERT_TRUE(taken.measurement.valid);
      const auto& last = bench.taken.back().measurement;
      ASSERT_EQ(last.raw_counts, bench.reading_of(bench.sent.back()).gages);
      const std::size_t slots = static_cast<std::size_t>((2s + 3ms + boot_time) / 10ms) + 1;
      EXPECT_EQ(bench.taken.size() + bench.session->counters().lost, slots) << "lost by time";
    }
}

TEST(AtiSession, ANewWatchdogResetIsARestartAndAnOldOneIsNot) {
  AtiBench bench;
  bench.set_up();
  bench.run_for(1ms);
  bench.mute = true;
  const auto answer = [&](std::uint16_t status) {
    bench.run_for(10ms);
    AtiReading reading;
    reading.status = status;
    Measurement out;
    const auto frames = ati_reading_frames(0x20, reading);
    EXPECT_FALSE(bench.session->take(frames[0], bench.now, out));
    return bench.session->take(frames[1], bench.now, out);
  };
  EXPECT_FALSE(answer(kAtiWatchdogReset));
  EXPECT_EQ(bench.session->counters().restarts, 1u);

  EmulatedAtiSettings settings;
  settings.status = kAtiWatchdogReset;
  AtiBench old(config_of(), settings);
  old.set_up();
  old.run_for(1s);
  EXPECT_EQ(old.session->counters().restarts, 0u);
  EXPECT_EQ(old.taken.size(), 100u);
}

TEST(AtiSession, AnotherMasterThatSelectsAnotherCalibrationIsARestart) {
  AtiBench bench;
  bench.set_up();
  bench.run_for(1s + 3ms);
  const BusFrame other = frame("206#07");
  bench.put_on_bus(other);
  bench.to_host(other);
  bench.to_host(frame("200#"));  // and it polls
  EXPECT_EQ(bench.session->counters().restarts, 1u);
  EXPECT_EQ(bench.session->counters().foreign, 1u);
  bench.run_for(1s);
  EXPECT_TRUE(bench.session->streaming());
  for (const auto& taken : every(bench.taken)) ASSERT_TRUE(taken.measurement.valid);
}

TEST(AtiSession, RefusesAWrongSerialNumber) {
  DeviceConfig config = config_of();
  config.sensors[0].serial_number = "FT99999";
  AtiBench bench(config);
  bench.begin();
  bench.run_for(100ms);
  EXPECT_EQ(bench.session->failure(), SensorSession::Failure::wrong_serial);
  const auto message = bench.session->error("thumb", "can0").message();
  EXPECT_NE(message.find("FT00001"), std::string::npos) << message;
  EXPECT_NE(message.find("FT99999"), std::string::npos) << message;
  config.sensors[0].serial_number = "FT00001";
  AtiBench right(config);
  right.set_up();
}

TEST(AtiSession, RefusesACalibrationThatCannotMeasure) {
  const auto failure_with = [](const EmulatedAtiSettings& settings, std::uint8_t slot) {
    AtiBench bench(config_of(slot), settings);
    bench.begin();
    bench.run_for(100ms);
    EXPECT_NE(bench.session->error("thumb", "can0").message().find("slot"), std::string::npos);
    return bench.session->failure();
  };
  EmulatedAtiSettings empty_slot;  // the board says so itself, and its matrix is zero
  EXPECT_EQ(failure_with(empty_slot, 3), SensorSession::Failure::wrong_calibration);
  EmulatedAtiSettings bad_status;
  bad_status.status = kAtiBadCalibration | kAtiAnyError;
  EXPECT_EQ(failure_with(bad_status, 0), SensorSession::Failure::wrong_calibration);
}

/// Answers the set-up with what the test says.
SensorSession::Failure failure_with_matrix(const AtiCalibration& calibration) {
  AtiSession session(config_of(), 0);
  Timestamp t = 1s;
  session.begin(t);
  while (session.failure() == SensorSession::Failure::none && !session.ready()) {
    const auto asked = session.poll(t);
    if (!asked) {
      t = session.due();
      continue;
    }
    Measurement out;
    const auto answer = [&](const BusFrame& f) { (void)session.take(f, t, out); };
    switch (ati_opcode(*asked)) {
      case AtiOpcode::calibration: answer(*asked); break;
      case AtiOpcode::serial_number: answer(ati_serial_frame(0x20, "X")); break;
      case AtiOpcode::firmware: answer(ati_firmware_frame(0x20, {3, 7, 0})); break;
      case AtiOpcode::counts: answer(ati_counts_frame(0x20, calibration.counts)); break;
      case AtiOpcode::units: answer(ati_units_frame(0x20, calibration.units)); break;
      case AtiOpcode::matrix_row: {
        AtiRow row;
        for (int i = 0; i < 6; ++i)
          row[static_cast<std::size_t>(i)] =
              static_cast<float>(calibration.matrix(asked->data[0], i));
        for (const auto& part : ati_row_frames(0x20, row)) answer(part);
        break;
      }
      default:
        for (const auto& part : ati_reading_frames(0x20, {})) answer(part);
    }
  }
  return session.failure();
}

TEST(AtiSession, RefusesZeroSingularAndInfiniteMatricesAndUnknownUnits) {
  using Failure = SensorSession::Failure;
  AtiCalibration calibration = synthetic_ati_calibration();
  EXPECT_EQ(failure_with_matrix(calibration), Failure::none);
  calibration.matrix.setZero();
  EXPECT_EQ(failure_with_matrix(calibration), Failure::wrong_calibration);
  calibration = synthetic_ati_calibration();
  calibration.matrix.row(2) = calibration.matrix.row(0);
  EXPECT_EQ(failure_with_matrix(calibration), Failure::wrong_calibration);
  calibration = synthetic_ati_calibration();
  calibration.matrix(3, 3) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(failure_with_matrix(calibration), Failure::wrong_calibration);
  calibration = synthetic_ati_calibration();
  calibration.units.force = 9;
  EXPECT_EQ(failure_with_matrix(calibration), Failure::wrong_calibration);
  calibration = synthetic_ati_calibration();
  calibration.counts.per_torque = 0;
  EXPECT_EQ(failure_with_matrix(calibration), Failure::wrong_calibration);
}

TEST(AtiSession, RefusesAnEchoOfAnotherSlot) {
  AtiSession session(config_of(2), 0);
  session.begin(1s);
  ASSERT_EQ(session.poll(1s), frame("206#02"));
  Measurement out;
  (void)session.take(frame("206#03"), 1s, out);
  EXPECT_EQ(session.failure(), SensorSession::Failure::wrong_calibration);
}

TEST(AtiSession, OlderFirmwareIsNotAskedForCountsAndUnits) {
  EmulatedAtiSettings settings;
  settings.firmware = {3, 6, 1};
  AtiBench bench(config_of(), settings);
  bench.begin();
  bench.run_for(1s);
  EXPECT_TRUE(bench.session->streaming());
  EXPECT_GT(bench.taken.size(), 90u);
  EXPECT_EQ(std::count(bench.asked.begin(), bench.asked.end(), frame("207#")), 0);
  EXPECT_EQ(std::count(bench.asked.begin(), bench.asked.end(), frame("208#")), 0);
  EXPECT_EQ(bench.session->calibration().counts, AtiCounts{});
}

TEST(AtiSession, ASensorThatDoesNotAnswerFailsAfterThreeTriesAndIsTriedAgain) {
  AtiBench bench;
  bench.mute = true;
  bench.begin();
  bench.run_for(301ms);
  EXPECT_EQ(bench.session->failure(), SensorSession::Failure::no_answer);
  EXPECT_EQ(bench.asked.size(), 3u);
  bench.mute = false;
  bench.run_for(1s);
  EXPECT_TRUE(bench.session->streaming());
}

TEST(AtiSession, SaturatedGagesAndCriticalErrorsAreInvalidMeasurements) {
  for (const bool saturated : {false, true}) {
    AtiBench bench;
    bench.set_up();
    bench.run_for(1ms);
    bench.mute = true;
    bench.run_for(10ms);
    AtiReading reading;
    if (saturated)
      reading.gages[4] = INT16_MAX;
    else
      reading.status = 1U << 11;
    const auto frames = ati_reading_frames(0x20, reading);
    Measurement out;
    EXPECT_FALSE(bench.session->take(frames[0], bench.now, out));
    EXPECT_TRUE(bench.session->take(frames[1], bench.now, out));
    EXPECT_FALSE(out.valid);
    EXPECT_EQ(out.saturated, saturated);
    EXPECT_EQ(out.status_error, !saturated);
    EXPECT_EQ(out.status, reading.status);
  }
}

TEST(AtiSession, FasterThanItsAnswerTimeStillHasOneQuestionUnderWay) {
  constexpr double kFast_Hz = 400.0;  // 2.5 ms, an answer may take 5 ms
  AtiBench bench(config_of(0, kFast_Hz));
  bench.set_up();
  std::uint64_t lost = 0;
  bench.lose = [&](const Conversation::Sent& sample) {
    const bool hit = sample.number % 10 == 0;
    lost += hit ? 1 : 0;
    return hit ? 3U : 0U;
  };
  bench.run_for(10s);
  const auto counters = bench.session->counters();
  EXPECT_EQ(bench.taken.size() + counters.lost, 4000u);
  EXPECT_GE(counters.lost, lost);
  EXPECT_LE(counters.lost, 4 * lost);
  EXPECT_EQ(counters.late, 0u);
}

TEST(AtiSession, StreamsWithoutAllocation) {
  AtiBench bench;
  bench.set_up();
  bench.mute = true;
  bench.run_for(1ms);
  const auto frames = ati_reading_frames(0x20, AtiReading{});
  const auto before = allocations();
  Measurement out;
  std::size_t measured = 0;
  Timestamp t = bench.now;
  for (int k = 0; k < 1000; ++k) {
    t += 10ms;
    while (const auto asked = bench.session->poll(t))
      if (ati_word(*asked) == AtiWord::either) (void)bench.session->take(*asked, t, out);
    (void)bench.session->take(frames[0], t + 1ms, out);
    measured += bench.session->take(frames[1], t + 1500us, out) ? 1 : 0;
  }
  EXPECT_EQ(allocations(), before);
  EXPECT_GE(measured, 999u);
}

}  // namespace
}  // namespace isograsp::test::ati_session_test
