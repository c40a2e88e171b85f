// SPDX-License-Identifier: GPL-3.0-or-later
// The whole driver against three emulated boxes, each on a real socket of this computer.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include <unistd.h>

#include "device/config/net_ft_sensor.hpp"
#include "tests/device/net_ft_boxes.hpp"
#include "tests/support/every.hpp"

namespace isograsp::udp_boxes_test {
namespace {

using namespace std::chrono_literals;

constexpr Timestamp kPatience = 10s;

/// One second of driver and boxes, and what was sent shortly before its end.
struct Run {
  explicit Run(const EmulatorOptions& options) : boxes(options) {
    const auto device = test::open_boxes(boxes, options.config);
    const auto started = device->start(clock);
    EXPECT_TRUE(started) << started.error().message();
    SensorSample sample;
    const Timestamp end = clock.now() + 1s;
    while (device->read(end, sample) == ReadStatus::sample) keep(sample);
    boxes.finish();
    while (device->read(clock.now() + 20ms, sample) == ReadStatus::sample) keep(sample);
    health = device->health();
    device->stop();
    boxes.end();
  }
  void keep(const SensorSample& sample) { samples[index_of(sample.finger)].push_back(sample); }
  [[nodiscard]] bool was_interrupted() const {
    return health.sensors[0].restarts + health.sensors[1].restarts + health.sensors[2].restarts > 0;
  }

  SteadyClock clock;
  test::Boxes boxes;
  std::array<std::vector<SensorSample>, kFingerCount> samples;
  DeviceHealth health;
};

/// A busy computer may keep the boxes' thread from running for longer than a sensor may be silent:
/// that is no fault of the driver, which then starts them again.
std::unique_ptr<Run> run_without_interruption(const EmulatorOptions& options) {
  constexpr int kAttempts = 5;
  auto run = std::make_unique<Run>(options);
  for (int n = 1; n < kAttempts && run->was_interrupted(); ++n)
    run = std::make_unique<Run>(options);
  return run;
}

TEST(UdpBusWithBoxes, EverySampleOfThreeBoxesArrivesWithItsValue) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kNetFtFamily);
  const auto run = run_without_interruption(options);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& samples = run->samples[f];
    EXPECT_EQ(samples.size(), run->boxes.counters(f).samples);
    EXPECT_EQ(run->health.sensors[f].good, samples.size());
    EXPECT_EQ(run->health.sensors[f].lost, 0u);
    ASSERT_FALSE(samples.empty());
    // The play numbers its rows; each box has its own phase and clock.
    std::int32_t last = -1;
    for (const auto& one : test::every(samples)) {
      const double pressed = one.wrench_C.force.z() * 50.0 - 1000.0 * static_cast<double>(f);
      const auto row = static_cast<std::int32_t>(std::lround(pressed));
      ASSERT_NEAR(pressed, row, 1e-3);
      ASSERT_TRUE(last < 0 || (row >= last && row <= last + 2)) << "the order is kept";
      last = row;
    }
  }
}

TEST(UdpBusWithBoxes, CountsExactlyWhatTheNetworkDid) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kNetFtFamily);
  options.config.rate_Hz = 500.0;
  for (const char* fault : {"lose=thumb:all:0.05", "duplicate=index:0.05", "delay=middle:0.05:7ms"})
    options.faults.push_back(Fault::parse(fault).value());
  const auto run = run_without_interruption(options);
  const auto& boxes = run->boxes;
  const auto& [thumb, index, middle] = run->health.sensors;
  EXPECT_GT(boxes.counters(0).lost_samples, 0u);
  EXPECT_EQ(thumb.good + boxes.counters(0).lost_samples, boxes.counters(0).samples);
  EXPECT_GT(boxes.counters(1).duplicated, 0u);
  EXPECT_EQ(index.duplicate, boxes.counters(1).duplicated);
  EXPECT_EQ(index.good, boxes.counters(1).samples);
  EXPECT_EQ(index.lost, 0u);
  EXPECT_GT(boxes.counters(2).delayed, 0u);
  EXPECT_EQ(middle.lost, middle.late) << "what came late was missed first; nothing else was lost";
  EXPECT_EQ(middle.good + middle.late, boxes.counters(2).samples);
  for (const auto& samples : test::every(run->samples))
    EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                               [](const auto& a, const auto& b) { return a.stamp < b.stamp; }));
}

TEST(UdpBusWithBoxes, ABoxThatRebootsComesBackByItself) {
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kNetFtFamily);
  options.faults.push_back(Fault::parse("reboot=index@0.3s").value());
  test::Boxes boxes(options);
  SteadyClock clock;
  const auto device = test::open_boxes(boxes, options.config);
  ASSERT_TRUE(device->start(clock));
  SensorSample sample;
  int after_restart = 0;
  const Timestamp limit = clock.now() + kPatience;
  while (after_restart < 20 && device->read(limit, sample) == ReadStatus::sample)
    if (sample.finger == Finger::index && device->health().sensors[1].restarts > 0) ++after_restart;
  EXPECT_EQ(after_restart, 20);
  EXPECT_EQ(device->health().sensors[1].restarts, 1u);
  EXPECT_EQ(device->health().sensors[0].restarts + device->health().sensors[2].restarts, 0u);
  device->stop();
}

// ---- minutes with faults by chance

/// Memory in use by this process.
std::size_t resident_bytes() {
  std::size_t pages = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(UdpBusWithBoxes, MinutesOfFaultsLeaveNothingBehind) {
  const auto duration = std::getenv("ISOGRASP_LONG") != nullptr ? Timestamp(10min) : Timestamp(6s);
  EmulatorOptions options;
  options.config = DeviceConfig::standard(kNetFtFamily);
  options.config.rate_Hz = 500.0;
  for (const char* fault : {"lose=all:all:0.01", "duplicate=all:0.01", "delay=middle:0.01:7ms"})
    options.faults.push_back(Fault::parse(fault).value());
  const std::array<const char*, 4> kinds{"reboot=thumb", "silence=index:0.5s", "reboot=middle",
                                         "silence=thumb:0.3s"};
  constexpr double kEvery_s = 2.0;
  std::size_t number = 0;
  for (double at_s = 1.0; at_s + kEvery_s < to_seconds(duration); at_s += kEvery_s, ++number)
    options.faults.push_back(
        Fault::parse(kinds[number % kinds.size()] + ("@" + std::to_string(at_s)) + "s").value());
  test::Boxes boxes(options);
  SteadyClock clock;
  const auto device = test::open_boxes(boxes, options.config);
  ASSERT_TRUE(device->start(clock));
  std::array<std::uint64_t, kFingerCount> taken{};
  std::size_t warm_bytes = 0;
  const Timestamp start = clock.now();
  const auto read_until = [&](Timestamp end) {
    SensorSample sample;
    while (device->read(end, sample) == ReadStatus::sample) ++taken[index_of(sample.finger)];
  };
  read_until(start + duration / 6);
  warm_bytes = resident_bytes();
  read_until(start + duration);
  const std::size_t grown = resident_bytes() - std::min(resident_bytes(), warm_bytes);
  // The faults are over; within a second all sensors are back.
  for (int i = 0; i < 50 && device->health().state == DeviceState::faulted; ++i)
    read_until(clock.now() + 100ms);
  EXPECT_NE(device->health().state, DeviceState::faulted);
  boxes.finish();
  read_until(clock.now() + 50ms);
  const auto health = device->health();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const SensorCounters& c = health.sensors[f];
    const EmulatorCounters& sent = boxes.counters(f);
    EXPECT_EQ(c.good + c.invalid, taken[f]);
    // What arrived is what was sent, less what the network lost and what came too late; records
    // that came while a box was being set up again were nobody's.
    const auto arrived = sent.samples - sent.broken;
    EXPECT_LE(taken[f] + c.late, arrived);
    constexpr std::uint64_t kPerRestart = 300;  // at 500 Hz: the pause after three tries, set-up
    EXPECT_GE(taken[f] + c.late + (c.restarts + 1) * kPerRestart, arrived);
    EXPECT_GE(c.restarts, number / 4);
    EXPECT_EQ(c.torn, 0u);
    std::printf("%s: %llu taken, %llu lost, %llu late, %llu restarts\n",
                std::string(kFingerNames[f]).c_str(), static_cast<unsigned long long>(taken[f]),
                static_cast<unsigned long long>(c.lost), static_cast<unsigned long long>(c.late),
                static_cast<unsigned long long>(c.restarts));
  }
  constexpr std::size_t kFlat_bytes = 2 << 20;
  EXPECT_LT(grown, kFlat_bytes);
  device->stop();
}

}  // namespace
}  // namespace isograsp::udp_boxes_test
