// SPDX-License-Identifier: GPL-3.0-or-later
// The whole driver against the emulated sensors, on a bus made of memory, in virtual time.
#include "device/sensors/sensor_device.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "device/config/ati_sensor.hpp"
#include "device/config/net_ft_sensor.hpp"
#include "device/config/rft_sensor.hpp"
#include "device/sensors/frame_clock.hpp"
#include "tests/device/families.hpp"
#include "tests/device/sensor_bench.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::sensor_device_test {
namespace {

using namespace std::chrono_literals;

Fault fault(const char* text) {
  return Fault::parse(text).value();
}

TEST(SensorDevice, DeliversEverySampleOfEverySensorExactly) {
  test::SensorBench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto samples = bench.read_for(10s);
  std::array<std::size_t, kFingerCount> next{};
  std::array<Timestamp, kFingerCount> stamp{};
  const auto expected = test::counting_play(3000);
  for (const auto& sample : test::every(samples)) {
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
    EXPECT_EQ(bench.device->info().serial_numbers[f], "EMUL-" + std::to_string(f + 1));
  }
}

TEST(SensorDevice, SpeaksInTheOrderThatTheSensorsNeed) {
  test::SensorBench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  std::vector<int> commands;
  for (const auto& frame : bench.bus->sent)
    if (frame.id == 0x65) commands.push_back(frame.data[0]);
  EXPECT_EQ(commands, (std::vector<int>{0x0C, 0x02, 0x09, 0x08, 0x10, 0x0F, 0x11, 0x0B}));
  // A sensor that already has the settings is not written again: its memory wears.
  bench.bus->sent.clear();
  bench.device->stop();
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  for (const auto& frame : test::every(bench.bus->sent)) {
    EXPECT_NE(frame.data[0], 0x08);
    EXPECT_NE(frame.data[0], 0x0F);
  }
}

TEST(SensorDevice, RestartsSensorsThatAreLeftStreaming) {
  test::SensorBench bench;
  for (const auto& ids : kRftIds) {
    ASSERT_TRUE(bench.bus->start(bench.clock).ok());
    bench.bus->send(encode_command(ids, RftCommand::start));
  }
  bench.clock.wait_until(3s);
  EXPECT_TRUE(bench.device->start(bench.clock).ok());
  EXPECT_GT(bench.read_for(1s).size(), 295u);
}

TEST(SensorDevice, CountsExactlyTheFramesThatTheBusLost) {
  for (const char* text : {"lose=index:tx1:0.1", "lose=index:tx2:0.1"}) {
    EmulatorOptions options;
    options.faults = {fault(text)};
    test::SensorBench bench(options);
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
    EXPECT_EQ(health.fault, DeviceFault::damaged_samples);
  }
}

TEST(SensorDevice, CountsFromTheStartOn) {
  EmulatorOptions options;
  options.faults = {fault("lose=index:tx1:0.5")};
  test::SensorBench bench(options);
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(bench.device->start(bench.clock).ok());
    const auto health = bench.device->health();
    EXPECT_EQ(health.state, DeviceState::streaming);
    for (const auto& sensor : test::every(health.sensors))
      EXPECT_EQ(sensor.good + sensor.lost + sensor.torn, 0u);
    (void)bench.read_for(1s);
    EXPECT_GT(bench.device->health().sensors[1].torn, 20u);
    bench.device->stop();
    bench.clock.wait_until(bench.clock.now() + 5s);  // stopped: nothing is lost
  }
}

TEST(SensorDevice, SaysThatASensorIsSilentAndTakesItBack) {
  EmulatorOptions options;
  options.faults = {fault("dip=thumb@2s")};
  test::SensorBench bench(options);
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
  // Told for a while, since its zero may be another one now.
  auto health = bench.device->health();
  EXPECT_EQ(health.state, DeviceState::degraded);
  EXPECT_EQ(health.fault, DeviceFault::restarted);
  EXPECT_EQ(health.finger, Finger::thumb);
  EXPECT_EQ(health.sensors[0].restarts, 1u);
  EXPECT_GT(health.sensors[0].lost, 5u);
  (void)bench.read_for(10s);
  EXPECT_EQ(bench.device->health().state, DeviceState::streaming);
}

TEST(SensorDevice, GoesOnWithTheOtherSensorsWhenOneStaysSilent) {
  EmulatorOptions options;
  options.faults = {fault("silence=middle@1s")};
  test::SensorBench bench(options);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  (void)bench.read_for(3s);
  std::array<int, kFingerCount> count{};
  for (const auto& sample : bench.read_for(5s)) ++count[index_of(sample.finger)];
  EXPECT_NEAR(count[0], 500, 2);
  EXPECT_NEAR(count[1], 500, 2);
  EXPECT_EQ(count[2], 0);
  EXPECT_EQ(bench.device->health().fault, DeviceFault::silence);
}

TEST(SensorDevice, NamesTheSensorThatDoesNotAnswer) {
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  config.sensors[1].as<RftSensor>().ids = {0x70, 0x71, 0x72};  // nobody has these
  test::SensorBench bench({}, config);
  const auto started = bench.device->start(bench.clock);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(
      started.error().message(),
      "test: the index finger's sensor (identifier 0x70) does not answer; check its power, its "
      "cable and the 120 ohm at both ends of the bus");
  EXPECT_LT(bench.clock.now(), 500ms);
}

TEST(SensorDevice, RefusesASensorWithAnotherSerialNumber) {
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  config.sensors[2].serial_number = "A-17";
  test::SensorBench bench({}, config);
  const auto started = bench.device->start(bench.clock);
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(english(started.error().what),
            "the middle finger's sensor (identifier 0x66) has the serial number EMUL-3, but the "
            "configuration says A-17");
}

TEST(SensorDevice, TellsWhatIsWrongWithTheBusAndForgetsItWhenFramesArrive) {
  test::SensorBench bench;
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

TEST(SensorDevice, FlagsOverloadAndSaturationAtOnce) {
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  config.sensors[0].range.head<3>().setConstant(0.04);  // two counts
  EmulatorOptions options;
  options.config = config;
  test::SensorBench bench(options, config);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto samples = bench.read_for(100ms);
  const auto& last = *std::find_if(samples.rbegin(), samples.rend(),
                                   [](const auto& s) { return s.finger == Finger::thumb; });
  EXPECT_EQ(last.flags, bit(SampleFlag::overload) | bit(SampleFlag::saturated));
  EXPECT_EQ(bench.device->health().fault, DeviceFault::overload);
}

TEST(SensorDevice, KeepsTheDeadline) {
  test::SensorBench bench;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  SensorSample sample;
  test::AtLeast timeouts(1);
  for (int i = 0; i < 1000; ++i) {
    const Timestamp deadline = bench.clock.now() + 700us;
    const auto status = bench.device->read(deadline, sample);
    if (status == ReadStatus::timeout) {
      EXPECT_EQ(bench.clock.now(), deadline);
      ++timeouts;
    }
    EXPECT_LE(bench.clock.now(), deadline);
  }
}

TEST(SensorDevice, ReadingAllocatesNothing) {
  EmulatorOptions options;
  options.faults = {fault("lose=index:tx1:0.1"), fault("dip=thumb@2s")};
  test::SensorBench bench(options);
  bench.bus->log_sent = false;
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  SensorSample sample;
  int count = 0;
  const auto before = test::allocations();
  while (bench.device->read(6s, sample) == ReadStatus::sample) ++count;
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(count, 1500);
}

TEST(SensorDevice, FillsTheGridAtEveryRateOfTheSensors) {
  for (const double rate_Hz : {50.0, 100.0, 200.0, 333.0, 500.0, 1000.0}) {
    DeviceConfig config = DeviceConfig::standard(kRftFamily);
    config.rate_Hz = rate_Hz;
    test::SensorBench bench({}, config);
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

/// A fault, and what the driver has to say about it.
struct Named {
  const char* fault;
  DeviceFault cause;
  Finger finger;
};

class EveryProtocol : public ::testing::TestWithParam<const FamilyFacts*> {
 protected:
  [[nodiscard]] static test::SensorBench bench_with(const char* text) {
    EmulatorOptions options;
    options.config = DeviceConfig::standard(*GetParam());
    constexpr int kSensorNoise = 3;
    options.noise_counts = kSensorNoise;
    if (text != nullptr) options.faults = {fault(text)};
    FingerPlay still;
    still.t_s = {0.0};
    still.wrench_C = {FingerWrenches{}};
    return test::SensorBench(options, DeviceConfig::standard(*GetParam()), still);
  }
};

TEST_P(EveryProtocol, NamesTheFaultAndItsFingerAndRecoversWithinASecond) {
  const bool numbered_datagrams = GetParam() == &kNetFtFamily;
  const Named faults[] = {
      {"silence=index:1s@2s", DeviceFault::silence, Finger::index},
      // The same datagram again is a duplicate: nothing new comes.
      {"freeze=thumb:1.5s@2s", numbered_datagrams ? DeviceFault::silence : DeviceFault::frozen,
       Finger::thumb},
      // These boxes call it an error of their own.
      {"saturate=middle:1s@2s", numbered_datagrams ? DeviceFault::status : DeviceFault::overload,
       Finger::middle},
      {"dip=index@2s", DeviceFault::restarted, Finger::index},
      {"lose=middle:all:0.2", DeviceFault::damaged_samples, Finger::middle}};
  for (const Named& named : faults) {
    auto bench = bench_with(named.fault);
    bench.bus->log_sent = false;
    ASSERT_TRUE(bench.device->start(bench.clock).ok());
    bool told = false;
    while (bench.clock.now() < 4s) {
      (void)bench.read_for(10ms);
      const auto health = bench.device->health();
      told |= health.fault == named.cause && health.finger == named.finger;
    }
    EXPECT_TRUE(told) << named.fault;
    (void)bench.read_for(500ms);
    EXPECT_NE(bench.device->health().state, DeviceState::faulted) << named.fault;
    EXPECT_NE(bench.device->health().sensors[0].good, 0u);
  }
}

TEST_P(EveryProtocol, RefusesToStartWithASilentSensorAndNamesIt) {
  auto bench = bench_with("silence=middle@0s");
  // Silence begins with the first sample of all, for a board that is asked already at the start.
  auto again = bench.device->start(bench.clock);
  if (again.ok()) {
    (void)bench.read_for(1s);
    bench.device->stop();
    again = bench.device->start(bench.clock);
  }
  ASSERT_FALSE(again.ok());
  EXPECT_NE(english(again.error().what).find("the middle finger's sensor"), std::string::npos)
      << again.error().message();
}

TEST_P(EveryProtocol, ValuesThatMeanNothingAreNeverValid) {
  // Far beyond what any of these numbers can say.
  EmulatorOptions options;
  options.config = DeviceConfig::standard(*GetParam());
  FingerPlay crush;
  crush.t_s = {0.0};
  FingerWrenches wrenches{};
  for (auto& wrench : wrenches) wrench.force.z() = 1e7;
  crush.wrench_C = {wrenches};
  test::SensorBench bench(options, DeviceConfig::standard(*GetParam()), crush);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  const auto samples = bench.read_for(200ms);
  ASSERT_FALSE(samples.empty());
  for (const auto& sample : test::every(samples)) {
    EXPECT_NE(sample.flags & bit(SampleFlag::saturated), 0);
    EXPECT_FALSE(sample.valid);
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, EveryProtocol, ::testing::ValuesIn(test::emulated_families()),
                         test::name_of_family);

TEST(SensorDevice, RefusesTheWrongSensorOfEveryFamilyThatTellsItsNumber) {
  for (const FamilyFacts* family : {&kRftFamily, &kAtiFamily}) {
    EmulatorOptions options;
    options.config = DeviceConfig::standard(*family);
    options.config.sensors[0].serial_number = "FT100";
    options.faults = {fault("wrongserial=thumb")};
    test::SensorBench bench(options, options.config);
    const auto started = bench.device->start(bench.clock);
    ASSERT_FALSE(started.ok());
    EXPECT_NE(english(started.error().what)
                  .find("has the serial number WRONG-1, but the configuration says "
                        "FT100"),
              std::string::npos)
        << english(started.error().what);
  }
}

TEST(SensorDevice, OverSampledForcesComeSmoothAndLateByTheDelayThatItTells) {
  // A step of the finger at a known time; the filter's answer passes half its height after the
  // delay.
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  config.rate_Hz = 500.0;
  config.filter_Hz = 0.0;
  config.fir_taps = 33;
  EmulatorOptions options;
  options.config = config;
  options.clock_error = 0.0;
  FingerPlay step;
  constexpr double kStep_s = 0.12;  // soon: forces that stand still for longer look frozen
  step.t_s = {0.0, kStep_s};
  step.wrench_C.resize(2);
  for (auto& wrench : step.wrench_C[1]) wrench.force.z() = 10.0;
  test::SensorBench bench(options, config, step);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  EXPECT_WITHIN(bench.device->info().delay_s, 0.032, 1e-12);
  const auto samples = bench.read_for(250ms);
  std::optional<Timestamp> raw_step;
  std::optional<Timestamp> half;
  for (const auto& sample : samples) {
    if (sample.finger != Finger::thumb) continue;
    if (!raw_step && sample.raw_counts[2] != 0) raw_step = sample.stamp;
    if (!half && sample.valid && sample.wrench_C.force.z() >= 5.0) half = sample.stamp;
  }
  ASSERT_TRUE(raw_step && half);
  EXPECT_NEAR(to_seconds(*half - *raw_step), bench.device->info().delay_s, 1.0 / config.rate_Hz);
  EXPECT_WITHIN(samples.back().wrench_C.force.z(), 10.0, 1e-9);
}

TEST(SensorDevice, AFrozenSensorIsKnownWithinAFifthOfASecond) {
  constexpr Timestamp kSoon = 200ms;
  EmulatorOptions options;
  options.noise_counts = 3;
  options.faults.push_back(*Fault::parse("freeze=thumb:2s@1s"));
  FingerPlay play;
  play.t_s = {0.0};
  play.wrench_C.resize(1);
  test::SensorBench bench(options, options.config, play);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  std::optional<SensorSample> last;
  Timestamp same_since{0};
  bool known = false;
  for (const auto& sample : test::every(bench.read_for(2s))) {
    if (sample.finger != Finger::thumb) continue;
    if (!last || sample.raw_counts != last->raw_counts) same_since = sample.stamp;
    EXPECT_TRUE(sample.valid || sample.stamp - same_since > 100ms) << "dither is no freeze";
    known = known || !sample.valid;
    EXPECT_FALSE(sample.valid && sample.stamp - same_since > kSoon);
    last = sample;
  }
  EXPECT_TRUE(known);
}

TEST(SensorDevice, AClinicsCalibrationActsInTheSensorFrame) {
  DeviceConfig config = DeviceConfig::standard(kRftFamily);
  ClinicCalibration calibration;
  calibration.matrix(2, 2) = 1.1;
  calibration.matrix(0, 2) = 0.05;
  config.sensors[0].calibration = calibration;
  EmulatorOptions options;  // a sensor that is off by this matrix
  FingerPlay play;
  play.t_s = {0.0};
  FingerWrenches wrenches{};
  wrenches[0].force.z() = 20.0;
  play.wrench_C = {wrenches};
  test::SensorBench bench(options, config, play);
  ASSERT_TRUE(bench.device->start(bench.clock).ok());
  for (const auto& sample : test::every(bench.read_for(100ms))) {
    if (sample.finger != Finger::thumb) continue;
    // S: (0, 0, -20) becomes (-1, 0, -22); C turns y and z.
    EXPECT_WITHIN(sample.wrench_C.force.x(), -1.0, 1e-12);
    EXPECT_WITHIN(sample.wrench_C.force.z(), 22.0, 1e-12);
    EXPECT_EQ(sample.raw_counts[2], -1000);
  }
}

}  // namespace
}  // namespace isograsp::sensor_device_test
