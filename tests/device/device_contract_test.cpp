// SPDX-License-Identifier: GPL-3.0-or-later
// What every device promises, whatever its scheme. Families of sensors are those of the table; to
// add another device, add a maker below.
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "device/config/net_ft_sensor.hpp"
#include "device/config/rft_sensor.hpp"
#include "device/recording/replay_device.hpp"
#include "device/simulated/sim_device.hpp"
#include "hand/finger_forces.hpp"
#include "tests/device/families.hpp"
#include "tests/device/scripted_source.hpp"
#include "tests/device/sensor_bench.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::device_contract_test {
namespace {

constexpr Timestamp kStart = std::chrono::seconds{5};
constexpr Timestamp kSecond = std::chrono::seconds{1};

/// What a device needs to live: its forces, its file and the device itself.
struct Rig {
  test::ScriptedSource source;
  test::TemporaryFolder folder;
  std::unique_ptr<ForceDevice> device;
};

std::unique_ptr<Rig> simulated(const std::string& uri) {
  auto rig = std::make_unique<Rig>();
  auto device = open_sim_device(*Uri::parse(uri), {&rig->source, nullptr});
  EXPECT_TRUE(device) << device.error().message();
  rig->device = std::move(*device);
  return rig;
}

/// Ten seconds; the index finger has a gap, the times jitter by `jitter_s`.
std::unique_ptr<Rig> replayed(double jitter_s, const std::string& query) {
  auto rig = std::make_unique<Rig>();
  std::string text;
  for (const auto& name : finger_forces_columns()) text += name + ",";
  text.back() = '\n';
  FingerForcesRow row;
  for (int k = 0; k < 1000; ++k) {
    row.t_s = 0.01 * k + (k % 3 == 1 ? jitter_s : 0.0);
    row.wrench_C = rig->source.press(row.t_s);
    row.present = {true, k % 50 != 7, true};
    append_finger_forces(text, row);
  }
  auto device =
      open_replay_device(*Uri::parse("replay://" + rig->folder.write("f.csv", text) + query));
  EXPECT_TRUE(device) << device.error().message();
  rig->device = std::move(*device);
  return rig;
}

/// Real driver and emulated sensors on a bus made of memory.
std::unique_ptr<Rig> wired(const FamilyFacts& family, int fir_taps = 0, double rate_Hz = 100.0) {
  auto rig = std::make_unique<Rig>();
  DeviceConfig config = DeviceConfig::standard(family);
  config.rate_Hz = rate_Hz;
  config.fir_taps = fir_taps;
  EmulatorOptions options;
  options.config = config;
  constexpr int kSensorNoise = 3;
  options.noise_counts = kSensorNoise;
  test::SensorBench bench(options, config);
  bench.bus->log_sent = false;
  rig->device = std::move(bench.device);
  return rig;
}

struct Maker {
  std::string name;
  std::function<std::unique_ptr<Rig>()> make;
};
const Maker kRepeatable[] = {
    {"sim", [] { return simulated("sim://healthy?seed=7"); }},
    {"sim_dropping", [] { return simulated("sim://paretic?seed=7&rate=250&drop=0.1"); }},
    {"replay", [] { return replayed(0.0, ""); }},
    {"replay_irregular", [] { return replayed(0.003, ""); }},
    {"replay_slow", [] { return replayed(0.0, "?speed=0.5"); }},
    {"replay_no_waiting", [] { return replayed(0.0, "?speed=0"); }},
};
/// Every family of sensors, and two of them fast. Real sensors run on, each by its own clock: what
/// they send is never the same twice.
std::vector<Maker> wired_devices() {
  std::vector<Maker> makers;
  for (const FamilyFacts* family : test::emulated_families())
    makers.push_back({test::test_name(*family), [family] { return wired(*family); }});
  makers.push_back({"rft_500Hz_fir", [] { return wired(kRftFamily, 33, 500.0); }});
  makers.push_back({"net_ft_1kHz_fir", [] { return wired(kNetFtFamily, 65, 1000.0); }});
  return makers;
}

class DeviceContract : public ::testing::TestWithParam<Maker> {
 protected:
  void SetUp() override {
    rig_ = GetParam().make();
    clock_.wait_until(kStart);
  }
  ForceDevice& device() { return *rig_->device; }
  void start() { ASSERT_TRUE(device().start(clock_)); }

  std::unique_ptr<Rig> rig_;
  ManualClock clock_;
};

class RepeatableDevice : public DeviceContract {};

TEST_P(DeviceContract, StampsIncreasePerFingerAndNoneLiesBeforeTheStart) {
  start();
  std::array<Timestamp, kFingerCount> last;
  last.fill(kStart - Timestamp{1});
  SensorSample sample;
  for (int n = 0; n < 1500; ++n) {
    ASSERT_EQ(device().read(kStart + 60 * kSecond, sample), ReadStatus::sample);
    Timestamp& previous = last[index_of(sample.finger)];
    EXPECT_GT(sample.stamp, previous);
    EXPECT_GE(sample.stamp, kStart);
    previous = sample.stamp;
  }
}

TEST_P(DeviceContract, ADeadlineBeforeTheNextSampleIsATimeoutAndLosesNothing) {
  start();
  SensorSample sample;
  int samples = 0;
  int timeouts = 0;
  const Timestamp begin = clock_.now();
  std::array<Timestamp, kFingerCount> last;
  last.fill(kStart - Timestamp{1});
  for (Timestamp deadline = begin; deadline < begin + kSecond; deadline += kSecond / 1000) {
    ReadStatus status;
    while ((status = device().read(deadline, sample)) == ReadStatus::sample) {
      EXPECT_LE(sample.stamp, deadline);
      EXPECT_GT(sample.stamp, last[index_of(sample.finger)]);
      last[index_of(sample.finger)] = sample.stamp;
      ++samples;
    }
    ASSERT_EQ(status, ReadStatus::timeout);
    EXPECT_GE(device().now(clock_), deadline) << "time must pass while a reader waits";
    ++timeouts;
  }
  EXPECT_EQ(timeouts, 1000);
  const int slots = static_cast<int>(std::lround(1.0 / device().info().sample_period_s));
  EXPECT_NEAR(samples, 3 * slots, 3);
}

TEST_P(DeviceContract, CountersNeverDecreaseAndAddUp) {
  start();
  DeviceHealth before = device().health();
  EXPECT_EQ(before.state, DeviceState::streaming);
  std::uint64_t received = 0;
  std::uint64_t received_invalid = 0;
  SensorSample sample;
  while (received < 1500 && device().read(kStart + 60 * kSecond, sample) == ReadStatus::sample) {
    ++received;
    if (!sample.valid) ++received_invalid;
    const DeviceHealth now = device().health();
    std::uint64_t counted = 0;
    std::uint64_t counted_invalid = 0;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const SensorCounters& a = before.sensors[f];
      const SensorCounters& b = now.sensors[f];
      EXPECT_TRUE(b.good >= a.good && b.invalid >= a.invalid && b.torn >= a.torn &&
                  b.duplicate >= a.duplicate && b.late >= a.late && b.lost >= a.lost &&
                  b.stale >= a.stale && b.saturated >= a.saturated && b.overload >= a.overload &&
                  b.status_errors >= a.status_errors && b.restarts >= a.restarts);
      EXPECT_LE(b.saturated, b.good);
      counted += b.good + b.invalid;
      counted_invalid += b.invalid;
    }
    EXPECT_EQ(counted, received);
    EXPECT_EQ(counted_invalid, received_invalid);
    before = now;
  }
  EXPECT_EQ(received, 1500U);
}

TEST_P(DeviceContract, ReadingAllocatesNothing) {
  start();
  SensorSample sample;
  const auto before = test::allocations();
  for (int n = 0; n < 1500; ++n) (void)device().read(kStart + 60 * kSecond, sample);
  (void)device().health();
  (void)device().now(clock_);
  EXPECT_EQ(test::allocations(), before);
}

TEST_P(RepeatableDevice, StartedAgainItSendsTheSameBytes) {
  const auto bytes = [this] {
    std::string all;
    const auto put = [&all](const auto& value) {
      char raw[sizeof value];
      std::memcpy(raw, &value, sizeof value);
      all.append(raw, sizeof raw);
    };
    const Timestamp begin = clock_.now();
    SensorSample sample;
    for (int n = 0; n < 900; ++n) {
      EXPECT_EQ(device().read(begin + 60 * kSecond, sample), ReadStatus::sample);
      put(sample.finger);
      put((sample.stamp - begin).count());
      for (const double value :
           {sample.wrench_C.force.x(), sample.wrench_C.force.y(), sample.wrench_C.force.z(),
            sample.wrench_C.torque.x(), sample.wrench_C.torque.y(), sample.wrench_C.torque.z()})
        put(value);
      for (const auto counts : sample.raw_counts) put(counts);
      put(sample.valid);
      put(sample.flags);
    }
    return all;
  };
  start();
  const std::string first = bytes();
  device().stop();
  rig_->source = {};
  start();
  EXPECT_EQ(bytes(), first);
}

TEST_P(DeviceContract, SaysWhatItIsAndStopsCleanly) {
  const DeviceInfo& info = device().info();
  EXPECT_FALSE(info.uri.empty());
  EXPECT_FALSE(info.description.empty());
  EXPECT_FALSE(info.simulated && info.recorded);
  EXPECT_GT(info.sample_period_s, 0.0);
  EXPECT_GE(info.frame_period_s, 0.001);
  EXPECT_LE(info.frame_period_s, 0.02);
  EXPECT_LE(device().health().state, DeviceState::configured);
  start();
  SensorSample sample;
  EXPECT_EQ(device().read(kStart + kSecond, sample), ReadStatus::sample);
  device().stop();
  EXPECT_EQ(device().read(kStart + kSecond, sample), ReadStatus::finished);
  EXPECT_EQ(device().health().state, DeviceState::configured);
}

std::string name_of_maker(const ::testing::TestParamInfo<Maker>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(Repeatable, DeviceContract, ::testing::ValuesIn(kRepeatable),
                         name_of_maker);
INSTANTIATE_TEST_SUITE_P(Wired, DeviceContract, ::testing::ValuesIn(wired_devices()),
                         name_of_maker);
INSTANTIATE_TEST_SUITE_P(Repeatable, RepeatableDevice, ::testing::ValuesIn(kRepeatable),
                         name_of_maker);

}  // namespace
}  // namespace isograsp::device_contract_test
