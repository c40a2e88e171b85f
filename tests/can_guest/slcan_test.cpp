// SPDX-License-Identifier: GPL-3.0-or-later
// The driver's bus on an interface with error states and a short transmit queue: a serial adapter
// in software behind the kernel's slcan driver. Every trouble is named, what is lost is counted,
// and the same bus works again when the cause is gone.
#include <algorithm>
#include <cstdio>
#include <map>

#include "tests/can_guest/adapter_side.hpp"

namespace isograsp {
namespace {

using namespace std::chrono_literals;
using test::AdapterSide;
using test::ip_link;
using test::kLong;
using test::kRecovery;
using test::number_of;
using test::numbered;

constexpr std::uint32_t kFromAdapter = 0x123;
constexpr std::uint32_t kToAdapter = 0x064;

class Slcan : public testing::Test {
 protected:
  // One adapter for all: the kernel needs a second to take one away.
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
    bus_ = open_bus();
    ASSERT_NE(bus_, nullptr);
  }

  std::unique_ptr<Bus> open_bus() {
    const std::array<std::uint32_t, 1> ids{kFromAdapter};
    auto opened = open_socketcan(interface_, ids);
    if (!opened) {
      ADD_FAILURE() << opened.error().message();
      return nullptr;
    }
    EXPECT_TRUE((*opened)->start(clock_).ok());
    return *std::move(opened);
  }

  /// Receives until `reached` or the time is over; true: reached.
  template <class Reached>
  bool receive_until(Timestamp longest, Reached reached, int least_looks = test::kLeastLooks) {
    ReceivedFrame in;
    const Timestamp end = clock_.now() + longest;
    for (int looks = 0; !reached(); ++looks) {
      if (clock_.now() >= end && looks >= least_looks) return false;
      const BusEvent event = bus_->receive(clock_.now() + std::min<Timestamp>(longest, 5ms), in);
      if (event == BusEvent::frame) received_.push_back(number_of(in.frame));
      if (event != BusEvent::frame && event != BusEvent::timeout) {
        events_.push_back(event);
        EXPECT_EQ(in.frame.error, event <= BusEvent::bus_off);
      }
    }
    return true;
  }
  bool receive_for(Timestamp time) {
    return receive_until(
        time, [] { return false; }, 1);
  }
  void receive_until_quiet() {
    std::size_t before = 0;
    do {
      before = received_.size();
      receive_for(50ms);
    } while (before != received_.size());
  }
  bool receive_until_event(BusEvent event, Timestamp longest = kRecovery) {
    return receive_until(longest, [&] { return std::ranges::count(events_, event) > 0; });
  }
  /// Until a frame comes that was sent after this call.
  bool receive_until_new_frame() {
    const auto before = received_.size();
    const Timestamp began = clock_.now();
    const bool came = receive_until(kRecovery, [&] { return received_.size() > before; });
    std::printf("works again after %.0f ms\n", to_seconds(clock_.now() - began) * 1e3);
    return came;
  }
  void expect_every_number(std::uint32_t sent) {
    (void)receive_until(kLong, [&] { return received_.size() >= sent; });
    ASSERT_EQ(received_.size(), sent);
    for (std::uint32_t k = 0; k < sent; ++k) ASSERT_EQ(received_[k], k);
  }
  /// What the far end has heard, once it is so much or the time is over.
  std::vector<BusFrame> heard_at_least(std::size_t number) {
    (void)receive_until(kLong, [&] { return far_->heard().size() >= number; });
    return far_->heard();
  }
  [[nodiscard]] std::size_t times(BusEvent event) const {
    return static_cast<std::size_t>(std::ranges::count(events_, event));
  }

  std::string interface_;
  SteadyClock clock_;
  static inline std::unique_ptr<AdapterSide> far_;
  std::unique_ptr<Bus> bus_;
  std::vector<std::uint32_t> received_;
  std::vector<BusEvent> events_;
};

TEST_F(Slcan, FramesGoBothWaysOnceAndInOrder) {
  far_->ask([](SlcanAdapter& adapter) {
    EXPECT_TRUE(adapter.is_open());
    EXPECT_EQ(adapter.bit_rate(), 1'000'000u);
  });
  constexpr std::uint32_t kFrames = 500;
  far_->stream(kFromAdapter);
  for (std::uint32_t k = 0; k < kFrames; ++k) {
    EXPECT_TRUE(bus_->send(numbered(kToAdapter, k)));
    receive_for(1ms);
  }
  const auto sent = far_->end_stream();
  receive_for(50ms);
  EXPECT_GT(sent, 100u);
  expect_every_number(sent);
  const auto heard = heard_at_least(kFrames);
  ASSERT_EQ(heard.size(), kFrames);
  for (std::uint32_t k = 0; k < kFrames; ++k) ASSERT_EQ(heard[k], numbered(kToAdapter, k));
  EXPECT_TRUE(events_.empty());
  EXPECT_EQ(bus_->counters().unsent + bus_->counters().kernel_drops, 0u);
}

TEST_F(Slcan, ErrorStatesAreToldWhileTheBusWorks) {
  far_->stream(kFromAdapter);
  for (const auto fault :
       {AdapterFault::error_warning, AdapterFault::bit_error, AdapterFault::error_passive,
        AdapterFault::missing_acknowledgement, AdapterFault::error_active}) {
    far_->inject(fault);
    receive_for(30ms);
  }
  const auto sent = far_->end_stream();
  (void)receive_until(kLong, [&] { return bus_->counters().error_frames >= 5; });
  EXPECT_EQ(events_, (std::vector{BusEvent::error_warning, BusEvent::error_passive,
                                  BusEvent::error_active}));
  EXPECT_EQ(bus_->counters().error_frames, 5u);
  expect_every_number(sent);
}

TEST_F(Slcan, OverflowsAreToldAndCounted) {
  for (int k = 0; k < 3; ++k) far_->inject(AdapterFault::receive_overflow);
  for (int k = 0; k < 2; ++k) far_->inject(AdapterFault::transmit_overflow);
  (void)receive_until(kLong, [&] { return events_.size() >= 5; });
  EXPECT_EQ(events_, std::vector<BusEvent>(5, BusEvent::overflow));
  EXPECT_EQ(bus_->counters().overflows, 5u);
}

TEST_F(Slcan, BusOffIsToldAndWhatIsSentMeanwhileIsCounted) {
  far_->stream(kFromAdapter);
  receive_for(50ms);
  far_->inject(AdapterFault::bus_off);
  ASSERT_TRUE(receive_until_event(BusEvent::bus_off));
  const auto before = far_->heard().size();
  for (std::uint32_t k = 0; k < 100; ++k) {
    EXPECT_TRUE(bus_->send(numbered(kToAdapter, k))) << "the kernel takes what it cannot send";
    receive_for(1ms);
  }
  EXPECT_EQ(bus_->counters().unsent, 100u);
  EXPECT_EQ(far_->heard().size(), before);

  // Who opens the interface now gets no error frame any more, but is told.
  {
    const auto late = open_bus();
    ASSERT_NE(late, nullptr);
    ReceivedFrame in;
    EXPECT_EQ(late->receive(clock_.now() + 1s, in), BusEvent::bus_off);
  }
  ASSERT_TRUE(ip_link("set " + interface_ + " down"));
  ASSERT_TRUE(receive_until_event(BusEvent::interface_down));
  ASSERT_TRUE(ip_link("set " + interface_ + " up"));
  EXPECT_TRUE(receive_until_new_frame());
  EXPECT_TRUE(receive_until_event(BusEvent::restarted));
  EXPECT_EQ(times(BusEvent::interface_down), 1u);
  const auto sent = far_->end_stream();
  receive_for(50ms);
  EXPECT_TRUE(bus_->send(numbered(kToAdapter, 100)));
  receive_for(50ms);
  const auto heard = heard_at_least(before + 1);
  ASSERT_EQ(heard.size(), before + 1);
  EXPECT_EQ(number_of(heard.back()), 100u);
  EXPECT_EQ(bus_->counters().unsent, 100u);
  expect_every_number(sent);  // the adapter took nothing while it was off
}

TEST_F(Slcan, AFullTransmitQueueKeepsNothingStale) {
  far_->inject(AdapterFault::stall);
  std::vector<Timestamp> sent_at;
  const auto send_for = [&](Timestamp time) {
    for (const Timestamp end = clock_.now() + time; clock_.now() < end;) {
      sent_at.push_back(clock_.now());
      (void)bus_->send(numbered(kToAdapter, static_cast<std::uint32_t>(sent_at.size() - 1)));
      receive_for(1ms);
    }
  };
  send_for(300ms);
  const Timestamp resumed_at = clock_.now();
  far_->inject(AdapterFault::resume);
  send_for(100ms);
  receive_for(100ms);

  const auto heard = heard_at_least(sent_at.size() - bus_->counters().unsent);
  const auto unsent = bus_->counters().unsent;
  EXPECT_GT(unsent, 50u) << "the queue was never full";
  EXPECT_EQ(heard.size() + unsent, sent_at.size());
  // What the kernel had taken before the queue was full can not be called back.
  std::size_t in_kernel = 0;
  while (in_kernel < heard.size() && number_of(heard[in_kernel]) == in_kernel) ++in_kernel;
  for (std::size_t k = in_kernel; k < heard.size(); ++k) {
    ASSERT_GT(number_of(heard[k]), number_of(heard[k - 1]));
    EXPECT_GE(sent_at[number_of(heard[k])], resumed_at - 10ms);
  }
  EXPECT_EQ(number_of(heard.back()), sent_at.size() - 1);
  EXPECT_TRUE(events_.empty());
  std::printf("%zu sent: %zu waited in the kernel, %zu came later, %llu given up\n", sent_at.size(),
              in_kernel, heard.size() - in_kernel, static_cast<unsigned long long>(unsent));
}

TEST_F(Slcan, AnInterfaceThatIsSwitchedOffAndOn) {
  far_->stream(kFromAdapter);
  receive_for(50ms);
  ASSERT_TRUE(ip_link("set " + interface_ + " down"));
  ASSERT_TRUE(receive_until_event(BusEvent::interface_down));
  for (std::uint32_t k = 0; k < 10; ++k) (void)bus_->send(numbered(kToAdapter, k));
  receive_for(50ms);
  EXPECT_EQ(bus_->counters().unsent, 10u);
  EXPECT_EQ(events_, std::vector{BusEvent::interface_down}) << "told once";
  ASSERT_TRUE(ip_link("set " + interface_ + " up"));
  EXPECT_TRUE(receive_until_new_frame());
  EXPECT_TRUE(receive_until_event(BusEvent::restarted));
  EXPECT_EQ(events_.size(), 2u);
  const auto sent = far_->end_stream();
  receive_for(50ms);
  EXPECT_TRUE(std::ranges::is_sorted(received_));
  // The adapter may have taken a few frames that the kernel refused while it switched.
  EXPECT_GE(received_.size() + 20, sent);
  EXPECT_EQ(far_->heard().size(), 0u);
}

TEST_F(Slcan, AnAdapterThatIsUnpluggedAndPluggedInAgain) {
  far_->stream(kFromAdapter);
  receive_for(50ms);
  far_->inject(AdapterFault::unplug);
  ASSERT_TRUE(receive_until_event(BusEvent::interface_gone, kLong));
  const auto before = bus_->counters().unsent;
  for (std::uint32_t k = 0; k < 10; ++k) (void)bus_->send(numbered(kToAdapter, k));
  receive_for(50ms);
  EXPECT_EQ(bus_->counters().unsent, before + 10);
  far_->inject(AdapterFault::plug_in);
  EXPECT_TRUE(receive_until_new_frame());
  EXPECT_TRUE(receive_until_event(BusEvent::restarted));
  EXPECT_EQ(times(BusEvent::interface_gone), 1u);
  EXPECT_TRUE(bus_->send(numbered(kToAdapter, 10)));
  receive_for(50ms);
  const auto heard = heard_at_least(1);
  ASSERT_GE(heard.size(), 1u);
  EXPECT_EQ(number_of(heard.back()), 10u);
}

TEST_F(Slcan, FramesThatNobodyReadsAreCountedByTheKernel) {
  constexpr std::uint32_t kFrames = 6000;
  std::uint32_t sent = 0;
  for (int burst = 0; burst < 60; ++burst) {
    far_->ask([&](SlcanAdapter& adapter) {
      for (std::uint32_t k = 0; k < kFrames / 60; ++k)
        if (adapter.send(numbered(kFromAdapter, sent))) ++sent;
    });
  }
  receive_until_quiet();
  EXPECT_LT(received_.size(), sent) << "the buffer was large enough for all";
  far_->ask([&](SlcanAdapter& adapter) {
    if (adapter.send(numbered(kFromAdapter, sent))) ++sent;
  });
  receive_for(100ms);  // the number comes with the first frame after the loss
  EXPECT_EQ(received_.size() + bus_->counters().kernel_drops, sent);
  EXPECT_EQ(received_.back(), sent - 1);
}

TEST(SlcanAdapter, SaysWhatItNeeds) {
  const auto bad_name = SlcanAdapter::open("a name that is far too long");
  ASSERT_FALSE(bad_name.ok());
  EXPECT_EQ(bad_name.error().code, Error::Code::bad_input);
  const auto taken = SlcanAdapter::open("lo");
  ASSERT_FALSE(taken.ok());
  EXPECT_NE(taken.error().message().find("already"), std::string::npos);
}

}  // namespace
}  // namespace isograsp
