// SPDX-License-Identifier: GPL-3.0-or-later
// What is special about each wire of a tracker of hands, and about its recordings.
#include <functional>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "device/hand/hand_csv.hpp"
#include "device/hand/hand_json.hpp"
#include "device/hand/leap_json.hpp"
#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::hand_wires_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr Timestamp kPatience = 10s;

bool read_until(HandDevice& device, Clock& clock,
                const std::function<bool(ReadStatus, HandSample&)>& done) {
  const Timestamp end = clock.now() + kPatience;
  HandSample sample;
  while (clock.now() < end)
    if (done(device.read(clock.now() + 5ms, sample), sample)) return true;
  return false;
}
std::string why_not_opened(const std::string& uri) {
  const auto device = open_hand_device(must(Uri::parse(uri)), Hand::right);
  return device ? "" : device.error().message();
}

TEST(LeapWire, TheVersionOfTheServiceIsTold) {
  const auto tracker = leap_tracker(hand_play(200, 100.0));
  SteadyClock clock;
  const auto device = open_hands("leap://" + tracker->address().text() + "?delay_ms=35");
  must(device->start(clock));
  EXPECT_EQ(device->info().service, "emulated");
  EXPECT_EQ(device->info().delay_s, 0.035);
  EXPECT_EQ(device->info().mounting, "desk");
  EXPECT_FALSE(device->info().recorded);
}

TEST(LeapWire, AConnectionThatWasClosedIsMadeAnew) {
  const auto tracker = leap_tracker(hand_play(300, 100.0), {"close@500ms"});
  SteadyClock clock;
  const auto device = open_hands("leap://" + tracker->address().text());
  must(device->start(clock));
  bool lost = false;
  double last_s = -1.0;
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus status, HandSample& sample) {
    const HandHealth health = device->health();
    lost = lost ||
           (health.fault == HandFault::connection_lost && health.state == DeviceState::faulted);
    if (status == ReadStatus::sample) {
      EXPECT_GT(sample.frame.t_s, last_s);
      last_s = sample.frame.t_s;
    }
    return lost && health.counters.restarts == 1;
  }));
  EXPECT_GT(device->health().counters.lost, 10U) << "a quarter of a second is missing";
}

TEST(LeapWire, AServiceThatStartsAgainIsFoundAndItsClockBelieved) {
  auto tracker = leap_tracker(hand_play(60, 100.0));
  const std::uint16_t port = tracker->address().port;
  SteadyClock clock;
  const auto device = open_hands("leap://127.0.0.1:" + std::to_string(port));
  must(device->start(clock));
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus, HandSample&) {
    return device->health().fault == HandFault::connection_lost;
  }));
  tracker.reset();
  tracker = leap_tracker(hand_play(300, 100.0), {}, port);
  double last_s = -1.0;
  EXPECT_TRUE(read_until(*device, clock, [&](ReadStatus status, HandSample& sample) {
    if (status != ReadStatus::sample) return false;
    EXPECT_GT(sample.frame.t_s, last_s);
    last_s = sample.frame.t_s;
    return device->health().counters.restarts == 1 && sample.frame.tracked;
  }));
}

/// A peer that is no Leap service.
class Peer {
 public:
  explicit Peer(std::function<void(int)> talk) : talk_(std::move(talk)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(kHandComputer);
    socklen_t size = sizeof at;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&at), size), 0);
    EXPECT_EQ(::listen(listener_, 4), 0);
    EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&at), &size), 0);
    port_ = ntohs(at.sin_port);
    thread_ = std::thread([this] {
      for (;;) {
        const int one = ::accept(listener_, nullptr, nullptr);
        if (one < 0) return;
        talk_(one);
        ::close(one);
      }
    });
  }
  ~Peer() {
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  [[nodiscard]] std::string uri() const { return "leap://127.0.0.1:" + std::to_string(port_); }

 private:
  std::function<void(int)> talk_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

TEST(LeapWire, WhatAnswersAndIsNoServiceIsNamed) {
  const Peer peer([](int socket) {
    const std::string page = "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n";
    EXPECT_GT(::send(socket, page.data(), page.size(), MSG_NOSIGNAL), 0);
  });
  SteadyClock clock;
  const auto device = open_hands(peer.uri());
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find("not the Leap service"), std::string::npos)
      << begun.error().message();
  EXPECT_EQ(device->health().state, DeviceState::absent);
}

TEST(LeapWire, NobodyIsToldAtOnce) {
  SteadyClock clock;
  const auto device = open_hands("leap://127.0.0.1:" + std::to_string(free_udp_port()));
  const Timestamp begin = clock.now();
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find("nobody answers"), std::string::npos);
  EXPECT_LT(clock.now() - begin, 2s);
}

TEST(LeapWire, UrisThatAreWrongNameTheRemedy) {
  for (const auto& [uri, part] : every(std::vector<std::pair<std::string, std::string>>{
           {"leap://", "write leap://127.0.0.1"},
           {"leap://a:0", "is no computer with a port"},
           {"leap://127.0.0.1?speed=1", "unknown parameter of leap://"},
           {"leap://127.0.0.1?mounting=roof", "write desk, screen or head"},
           {"leap://127.0.0.1?delay_ms=-1", "is not a number that this parameter takes"},
           {"udp-hand://localhost", "no address of this computer in numbers"},
           {"udp-hand://0.0.0.0", "every computer of the network could send hands"},
           {"udp-hand://192.168.0.7:7000", "network=confirmed"},
           {"udp-hand://0.0.0.0?network=yes", "'yes' confirms nothing"},
           {"sim://hand?user=healthy", "nobody moves the simulated hand"},
           {"qtm://127.0.0.1", "no tracker of hands is called qtm://"},
           {"replay://", "no file is named"},
           {"replay:///no/such/file.csv", "/no/such/file.csv"}}))
    EXPECT_NE(why_not_opened(uri).find(part), std::string::npos)
        << uri << ": " << why_not_opened(uri);
  EXPECT_EQ(why_not_opened("udp-hand://0.0.0.0:6440?network=confirmed"), "");
}

TEST(UdpHandWire, ASecondSenderIsCountedAndNotHeard) {
  const std::uint16_t port = free_udp_port();
  const auto script = hand_script(hand_play(300, 100.0), port);
  SteadyClock clock;
  const auto device = open_hands("udp-hand://127.0.0.1:" + std::to_string(port));
  must(device->start(clock));
  UdpPort other;
  must(other.open({kHandComputer, 0}, false));
  constexpr double kElsewhere_m = 9.0;
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus status, HandSample& sample) {
    HandFrame hand = made_hand(Hand::right, 1, to_seconds(clock.now()));
    hand.joints[kWristJoint].x() = kElsewhere_m;
    const std::string text = hand_json(hand);
    other.send({kHandComputer, port},
               std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    if (status == ReadStatus::sample) {
      EXPECT_LT(sample.frame.joints[kWristJoint].x(), kElsewhere_m);
    }
    return device->health().counters.foreign > 20;
  }));
}

TEST(UdpHandWire, NobodyWhoSendsIsTold) {
  SteadyClock clock;
  const auto device = open_hands("udp-hand://127.0.0.1:" + std::to_string(free_udp_port()));
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find("nobody sends a hand"), std::string::npos);
}

TEST(UdpHandWire, APortThatIsTakenIsNamed) {
  UdpPort taken;
  must(taken.open({kHandComputer, 0}, false));
  SteadyClock clock;
  const auto device = open_hands("udp-hand://" + taken.local().text());
  const auto begun = device->start(clock);
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message().find(taken.local().text()), std::string::npos);
}

TEST(HandReplay, GivesTheRowsOfTheChosenHandInVirtualTimeWithoutAnAllocation) {
  const TemporaryFolder folder;
  const std::string path = folder.path("hands.csv");
  auto writer = must(HandCsvWriter::create(path));
  const HandPlay play = hand_play(40, 50.0, true);
  for (const HandFrame& hand : play.hands) writer.write(hand);
  must(writer.commit());
  const auto device = open_hands("replay://" + path, Hand::left);
  EXPECT_TRUE(device->info().recorded);
  EXPECT_EQ(device->info().period_s, 0.02);
  ManualClock clock;
  must(device->start(clock));
  HandSample sample;
  std::uint64_t allocated = 0;
  std::size_t row = 0;
  for (;;) {
    const auto before = allocations();
    const ReadStatus status = device->read(clock.now() + 1ms, sample);
    allocated += allocations() - before;
    if (status == ReadStatus::finished) break;
    if (status != ReadStatus::sample) continue;
    ASSERT_LT(row, 40U);
    const HandFrame& wanted = play.hands[2 * row + 1];
    EXPECT_EQ(sample.frame.side, Hand::left);
    EXPECT_EQ(sample.frame.t_s, wanted.t_s);
    EXPECT_EQ(sample.stamp, from_seconds(wanted.t_s)) << "the recording begins at 0 of this clock";
    EXPECT_EQ(sample.number, static_cast<std::int64_t>(row));
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      EXPECT_EQ(sample.frame.joints[j], wanted.joints[j]);
    ++row;
  }
  EXPECT_EQ(row, 40U);
  EXPECT_EQ(allocated, 0U);
  const HandHealth health = device->health();
  EXPECT_EQ(health.state, DeviceState::finished);
  EXPECT_EQ(health.counters.other_side, 40U);
  EXPECT_EQ(health.counters.lost, 0U);
}

}  // namespace
}  // namespace isograsp::hand_wires_test
