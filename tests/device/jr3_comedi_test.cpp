// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/codec/jr3_comedi_codec.hpp"
#include "device/comedi/comedi_bus.hpp"
#include "device/config/jr3_comedi_sensor.hpp"
#include "device/protocol/jr3_comedi_session.hpp"
#include "device/sensors/sensor_device.hpp"
#include "tests/device/fake_comedi_card.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::test::jr3_comedi_test {
namespace {

using namespace std::chrono_literals;

constexpr double kPrinted = 0.51e-6;  // half of the last digit of the worked examples
const Vec6 kPaper = (Vec6() << 150, 150, 300, 8, 8, 8).finished();
constexpr unsigned kFilter = 3;  // 31.25 Hz

struct ComediBench {
  explicit ComediBench(double filter_Hz = 31.25) {
    config.filter_Hz = filter_Hz;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      hardware.sensors[f].serial = static_cast<std::uint32_t>(1000 + f);
      hardware.sensors[f].samples.fill(0x4000);
    }
    // A sensor that measures dithers; this one counts.
    hardware.before_read = [this](unsigned subdevice, unsigned channel) {
      if (channel % 8 == 0) ++hardware.sensors[subdevice].samples[channel];
    };
  }
  Result<void> start() {
    auto bus = make_comedi_bus(std::make_unique<FakeComediCard>(hardware), std::array{0U, 1U, 2U},
                               "/dev/comedi0");
    if (!bus) return bus.error();
    SensorSessions sessions;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      sessions[f] = std::make_unique<Jr3ComediSession>(config, f);
    device = std::make_unique<SensorDevice>(*std::move(bus), std::move(sessions), config,
                                            std::vector<double>{}, "comedi:///dev/comedi0",
                                            "/dev/comedi0");
    return device->start(clock);
  }
  std::vector<SensorSample> read_for(Timestamp duration) {
    std::vector<SensorSample> samples;
    const Timestamp end = clock.now() + duration;
    SensorSample sample;
    while (device->read(end, sample) == ReadStatus::sample) samples.push_back(sample);
    return samples;
  }

  DeviceConfig config = DeviceConfig::standard(kJr3ComediFamily);
  FakeJr3 hardware;
  ManualClock clock;
  std::unique_ptr<SensorDevice> device;
};

TEST(Jr3Comedi, FilterThreeIsChannels24To29) {
  EXPECT_EQ(jr3_comedi_filter(31.25), 3);
  EXPECT_EQ(jr3_comedi_filter(0.0), 0);
  EXPECT_EQ(jr3_comedi_filter(500.0), 1);
  EXPECT_EQ(jr3_comedi_filter(0.48828125), 6);
  EXPECT_FALSE(jr3_comedi_filter(30.0).has_value());
  for (unsigned axis = 0; axis < 6; ++axis) EXPECT_EQ(jr3_comedi_channel(3, axis), 24 + axis);
}

TEST(Jr3Comedi, DecodesTheWorkedExamples) {
  EXPECT_WITHIN(jr3_comedi_full_scale(0.150), 150.0, 1e-12) << "kN";
  EXPECT_WITHIN(jr3_comedi_full_scale(0.008), 8.0, 1e-12) << "kN m";
  const auto wrench = wrench_of({17732, 15783, 13762, 16637, 14848, 16467}, kPaper);
  EXPECT_WITHIN(wrench.force.x(), 12.341309, kPrinted);
  EXPECT_WITHIN(wrench.force.y(), -5.502319, kPrinted);
  EXPECT_WITHIN(wrench.force.z(), -48.010254, kPrinted);
  EXPECT_WITHIN(wrench.torque.x(), 0.123535, kPrinted);
  EXPECT_WITHIN(wrench.torque.y(), -0.75, kPrinted);
  EXPECT_WITHIN(wrench.torque.z(), 0.040527, kPrinted);
  const auto limits = wrench_of({32767, 16384, 0, 16384, 16384, 16384}, kPaper);
  EXPECT_WITHIN(limits.force.x(), 149.990845, kPrinted);
  EXPECT_EQ(limits.force.y(), 0.0);
  EXPECT_EQ(limits.force.z(), -300.0);
}

TEST(Jr3Comedi, OnlyTheEndsOfASampleAreSaturated) {
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (unsigned sample = 0; sample <= 0x7FFF; ++sample) {
      Jr3ComediSamples samples;
      samples.fill(0x4000);
      samples[axis] = static_cast<std::uint16_t>(sample);
      ASSERT_EQ(jr3_comedi_saturated(samples), sample == 0 || sample == 0x7FFF);
      ASSERT_EQ(jr3_comedi_counts(samples)[axis], static_cast<int>(sample) - 16384);
    }
}

TEST(Jr3Comedi, FramesBetweenCardAndSessionRoundTrip) {
  const Jr3ComediSamples samples{0, 1, 0x4000, 0x7FFE, 0x7FFF, 0x1234};
  EXPECT_EQ(jr3_comedi_samples(jr3_comedi_frame(2, samples)), samples);
  Jr3ComediIdentity identity{0xDEADBEEF, kPaper};
  identity.full_scale[5] = 0.1;
  const auto back = jr3_comedi_identity(jr3_comedi_frame(1, identity));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->serial_number, identity.serial_number);
  EXPECT_EQ(back->full_scale, identity.full_scale);
  const auto question =
      jr3_comedi_question(jr3_comedi_frame(0, {Jr3ComediQuestion::Kind::identity, 7, 6}));
  ASSERT_TRUE(question.has_value());
  EXPECT_EQ(question->kind, Jr3ComediQuestion::Kind::identity);
  EXPECT_EQ(question->subdevice, 7);
  EXPECT_EQ(question->filter, 6);
  EXPECT_FALSE(jr3_comedi_samples(jr3_comedi_frame(1, identity)).has_value());
  EXPECT_FALSE(jr3_comedi_identity(jr3_comedi_frame(2, samples)).has_value());
  EXPECT_FALSE(jr3_comedi_question(jr3_comedi_frame(2, samples)).has_value());
}

TEST(Jr3ComediDevice, IdentifiesItsSensorsAndReadsTheirRanges) {
  ComediBench bench;
  bench.hardware.sensors[1].full_scale << 100, 110, 200, 5, 6, 7;
  const auto started = bench.start();
  ASSERT_TRUE(started.ok()) << started.error().message();
  const DeviceInfo& info = bench.device->info();
  EXPECT_EQ(info.serial_numbers, (std::array<std::string, 3>{"1000", "1001", "1002"}));
  EXPECT_TRUE(info.units_per_count[0].isApprox(kPaper / 16384.0));
  EXPECT_TRUE(info.units_per_count[1].isApprox(bench.hardware.sensors[1].full_scale / 16384.0));
  EXPECT_DOUBLE_EQ(info.delay_s, 0.032);
  EXPECT_EQ(bench.hardware.opened, 4u) << "ranges are those of a card that is ready";
}

TEST(Jr3ComediDevice, EverySampleArrivesWithItsValueAtTheRateAskedFor) {
  ComediBench bench;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    for (unsigned axis = 0; axis < 6; ++axis)
      bench.hardware.sensors[f].samples[8 * kFilter + axis] =
          static_cast<std::uint32_t>(16384 + 100 * (f + 1) + 7 * axis);
  ASSERT_TRUE(bench.start().ok());
  const auto samples = bench.read_for(10s - 1ms);
  ASSERT_EQ(samples.size(), 3000u);
  std::array<int, 3> next{};
  for (const auto& sample : samples) {
    const auto f = index_of(sample.finger);
    ASSERT_TRUE(sample.valid);
    ASSERT_EQ(sample.raw_counts[0], 100 * (static_cast<int>(f) + 1) + ++next[f]);
    for (int axis = 1; axis < 6; ++axis)
      ASSERT_EQ(sample.raw_counts[static_cast<std::size_t>(axis)],
                100 * (static_cast<int>(f) + 1) + 7 * axis);
    Wrench wrench_S;
    for (int i = 0; i < 3; ++i) {
      wrench_S.force[i] = sample.raw_counts[static_cast<std::size_t>(i)] * kPaper[i] / 16384.0;
      wrench_S.torque[i] =
          sample.raw_counts[static_cast<std::size_t>(i + 3)] * kPaper[i + 3] / 16384.0;
    }
    const Wrench expected = bench.config.sensors[f].mounting.to_contact(wrench_S);
    ASSERT_TRUE(sample.wrench_C.force.isApprox(expected.force, 1e-12));
    ASSERT_TRUE(sample.wrench_C.torque.isApprox(expected.torque, 1e-12));
  }
  const auto health = bench.device->health();
  EXPECT_EQ(health.state, DeviceState::streaming);
  EXPECT_EQ(health.sensors[2].good, 1000u);
  EXPECT_EQ(health.sensors[2].lost, 0u);
}

TEST(Jr3ComediDevice, RefusesAWrongSerialNumber) {
  ComediBench bench;
  bench.config.sensors[1].serial_number = "4711";
  const auto started = bench.start();
  ASSERT_FALSE(started.ok());
  EXPECT_NE(english(started.error().what).find("1001"), std::string::npos)
      << started.error().message();
  EXPECT_NE(english(started.error().what).find("4711"), std::string::npos);
  ComediBench right;
  right.config.sensors[1].serial_number = "1001";
  EXPECT_TRUE(right.start().ok());
}

TEST(Jr3ComediDevice, ASensorThatIsNotReadyIsRefusedWithAWordAboutTheWait) {
  ComediBench bench;
  bench.hardware.sensors[0].state = ComediCard::Reading::not_ready;
  const auto started = bench.start();
  ASSERT_FALSE(started.ok());
  EXPECT_NE(english(started.error().remedy).find("ten seconds"), std::string::npos);
}

TEST(Jr3ComediDevice, ReturnsByItselfWhenTheDriverTrustsTheSensorAgain) {
  ComediBench bench;
  ASSERT_TRUE(bench.start().ok());
  (void)bench.read_for(1s - 1ms);
  bench.hardware.sensors[2].state = ComediCard::Reading::not_ready;
  const auto during = bench.read_for(12s);
  for (const auto& sample : every(during)) ASSERT_NE(sample.finger, Finger::middle);
  auto health = bench.device->health();
  EXPECT_EQ(health.state, DeviceState::faulted);
  EXPECT_EQ(health.fault, DeviceFault::silence);
  EXPECT_EQ(health.finger, Finger::middle);
  // The driver begins anew and may choose other full scales.
  bench.hardware.sensors[2].full_scale << 75, 75, 150, 4, 4, 4;
  bench.hardware.sensors[2].state = ComediCard::Reading::good;
  (void)bench.read_for(1s);
  const auto samples = bench.read_for(1s);
  health = bench.device->health();
  EXPECT_EQ(health.sensors[2].restarts, 1u);
  EXPECT_EQ(health.sensors[2].good + health.sensors[2].lost, health.sensors[0].good);
  EXPECT_EQ(health.sensors[0].lost, 0u);
  bool seen = false;
  for (const auto& sample : samples) {
    if (sample.finger != Finger::middle) continue;
    seen = true;
    EXPECT_WITHIN(std::abs(sample.wrench_C.force.x()), sample.raw_counts[0] * 75.0 / 16384.0, 1e-9);
  }
  EXPECT_TRUE(seen);
}

TEST(Jr3ComediDevice, AnotherSensorThatWasPluggedInMeanwhileIsRefused) {
  ComediBench bench;
  bench.config.sensors[0].serial_number = "1000";
  ASSERT_TRUE(bench.start().ok());
  (void)bench.read_for(1s);
  bench.hardware.sensors[0].state = ComediCard::Reading::not_ready;
  (void)bench.read_for(1s);
  bench.hardware.sensors[0].serial = 999;
  bench.hardware.sensors[0].state = ComediCard::Reading::good;
  (void)bench.read_for(1s);
  EXPECT_EQ(bench.device->health().fault, DeviceFault::wrong_sensor);
}

TEST(Jr3ComediDevice, ALostReadingCostsOneSampleAndIsCounted) {
  ComediBench bench;
  ASSERT_TRUE(bench.start().ok());
  std::mt19937_64 random(5);
  std::uint64_t lost = 0;
  bench.hardware.before_read = [&](unsigned subdevice, unsigned channel) {
    if (channel % 8 == 0) ++bench.hardware.sensors[subdevice].samples[channel];
    auto& state = bench.hardware.sensors[subdevice].state;
    if (channel % 8 != 3) return;
    const bool hit = state == ComediCard::Reading::good && random() % 10 == 0;
    state = hit ? ComediCard::Reading::not_ready : ComediCard::Reading::good;
    lost += hit ? 1 : 0;
    bench.hardware.sensors[subdevice].samples[25] ^= 1;
  };
  // After the reading that failed the next one finds the sensor again.
  std::size_t came = 0;
  for (int k = 0; k < 1000; ++k) {
    came += bench.read_for(10ms).size();
    for (auto& sensor : bench.hardware.sensors) sensor.state = ComediCard::Reading::good;
  }
  bench.hardware.before_read = nullptr;
  came += bench.read_for(10ms).size();
  const auto health = bench.device->health();
  EXPECT_GT(lost, 200u);
  std::uint64_t counted = 0;
  for (const auto& sensor : health.sensors) counted += sensor.lost;
  EXPECT_EQ(counted, lost);
  EXPECT_EQ(health.sensors[0].restarts, 0u);
  EXPECT_EQ(came + lost, 3 * 1001u);
}

TEST(Jr3ComediDevice, AClippedSampleIsSaturatedAndInvalid) {
  ComediBench bench;
  ASSERT_TRUE(bench.start().ok());
  (void)bench.read_for(5ms);
  for (const std::uint32_t end : {0U, 0x7FFFU}) {
    bench.hardware.sensors[1].samples[8 * kFilter + 2] = end;
    for (const auto& sample : every(bench.read_for(50ms))) {
      const bool clipped = sample.finger == Finger::index;
      EXPECT_EQ((sample.flags & bit(SampleFlag::saturated)) != 0, clipped);
      EXPECT_EQ(sample.valid, !clipped);
    }
  }
  EXPECT_EQ(bench.device->health().fault, DeviceFault::overload);
}

TEST(Jr3ComediDevice, NamesWhatIsWrongWithTheCard) {
  ComediBench bench;
  bench.hardware.channels = 16;
  EXPECT_NE(english(bench.start().error().what).find("no JR3 sensor"), std::string::npos);
  ComediBench twelve_bits;
  twelve_bits.hardware.highest = 4095;
  EXPECT_FALSE(twelve_bits.start().ok());
  FakeJr3 hardware;
  const auto missing = make_comedi_bus(std::make_unique<FakeComediCard>(hardware),
                                       std::array{0U, 3U}, "/dev/comedi1");
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().message().find("/dev/comedi1"), std::string::npos);
  EXPECT_NE(english(missing.error().what).find("subdevice 3"), std::string::npos);
  const auto absent = open_comedi_card("/nonexistent/comedi0");
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().file, "/nonexistent/comedi0");
}

TEST(Jr3ComediDevice, StreamsWithoutAllocation) {
  ComediBench bench;
  ASSERT_TRUE(bench.start().ok());
  SensorSample sample;
  const auto before = allocations();
  const Timestamp end = bench.clock.now() + 1s;
  int samples = 0;
  while (bench.device->read(end, sample) == ReadStatus::sample) ++samples;
  EXPECT_EQ(allocations(), before);
  EXPECT_GE(samples, 300);
}

}  // namespace
}  // namespace isograsp::test::jr3_comedi_test
