// SPDX-License-Identifier: GPL-3.0-or-later
// Three emulated RFT sensors behind a serial adapter in software, seen by the whole driver: the
// screen is told what is wrong, and forces flow again by themselves when the cause is gone.
#include <cstdio>

#include "device/emulator/emulator.hpp"
#include "device/sensors/force_device.hpp"
#include "tests/can_guest/adapter_side.hpp"
#include "tests/device/counting_play.hpp"

namespace isograsp {
namespace {

using namespace std::chrono_literals;
using test::AdapterSide;
using test::ip_link;
using test::kLong;
using test::kRecovery;

class SensorsOnAdapter : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!test::slcan_interface().empty())
      far_ = std::make_unique<AdapterSide>(test::slcan_interface());
  }
  static void TearDownTestSuite() { far_.reset(); }

  void SetUp() override {
    interface_ = test::slcan_interface();
    if (interface_.empty()) GTEST_SKIP() << "no software adapter here: needs root and slcan";
    ASSERT_TRUE(far_->ok());
    far_->begin_anew();
    emulator_ = std::make_shared<Emulator>(EmulatorOptions{}, test::counting_play(1000));
    far_->set_work(
        [emulator = emulator_](SlcanAdapter& adapter, Timestamp now) {
          for (BusFrame out; emulator->take(now, out);) (void)adapter.send(out);
          return emulator->next();
        },
        [emulator = emulator_](const ReceivedFrame& in) { emulator->receive(in.frame, in.stamp); });
    auto opened = open_device("can://" + interface_ + "?protocol=rft");
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    device_ = *std::move(opened);
    const auto started = device_->start(clock_);
    ASSERT_TRUE(started.ok()) << started.error().message();
  }
  void TearDown() override {
    if (!interface_.empty()) far_->set_work(nullptr, nullptr);
  }

  /// Reads until `reached` or the time is over; true: reached. Every sample must be one of those
  /// that the sensors felt.
  template <class Reached>
  bool read_until(Timestamp longest, Reached reached, int least_looks = test::kLeastLooks) {
    SensorSample sample;
    const Timestamp end = clock_.now() + longest;
    for (int looks = 0; !reached(); ++looks) {
      if (clock_.now() >= end && looks >= least_looks) return false;
      if (device_->read(clock_.now() + 5ms, sample) != ReadStatus::sample) continue;
      const std::size_t f = index_of(sample.finger);
      const auto expected = test::counting_wrench(test::row_of(sample.wrench_C, f), f);
      EXPECT_EQ(sample.wrench_C.force, expected.force);
      EXPECT_EQ(sample.wrench_C.torque, expected.torque);
      EXPECT_TRUE(stamps_[f].empty() || sample.stamp > stamps_[f].back());
      stamps_[f].push_back(sample.stamp);
    }
    return true;
  }
  void read_for(Timestamp time) {
    (void)read_until(
        time, [] { return false; }, 1);
  }
  testing::AssertionResult read_until_fault(DeviceFault fault, Timestamp longest = kRecovery) {
    if (read_until(longest, [&] { return device_->health().fault == fault; }))
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "the fault is " << name_of(device_->health().fault);
  }
  /// A busy computer may tear a sample, which is told then.
  bool read_until_other_than(DeviceFault fault, Timestamp longest = kRecovery) {
    return read_until(longest, [&] { return device_->health().fault != fault; }) &&
           !stops_forces(device_->health().fault);
  }
  /// Until every sensor has given a sample that came after this call.
  bool forces_flow_again() {
    const Timestamp began = clock_.now();
    const bool flow = read_until(kRecovery, [&] {
      return std::ranges::all_of(stamps_,
                                 [&](const auto& s) { return !s.empty() && s.back() > began; });
    });
    std::printf("forces flow again after %.0f ms\n", to_seconds(clock_.now() - began) * 1e3);
    return flow && !stops_forces(device_->health().fault);
  }
  /// The counters follow from the samples by the rule of docs/devices.md.
  void expect_counters_of_the_samples() const {
    const auto health = device_->health();
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      std::uint64_t lost = 0;
      for (std::size_t k = 1; k < stamps_[f].size(); ++k) {
        const double periods = to_seconds(stamps_[f][k] - stamps_[f][k - 1]) * test::kPlayRate_Hz;
        if (periods > 1.5) lost += static_cast<std::uint64_t>(std::llround(periods)) - 1;
      }
      EXPECT_EQ(health.sensors[f].lost, lost);
      EXPECT_EQ(health.sensors[f].good, stamps_[f].size());
    }
    EXPECT_EQ(health.foreign_frames, 0u);
  }

  std::string interface_;
  SteadyClock clock_;
  static inline std::unique_ptr<AdapterSide> far_;
  std::shared_ptr<Emulator> emulator_;
  std::unique_ptr<ForceDevice> device_;
  std::array<std::vector<Timestamp>, kFingerCount> stamps_;
};

TEST_F(SensorsOnAdapter, ABusWithErrorsIsToldAndForcesFlowOn) {
  read_for(100ms);
  const auto too_busy = [&] { return device_->health().fault == DeviceFault::damaged_samples; };
  for (const auto fault : {AdapterFault::error_warning, AdapterFault::error_passive}) {
    far_->inject(fault);
    const auto told = read_until_fault(DeviceFault::bus_warning, kLong);
    if (!told && too_busy()) GTEST_SKIP() << "this computer tears samples all the time";
    EXPECT_TRUE(told);
  }
  far_->inject(AdapterFault::error_active);
  EXPECT_TRUE(read_until_other_than(DeviceFault::bus_warning));
  far_->inject(AdapterFault::receive_overflow);
  const auto told = read_until_fault(DeviceFault::bus_overflow, kRecovery);
  EXPECT_TRUE(told || too_busy());
  EXPECT_EQ(device_->health().bus.overflows, 1u);
  EXPECT_TRUE(read_until_other_than(DeviceFault::bus_overflow, 2s)) << "told for a second";
  expect_counters_of_the_samples();
}

TEST_F(SensorsOnAdapter, BusOff) {
  read_for(100ms);
  far_->inject(AdapterFault::bus_off);
  EXPECT_TRUE(read_until_fault(DeviceFault::bus_off));
  read_for(300ms);
  EXPECT_EQ(device_->health().fault, DeviceFault::bus_off) << "told until the cause is gone";
  EXPECT_GT(device_->health().bus.unsent, 0u);
  ASSERT_TRUE(ip_link("set " + interface_ + " down"));
  EXPECT_TRUE(read_until_fault(DeviceFault::interface_down));
  ASSERT_TRUE(ip_link("set " + interface_ + " up"));
  EXPECT_TRUE(forces_flow_again());
  read_for(200ms);
  expect_counters_of_the_samples();
}

TEST_F(SensorsOnAdapter, AnAdapterThatStalls) {
  read_for(100ms);
  far_->inject(AdapterFault::stall);
  EXPECT_TRUE(read_until_fault(DeviceFault::silence));
  read_for(1s);  // the driver asks in vain, until the queue is full
  EXPECT_EQ(device_->health().fault, DeviceFault::silence);
  EXPECT_GT(device_->health().bus.unsent, 0u);
  far_->inject(AdapterFault::resume);
  EXPECT_TRUE(forces_flow_again());
  read_for(200ms);
  expect_counters_of_the_samples();
}

TEST_F(SensorsOnAdapter, AnAdapterThatIsUnpluggedAndPluggedInAgain) {
  read_for(100ms);
  far_->inject(AdapterFault::unplug);
  EXPECT_TRUE(read_until_fault(DeviceFault::interface_gone, kLong));
  read_for(300ms);
  EXPECT_EQ(device_->health().fault, DeviceFault::interface_gone);
  far_->inject(AdapterFault::plug_in);
  EXPECT_TRUE(read_until(kLong, [&] { return far_->is_open(); }));  // the kernel has made it again
  EXPECT_TRUE(forces_flow_again());
  read_for(200ms);
  expect_counters_of_the_samples();
}

}  // namespace
}  // namespace isograsp
