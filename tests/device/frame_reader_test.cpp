// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/frame_reader.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::frame_reader_test {
namespace {

using namespace std::chrono_literals;

/// Three sensors of 100 Hz, 2 ms apart, whose samples wait until they are read, as in a kernel's
/// queue. One of them may be silent.
class Queue final : public ForceDevice {
 public:
  explicit Queue(std::optional<Finger> silent = std::nullopt) : silent_(silent) {}
  const DeviceInfo& info() const noexcept override { return info_; }
  DeviceHealth health() const noexcept override { return {}; }
  Result<void> start(Clock& clock) override {
    clock_ = &clock;
    return {};
  }
  ReadStatus read(Timestamp deadline, SensorSample& out) noexcept override {
    while (silent_ && index_of(*silent_) == next_ % kFingerCount) ++next_;
    const std::size_t f = next_ % kFingerCount;
    const Timestamp stamp = (next_ / kFingerCount) * 10ms + f * 2ms + 1ms;
    if (stamp > std::max(deadline, clock_->now())) {
      clock_->wait_until(deadline);
      return ReadStatus::timeout;
    }
    clock_->wait_until(stamp);
    out = SensorSample{};
    out.finger = kFingers[f];
    out.stamp = stamp;
    out.wrench_C.force.z() = to_seconds(stamp);
    ++next_;
    return ReadStatus::sample;
  }
  void stop() noexcept override {}

 private:
  DeviceInfo info_;
  std::optional<Finger> silent_;
  Clock* clock_ = nullptr;
  std::size_t next_ = 0;
};

TEST(FrameReader, APauseOfThisComputerMakesFramesLateNotEmpty) {
  Queue device;
  ManualClock clock;
  ASSERT_TRUE(device.start(clock).ok());
  FrameReader frames(device, clock, 0ms);
  FingerFrame frame;
  double largest_lateness_s = 0.0;
  for (int n = 0; n < 500; ++n) {
    if (n % 100 == 50) clock.wait_until(clock.now() + 700ms);  // longer than any deadline
    ASSERT_TRUE(frames.next(frame));
    largest_lateness_s = std::max(largest_lateness_s, frames.lateness_s(frame));
    EXPECT_EQ(frame.slot, n);
    if (n == 0) continue;  // before the first samples
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      EXPECT_EQ(frame.flags[f], 0) << n;
      constexpr double kRounding_N = 1e-12;
      EXPECT_WITHIN(frame.wrench_C[f].force.z(), frame.t_s, kRounding_N) << "the line between";
    }
  }
  EXPECT_GT(largest_lateness_s, 0.6);
}

TEST(FrameReader, ASilentSensorIsMissingAndHoldsNobodyUp) {
  Queue device(Finger::middle);
  ManualClock clock;
  ASSERT_TRUE(device.start(clock).ok());
  FrameReader frames(device, clock, 0ms);
  FingerFrame frame;
  for (int n = 0; n < 300; ++n) {
    if (n == 150) clock.wait_until(clock.now() + 500ms);
    ASSERT_TRUE(frames.next(frame));
    EXPECT_EQ(frame.flags[2], bit(SampleFlag::missing));
    if (n > 0) {
      EXPECT_EQ(frame.flags[0] | frame.flags[1], 0) << n;
    }
    if (n > 0 && n < 150) {
      EXPECT_LE(frames.lateness_s(frame), 0.020 + 1e-9);  // the deadline of a slot
    }
  }
}

}  // namespace
}  // namespace isograsp::frame_reader_test
