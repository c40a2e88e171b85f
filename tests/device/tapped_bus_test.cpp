// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/tapped_bus.hpp"

#include <deque>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/no_alloc.hpp"

namespace isograsp::tapped_bus_test {
namespace {

using namespace std::chrono_literals;

/// Gives what it was told to give; refuses every frame with the identifier 0.
class ScriptedBus final : public Bus {
 public:
  struct Step {
    BusEvent event;
    ReceivedFrame frame;
  };
  explicit ScriptedBus(std::deque<Step> steps) : steps_(std::move(steps)) {}

  Result<void> start(Clock&) override { return {}; }
  bool send(const BusFrame& frame) noexcept override { return frame.id != 0; }
  BusEvent receive(Timestamp, ReceivedFrame& out) noexcept override {
    if (steps_.empty()) return BusEvent::timeout;
    const Step step = steps_.front();
    steps_.pop_front();
    out = step.frame;
    return step.event;
  }
  BusCounters counters() const noexcept override { return {1, 2, 3, 4}; }

 private:
  std::deque<Step> steps_;
};

ReceivedFrame received(std::uint32_t id, Timestamp stamp, bool error = false) {
  ReceivedFrame in;
  in.frame.id = id;
  in.frame.error = error;
  in.stamp = stamp;
  in.wall_time = stamp + 1000s;
  return in;
}

BusFrame numbered(std::uint32_t id) {
  BusFrame frame;
  frame.id = id;
  frame.length = 1;
  frame.data[0] = static_cast<std::uint8_t>(id);
  return frame;
}

std::vector<TappedFrame> drain(BusTap& tap) {
  std::vector<TappedFrame> frames;
  for (TappedFrame frame; tap.ring.pop(frame);) frames.push_back(frame);
  return frames;
}

TEST(TappedBus, ShowsWhatGoesThroughInItsOrder) {
  const auto tap = std::make_shared<BusTap>(16);
  std::deque<ScriptedBus::Step> steps{{BusEvent::frame, received(7, 3ms)},
                                      {BusEvent::bus_off, received(0x40, 4ms, true)},
                                      {BusEvent::interface_gone, {}},
                                      {BusEvent::timeout, received(9, 5ms)}};
  TappedBus bus(std::make_unique<ScriptedBus>(steps), tap);
  ManualClock clock;
  ASSERT_TRUE(bus.start(clock).ok());
  clock.wait_until(2ms);
  EXPECT_TRUE(bus.send(numbered(5)));
  EXPECT_FALSE(bus.send(numbered(0)));
  ReceivedFrame in;
  for (const auto& step : steps) {
    EXPECT_EQ(bus.receive(10ms, in), step.event);
    EXPECT_EQ(in.frame, step.frame.frame);
  }
  EXPECT_EQ(bus.counters().unsent, 4u);

  const auto frames = drain(*tap);
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_TRUE(frames[0].sent);
  EXPECT_EQ(frames[0].frame, numbered(5));
  EXPECT_EQ(frames[0].stamp, 2ms);
  EXPECT_EQ(frames[0].wall_time, 2ms);
  EXPECT_FALSE(frames[1].sent);
  EXPECT_EQ(frames[1].frame.id, 7u);
  EXPECT_EQ(frames[1].stamp, 3ms);
  EXPECT_EQ(frames[1].wall_time, 1000s + 3ms);
  EXPECT_EQ(frames[2].frame.id, 0x40u);
  EXPECT_EQ(tap->overrun, 0u);
}

TEST(TappedBus, AFullTapCountsAndTheBusGoesOn) {
  const auto tap = std::make_shared<BusTap>(4);
  std::deque<ScriptedBus::Step> steps;
  for (std::uint32_t k = 0; k < 10; ++k) steps.push_back({BusEvent::frame, received(k, 1ms)});
  TappedBus bus(std::make_unique<ScriptedBus>(steps), tap);
  ManualClock clock;
  ASSERT_TRUE(bus.start(clock).ok());
  ReceivedFrame in;
  for (std::uint32_t k = 0; k < 10; ++k) {
    ASSERT_EQ(bus.receive(10ms, in), BusEvent::frame);
    EXPECT_EQ(in.frame.id, k);
  }
  EXPECT_EQ(drain(*tap).size() + tap->overrun, 10u);
  EXPECT_GT(tap->overrun, 0u);
}

TEST(TappedBus, NothingIsLostOrDoubledBetweenTwoThreads) {
  constexpr std::uint32_t kFrames = 200'000;
  const auto tap = std::make_shared<BusTap>(256);
  std::atomic<bool> done{false};
  std::vector<std::uint32_t> seen;
  seen.reserve(kFrames);
  std::thread reader([&] {
    TappedFrame frame;
    while (true) {
      const bool last = done.load();
      while (tap->ring.pop(frame)) seen.push_back(frame.frame.id);
      if (last) return;
    }
  });
  TappedBus bus(std::make_unique<ScriptedBus>(std::deque<ScriptedBus::Step>{}), tap);
  SteadyClock clock;
  ASSERT_TRUE(bus.start(clock).ok());
  const auto before = test::allocations();
  for (std::uint32_t k = 1; k <= kFrames; ++k) (void)bus.send(numbered(k));
  EXPECT_EQ(test::allocations(), before);
  done = true;
  reader.join();
  EXPECT_EQ(seen.size() + tap->overrun, kFrames);
  for (std::size_t k = 1; k < seen.size(); ++k) ASSERT_GT(seen[k], seen[k - 1]);
}

}  // namespace
}  // namespace isograsp::tapped_bus_test
