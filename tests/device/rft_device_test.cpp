// SPDX-License-Identifier: GPL-3.0-or-later
// The whole RFT driver against the emulated sensors, on a bus made of memory, in virtual time.
#include "device/rft_device.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "device/frame_clock.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/device/emulated_bus.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp {
namespace {

using namespace std::chrono_literals;

constexpr double kRate_Hz = 100.0;

struct Bench {
  explicit Bench(RftEmulatorOptions options = {}, RftConfig config = RftConfig::standard(),
                 double rate_Hz = kRate_Hz) {
    auto owned = std::make_unique<test::EmulatedBus>(std::move(options), test::counting_play(3000));
    bus = owned.get();
    device = std::make_unique<RftDevice>(std::move(owned), config, rate_Hz, "can://test", "test");
  }
  /// Reads for a while; returns the samples.
  std::vector<SensorSample> read_for(Timestamp duration) {
    std::vector<SensorSample> samples;
    const Timestamp end = clock.now() + duration;
    SensorSample sample;
    while (device->read(end, sample) == ReadStatus::sample) samples.push_back(sample);
    return samples;
  }
  ManualClock clock;
  test::EmulatedBus* bus = nullptr;
  std::unique_ptr<RftDevice> device;
};

RftFault fault(const char* text) {
  return RftFault::parse(text).value();
}

TEST(RftDevice, DeliversEverySampleOfEverySensorExactly) {
  Bench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto samples = bench.read_for(10s);
  std::array<std::size_t, kFingerCount> next{};
  std::array<Timestamp, kFingerCount> stamp{};
  const auto expected = test::counting_play(3000);
  for (const auto& sample : samples) {
    const auto f = index_of(sample.finger);
    EXPECT_TRUE(sample.valid);
    EXPECT_EQ(sample.wrench_C.force, expected.wrench_C[next[f]][f].force);
    EXPECT_EQ(sample.wrench_C.torque, expected.wrench_C[next[f]][f].torque);
    EXPECT_GT(sample.stamp, stamp[f]);
    stamp[f] = sample.stamp;
    ++next[f];
  }
  const auto health = bench.device->health();
  EXPECT_EQ(health.state, DeviceState::streaming);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    EXPECT_NEAR(static_cast<double>(next[f]), 1000.0, 2.0);  // 200 ppm clock error, any phase
    EXPECT_EQ(health.sensors[f].good, next[f]);
    EXPECT_EQ(health.sensors[f].lost + health.sensors[f].torn + health.sensors[f].invalid, 0u);
    EXPECT_EQ(bench.device->info().serial_numbers[f], "EMULATED-" + std::to_string(f + 1));
  }
}

TEST(RftDevice, SpeaksInTheOrderThatTheSensorsNeed) {
  Bench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  std::vector<int> commands;
  for (const auto& frame : bench.bus->sent)
    if (frame.id == 0x65) commands.push_back(frame.data[0]);
  EXPECT_EQ(commands, (std::vector<int>{0x0C, 0x02, 0x09, 0x08, 0x10, 0x0F, 0x11, 0x0B}));
  // A sensor that already has the settings is not written again: its memory wears.
  bench.bus->sent.clear();
  bench.device->stop();
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  for (const auto& frame : bench.bus->sent) {
    EXPECT_NE(frame.data[0], 0x08);
    EXPECT_NE(frame.data[0], 0x0F);
  }
}

TEST(RftDevice, RestartsSensorsThatAreLeftStreaming) {
  Bench bench;
  for (const auto& ids : kRftIds) {
    ASSERT_TRUE(bench.bus->start(bench.clock).ok());
    bench.bus->send(encode_command(ids, RftCommand::start));
  }
  bench.clock.wait_until(3s);
  EXPECT_TRUE(bench.device->start(bench.clock).ok());
  EXPECT_GT(bench.read_for(1s).size(), 295u);
}

TEST(RftDevice, CountsExactlyTheFramesThatTheBusLost) {
  for (const char* text : {"lose=index:tx1:0.1", "lose=index:tx2:0.1"}) {
    RftEmulatorOptions options;
    options.faults = {fault(text)};
    Bench bench(options);
    ASSERT_TRUE(bench.device->start(bench.clock).ok());
    std::vector<std::size_t> rows;
    for (const auto& sample : bench.read_for(20s))
      if (sample.finger == Finger::index)
        rows.push_back(static_cast<std::size_t>(std::lround(sample.wrench_C.force.z() * 50.0)) -
                       1000);
    const auto& sent = bench.bus->emulator().counters()[1];
    const auto health = bench.device->health();
    ASSERT_GT(sent.lost_samples, 100u);
    EXPECT_EQ(health.sensors[1].good, sent.samples - sent.lost_samples);
    EXPECT_EQ(rows.size(), health.sensors[1].good);
    EXPECT_EQ(health.sensors[1].lost, rows.back() - rows.front() + 1 - rows.size());
    // The newest first half may still wait for its second one.
    EXPECT_LE(sent.lost_first + sent.lost_second - health.sensors[1].torn, 1u);
    EXPECT_EQ(health.sensors[0].lost + health.sensors[0].torn, 0u);
    EXPECT_EQ(health.state, DeviceState::degraded);
    EXPECT_EQ(health.fault, DeviceFault::torn_samples);
  }
}

TEST(RftDevice, CountsFromTheStartOn) {
  RftEmulatorOptions options;
  options.faults = {fault("lose=index:tx1:0.5")};
  Bench bench(options);
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(bench.device->start(bench.clock).ok());
    const auto health = bench.device->health();
    EXPECT_EQ(health.state, DeviceState::streaming);
    for (const auto& sensor : health.sensors)
      EXPECT_EQ(sensor.good + sensor.lost + sensor.torn, 0u);
    (void)bench.read_for(1s);
    EXPECT_GT(bench.device->health().sensors[1].torn, 20u);
    bench.device->stop();
    bench.clock.wait_until(bench.clock.now() + 5s);  // stopped: nothing is lost
  }
}

TEST(RftDevice, SaysThatASensorIsSilentAndTakesItBack) {
  RftEmulatorOptions options;
  options.faults = {fault("dip=thumb@2s")};
  Bench bench(options);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  (void)bench.read_for(1900ms);
  EXPECT_EQ(bench.device->health().state, DeviceState::streaming);
  bool told = false;
  for (int i = 0; i < 80; ++i) {
    (void)bench.read_for(5ms);
    const auto health = bench.device->health();
    told |= health.state == DeviceState::faulted && health.fault == DeviceFault::silence;
  }
  EXPECT_TRUE(told);
  (void)bench.read_for(1s);
  std::array<int, kFingerCount> count{};
  for (const auto& sample : bench.read_for(2s)) ++count[index_of(sample.finger)];
  EXPECT_NEAR(count[0], 200, 2);
  EXPECT_NEAR(count[1], 200, 2);
  EXPECT_EQ(bench.device->health().state, DeviceState::streaming);
  EXPECT_GT(bench.device->health().sensors[0].lost, 5u);
}

TEST(RftDevice, GoesOnWithTheOtherSensorsWhenOneStaysSilent) {
  RftEmulatorOptions options;
  options.faults = {fault("silence=middle@1s")};
  Bench bench(options);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  (void)bench.read_for(3s);
  std::array<int, kFingerCount> count{};
  for (const auto& sample : bench.read_for(5s)) ++count[index_of(sample.finger)];
  EXPECT_NEAR(count[0], 500, 2);
  EXPECT_NEAR(count[1], 500, 2);
  EXPECT_EQ(count[2], 0);
  EXPECT_EQ(bench.device->health().fault, DeviceFault::silence);
}

TEST(RftDevice, NamesTheSensorThatDoesNotAnswer) {
  RftConfig config = RftConfig::standard();
  config.sensors[1].ids = {0x70, 0x71, 0x72};  // nobody has these
  Bench bench({}, config);
  const auto started = bench.device->start(bench.clock);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().message(),
            "test: the index's sensor (identifier 0x70) does not answer; check its power, its "
            "cable and the 120 ohm at both ends of the bus");
  EXPECT_LT(bench.clock.now(), 500ms);
}

TEST(RftDevice, RefusesASensorWithAnotherSerialNumber) {
  RftConfig config = RftConfig::standard();
  config.sensors[2].serial_number = "A-17";
  Bench bench({}, config);
  const auto started = bench.device->start(bench.clock);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.error().what,
            "the middle's sensor (identifier 0x66) has the serial number EMULATED-3, but the "
            "configuration says A-17");
}

TEST(RftDevice, TellsWhatIsWrongWithTheBusAndForgetsItWhenFramesArrive) {
  Bench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  for (const auto& [event, expected] :
       {std::pair{BusEvent::bus_off, DeviceFault::bus_off},
        std::pair{BusEvent::interface_down, DeviceFault::interface_down},
        std::pair{BusEvent::interface_gone, DeviceFault::interface_gone}}) {
    SensorSample sample;
    (void)bench.read_for(50ms);
    bench.bus->next_event = event;
    EXPECT_EQ(bench.device->read(bench.clock.now(), sample), ReadStatus::timeout);
    EXPECT_EQ(bench.device->health().fault, expected);
    EXPECT_EQ(bench.device->health().state, DeviceState::faulted);
  }
  EXPECT_GT(bench.read_for(1s).size(), 290u);
  EXPECT_EQ(bench.device->health().state, DeviceState::streaming);
}

TEST(RftDevice, FlagsOverloadAndSaturationAtOnce) {
  RftConfig config = RftConfig::standard();
  config.sensors[0].range.head<3>().setConstant(0.04);  // two counts
  RftEmulatorOptions options;
  options.config = config;
  Bench bench(options, config);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto samples = bench.read_for(100ms);
  const auto& last = *std::find_if(samples.rbegin(), samples.rend(),
                                   [](const auto& s) { return s.finger == Finger::thumb; });
  EXPECT_EQ(last.flags, bit(SampleFlag::overload) | bit(SampleFlag::saturated));
  EXPECT_EQ(bench.device->health().fault, DeviceFault::overload);
}

TEST(RftDevice, KeepsTheDeadline) {
  Bench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  SensorSample sample;
  for (int i = 0; i < 1000; ++i) {
    const Timestamp deadline = bench.clock.now() + 700us;
    const auto status = bench.device->read(deadline, sample);
    if (status == ReadStatus::timeout) {
      EXPECT_EQ(bench.clock.now(), deadline);
    }
    EXPECT_LE(bench.clock.now(), deadline);
  }
}

TEST(RftDevice, ReadingAllocatesNothing) {
  RftEmulatorOptions options;
  options.faults = {fault("lose=index:tx1:0.1"), fault("dip=thumb@2s")};
  Bench bench(options);
  bench.bus->log_sent = false;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  SensorSample sample;
  int count = 0;
  const auto before = test::allocations();
  while (bench.device->read(6s, sample) == ReadStatus::sample) ++count;
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(count, 1500);
}

TEST(RftDevice, FillsTheGridAtEveryRateOfTheSensors) {
  for (const double rate_Hz : {50.0, 100.0, 200.0, 333.0, 500.0, 1000.0}) {
    Bench bench({}, RftConfig::standard(), rate_Hz);
    ASSERT_TRUE(bench.device->start(bench.clock).ok());
    const auto& info = bench.device->info();
    FrameClock frames(info.frame_period_s, info.sample_period_s, info.on_grid, bench.clock.now());
    SensorSample sample;
    FingerFrame frame;
    const Timestamp end = bench.clock.now() + 5s;
    while (bench.clock.now() < end) {
      if (bench.device->read(frames.deadline(), sample) == ReadStatus::sample) frames.push(sample);
      while (frames.pop(bench.clock.now(), frame)) {
        if (frame.slot >= 5) {
          EXPECT_FALSE(frame.any(SampleFlag::missing)) << rate_Hz << ' ' << frame.slot;
        }
      }
    }
    EXPECT_GE(frame.slot, 490);
    EXPECT_EQ(frames.late(), 0u);
  }
}

}  // namespace
}  // namespace isograsp
