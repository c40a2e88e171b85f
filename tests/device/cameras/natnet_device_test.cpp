// SPDX-License-Identifier: GPL-3.0-or-later
// What is special about NatNet: versions, groups, and a computer that is there without a
// connection.
#include "device/bus/udp_port.hpp"
#include "tests/device/cameras/marker_servers.hpp"

namespace isograsp::natnet_device_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr Timestamp kPatience = 15s;

template <class Done>
bool read_until(MarkerDevice& device, SteadyClock& clock, Done&& done) {
  const Timestamp end = clock.now() + kPatience;
  MarkerSample sample;
  while (clock.now() < end)
    if (done(device.read(clock.now() + 5ms, sample), sample)) return true;
  return false;
}
std::string start_problem(const std::string& uri) {
  SteadyClock clock;
  auto device = open_cameras(uri);
  const auto begun = device->start(clock);
  if (begun) return "started";
  const std::string message = begun.error().message();
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_NE(message.find(uri), std::string::npos);
  return message;
}

TEST(NatNetDevice, SaysThatNobodyAnswers) {
  UdpPort deaf;  // takes what comes and says nothing
  must(deaf.open({kThisComputer, 0}, false));
  EXPECT_NE(start_problem("natnet://" + deaf.local().text()).find("nobody answers at"),
            std::string::npos);
}

TEST(NatNetDevice, SaysThatThereAreNoMarkers) {
  MarkerPlay nothing;
  nothing.t_s = {0.0, 0.01};
  const auto unlabelled = natnet_server(nothing);
  EXPECT_NE(start_problem("natnet://" + unlabelled->address().text()).find("no labelled markers"),
            std::string::npos);
}

TEST(NatNetDevice, SaysThatNoPicturesCome) {
  const auto still = natnet_server(marker_play(10), {"silence@0s"});
  EXPECT_NE(start_problem("natnet://" + still->address().text()).find("sends no pictures here"),
            std::string::npos);
}

TEST(NatNetDevice, RefusesAVersionThatItDoesNotKnow) {
  for (const NatNetVersion version : {NatNetVersion{2, 4}, {4, 2}, {5, 0}}) {
    const auto server = natnet_server(marker_play(100), {}, version);
    const std::string problem = start_problem("natnet://" + server->address().text());
    EXPECT_NE(problem.find("NatNet " + version.text() + ", which is not known"), std::string::npos)
        << problem;
  }
}

TEST(NatNetDevice, AComputerThatFallsSilentForLongIsLostAndFoundAgain) {
  auto server = natnet_server(marker_play(4000, 200.0));
  const Endpoint address = server->address();
  SteadyClock clock;
  auto device = open_cameras(uri_of("natnet", *server));
  must(device->start(clock));
  server.reset();
  bool silent = false;
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus, MarkerSample&) {
    silent = silent || device->health().fault == MarkerFault::silence;
    return device->health().fault == MarkerFault::connection_lost;
  }));
  EXPECT_TRUE(silent) << "first it only says nothing";
  EmulatedNatNetOptions options;
  RunningServer again(must(open_natnet_server(address, scene(marker_play(4000, 200.0)), options)));
  EXPECT_TRUE(read_until(*device, clock, [&](ReadStatus status, MarkerSample&) {
    return status == ReadStatus::sample && device->health().counters.restarts == 1;
  }));
}

TEST(NatNetDevice, HearsAMulticastGroup) {
  UdpPort probe;
  must(probe.open({0, 0}, true));
  constexpr std::uint32_t kGroup = 0xEFFF2A64;  // 239.255.42.100
  if (!probe.join(kGroup, kThisComputer)) GTEST_SKIP() << "no multicast on this computer";
  EmulatedNatNetOptions options;
  options.group = kGroup;
  options.data_port = probe.local().port;
  probe.close();
  RunningServer server(
      must(open_natnet_server({kThisComputer, 0}, scene(marker_play(2000, 200.0)), options)));
  SteadyClock clock;
  auto device = open_cameras("natnet://" + server.address().text() +
                             "?local=127.0.0.1&multicast=239.255.42.100");
  must(device->start(clock));
  EXPECT_TRUE(read_until(*device, clock, [&](ReadStatus status, MarkerSample&) {
    return status == ReadStatus::sample;
  }));
}

TEST(NatNetDevice, ReadsItsUri) {
  const auto refusal = [](const std::string& uri) {
    const auto device = open_marker_device(must(Uri::parse(uri)));
    return device ? "accepted" : device.error().message();
  };
  EXPECT_EQ(refusal("natnet://host?rig=r&local=10.0.0.2&multicast=239.255.42.99"), "accepted");
  EXPECT_NE(refusal("natnet://").find("is no computer"), std::string::npos);
  EXPECT_NE(refusal("natnet://h?local=here").find("local: 'here' is no address"),
            std::string::npos);
  EXPECT_NE(refusal("natnet://h?multicast=10.0.0.1").find("is no multicast group"),
            std::string::npos);
  EXPECT_NE(refusal("natnet://h?speed=1").find("unknown parameter"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::natnet_device_test
