// SPDX-License-Identifier: GPL-3.0-or-later
// On real sockets of the loopback interface. Waiting times are only upper bounds.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "device/bus/bus.hpp"
#include "device/bus/endpoint.hpp"
#include "device/bus/kernel_stamp.hpp"
#include "device/codec/net_ft_sequence.hpp"
#include "device/emulator/emulator.hpp"
#include "device/emulator/net_ft_server.hpp"
#include "device/protocol/net_ft_session.hpp"
#include "device/sensors/sensor_device.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::udp_bus_test {
namespace {

using namespace std::chrono_literals;

constexpr Timestamp kPatience = 5s;  // for what comes at once
constexpr std::uint32_t kLoopback = 0x7F000001;

/// What a sensor has on its side.
class Peer {
 public:
  explicit Peer(std::uint16_t port = 0, std::uint32_t host = kLoopback)
      : socket_(::socket(AF_INET, SOCK_DGRAM, 0)), host_(host) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(host);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    socklen_t size = sizeof address;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    const timeval limit{5, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  }
  ~Peer() { ::close(socket_); }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const { return Endpoint{host_, port_}.text(); }
  /// The next datagram; its sender is the client from now on.
  std::vector<std::uint8_t> receive() {
    std::vector<std::uint8_t> bytes(1000);
    socklen_t size = sizeof client_;
    const auto n = ::recvfrom(socket_, bytes.data(), bytes.size(), 0,
                              reinterpret_cast<sockaddr*>(&client_), &size);
    EXPECT_GE(n, 0) << "nothing came";
    bytes.resize(n < 0 ? 0 : static_cast<std::size_t>(n));
    return bytes;
  }
  void send(std::span<const std::uint8_t> bytes) const { send_to(client_, bytes); }
  void send_to(const sockaddr_in& where, std::span<const std::uint8_t> bytes) const {
    EXPECT_EQ(::sendto(socket_, bytes.data(), bytes.size(), 0,
                       reinterpret_cast<const sockaddr*>(&where), sizeof where),
              static_cast<ssize_t>(bytes.size()));
  }
  [[nodiscard]] const sockaddr_in& client() const { return client_; }

 private:
  int socket_;
  std::uint32_t host_;
  std::uint16_t port_ = 0;
  sockaddr_in client_{};
};

/// A datagram that says who sent it and which one it is.
std::array<std::uint8_t, 5> numbered(std::size_t sensor, std::uint32_t number) {
  return {static_cast<std::uint8_t>(sensor), static_cast<std::uint8_t>(number >> 24),
          static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8),
          static_cast<std::uint8_t>(number)};
}
std::uint32_t number_of(const BusFrame& frame) {
  const auto& d = frame.data;
  return static_cast<std::uint32_t>(d[1] << 24 | d[2] << 16 | d[3] << 8 | d[4]);
}

class UdpBus : public testing::Test {
 protected:
  UdpBus() {
    auto opened = open_udp({peers[0].address(), peers[1].address(), peers[2].address()});
    EXPECT_TRUE(opened) << opened.error().message();
    bus = *std::move(opened);
    EXPECT_TRUE(bus->start(clock));
    for (std::uint32_t f = 0; f < kFingerCount; ++f) {
      EXPECT_TRUE(bus->send(hello(f)));
      EXPECT_EQ(peers[f].receive(),
                (std::vector<std::uint8_t>{0x12, static_cast<std::uint8_t>(f)}));
    }
  }
  static BusFrame hello(std::uint32_t sensor) {
    BusFrame frame;
    frame.id = sensor;
    frame.length = 2;
    frame.data = {0x12, static_cast<std::uint8_t>(sensor)};
    return frame;
  }
  BusEvent receive(ReceivedFrame& out) { return bus->receive(clock.now() + kPatience, out); }

  std::array<Peer, kFingerCount> peers;
  SteadyClock clock;
  std::unique_ptr<Bus> bus;
  ReceivedFrame in;
};

TEST_F(UdpBus, EveryDatagramArrivesOnceInOrderAndFromItsSensor) {
  constexpr std::uint32_t kDatagrams = 3000;
  std::array<std::uint32_t, kFingerCount> next{};
  for (std::uint32_t n = 0; n < kDatagrams; n += 30) {
    for (std::uint32_t k = n; k < n + 30; ++k)
      for (std::size_t f = 0; f < kFingerCount; ++f) peers[f].send(numbered(f, k));
    for (int k = 0; k < 90; ++k) {
      ASSERT_EQ(receive(in), BusEvent::frame);
      const std::size_t f = in.frame.id;
      ASSERT_LT(f, kFingerCount);
      ASSERT_EQ(in.frame.length, 5);
      ASSERT_EQ(in.frame.data[0], f);
      ASSERT_EQ(number_of(in.frame), next[f]++);
    }
  }
  EXPECT_EQ(bus->receive(clock.now(), in), BusEvent::timeout);
  EXPECT_EQ(bus->counters().kernel_drops, 0u);
  EXPECT_EQ(bus->counters().unsent, 0u);
}

/// The kernel stamps arrivals only some time after the first socket of the computer asked for it;
/// until then the stamp is that of the reading.
void wait_until_the_kernel_stamps(Bus& bus, const Peer& peer, SteadyClock& clock) {
  ReceivedFrame in;
  for (const Timestamp limit = clock.now() + kPatience; clock.now() < limit;) {
    peer.send(numbered(0, 0));
    const Timestamp sent = clock.now();
    std::this_thread::sleep_for(5ms);
    if (bus.receive(clock.now() + kPatience, in) == BusEvent::frame && in.stamp < sent + 1ms)
      return;
  }
}

TEST_F(UdpBus, StampsAreThoseOfTheArrivalNotOfTheReading) {
  wait_until_the_kernel_stamps(*bus, peers[1], clock);
  const Timestamp before = clock.now();
  const Timestamp wall_before = read_clock(CLOCK_REALTIME);
  for (std::uint32_t n = 0; n < 100; ++n) peers[1].send(numbered(1, n));
  const Timestamp after = clock.now();
  const Timestamp wall_after = read_clock(CLOCK_REALTIME);
  std::this_thread::sleep_for(20ms);  // this computer is busy; then it finds a backlog
  Timestamp last = before;
  constexpr Timestamp kMapping = 100us;  // between two clocks, known no better on a loaded computer
  for (std::uint32_t n = 0; n < 100; ++n) {
    ASSERT_EQ(receive(in), BusEvent::frame);
    EXPECT_EQ(number_of(in.frame), n);
    EXPECT_GE(in.stamp, last - kMapping);
    EXPECT_LE(in.stamp, after + kMapping);
    EXPECT_GE(in.wall_time, wall_before);
    EXPECT_LE(in.wall_time, wall_after);
    last = in.stamp;
  }
  EXPECT_EQ(bus->receive(clock.now(), in), BusEvent::timeout) << "nothing is left behind";
}

TEST_F(UdpBus, DatagramsOfStrangersStayOutside) {
  const Peer stranger;
  stranger.send_to(peers[0].client(), numbered(0, 1));
  peers[0].send(numbered(0, 2));
  ASSERT_EQ(receive(in), BusEvent::frame);
  EXPECT_EQ(number_of(in.frame), 2u);
  EXPECT_EQ(bus->receive(clock.now() + 10ms, in), BusEvent::timeout);
}

TEST_F(UdpBus, TellsTheLengthOfDatagramsThatAreTooLong) {
  const std::vector<std::uint8_t> bytes(1400, 0xAB);
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{64}, std::size_t{72}, std::size_t{255}, std::size_t{1400}}) {
    peers[2].send(std::span(bytes).first(length));
    ASSERT_EQ(receive(in), BusEvent::frame);
    EXPECT_EQ(in.frame.length, std::min<std::size_t>(length, 255));
    EXPECT_EQ(in.frame.bytes().size(), std::min<std::size_t>(length, 64));
  }
}

TEST_F(UdpBus, CountsWhatTheKernelDropped) {
  constexpr std::uint32_t kDatagrams = 20'000;  // more than the buffer holds
  for (std::uint32_t n = 0; n < kDatagrams; ++n) peers[0].send(numbered(0, n));
  std::uint32_t received = 0;
  while (bus->receive(clock.now(), in) == BusEvent::frame) ++received;
  ASSERT_LT(received, kDatagrams);
  peers[0].send(numbered(0, kDatagrams));  // brings the news
  ASSERT_EQ(receive(in), BusEvent::frame);
  EXPECT_EQ(received + bus->counters().kernel_drops, kDatagrams);
}

TEST_F(UdpBus, ASensorThatIsNotThereIsSilentAndWelcomeWhenItComes) {
  const std::uint16_t port = [] { return Peer().port(); }();  // nobody has it now
  auto opened =
      open_udp({peers[0].address(), Endpoint{kLoopback, port}.text(), peers[2].address()});
  ASSERT_TRUE(opened);
  Bus& other = **opened;
  ASSERT_TRUE(other.start(clock));
  // The kernel says "refused" after each; that must neither end nor blind anything.
  for (int n = 0; n < 5; ++n) {
    EXPECT_TRUE(other.send(hello(1)));
    EXPECT_EQ(other.receive(clock.now() + 5ms, in), BusEvent::timeout);
  }
  EXPECT_GT(other.counters().error_frames, 0u);
  Peer late(port);
  EXPECT_TRUE(other.send(hello(1)));
  EXPECT_EQ(late.receive().size(), 2u);
  late.send(numbered(1, 77));
  ASSERT_EQ(other.receive(clock.now() + kPatience, in), BusEvent::frame);
  EXPECT_EQ(number_of(in.frame), 77u);
}

TEST_F(UdpBus, WaitsUntilTheDeadlineAndNotBeyondTheFirstDatagram) {
  const Timestamp begin = clock.now();
  EXPECT_EQ(bus->receive(begin + 30ms, in), BusEvent::timeout);
  EXPECT_GE(clock.now(), begin + 30ms);
  std::thread later([&] {
    std::this_thread::sleep_for(20ms);
    peers[2].send(numbered(2, 5));
  });
  EXPECT_EQ(bus->receive(clock.now() + 60s, in), BusEvent::frame);
  later.join();
  EXPECT_EQ(in.frame.id, 2u);
}

TEST_F(UdpBus, DoesNotAllocate) {
  for (std::uint32_t n = 0; n < 2; ++n)
    EXPECT_EQ(bus->receive(clock.now() + 1ms, in), BusEvent::timeout);
  const auto bytes = numbered(0, 1);
  int received = 0;
  const auto before = test::allocations();
  for (int n = 0; n < 200; ++n) {
    peers[static_cast<std::size_t>(n % 3)].send(bytes);
    (void)bus->send(hello(static_cast<std::uint32_t>(n % 3)));
    received += receive(in) == BusEvent::frame ? 1 : 0;
    (void)bus->receive(clock.now() + 1ms, in);
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(received, 200);
}

TEST_F(UdpBus, LossRepetitionAndOrderOfTheNetworkAreCountedExactly) {
  std::mt19937_64 random(9);
  NetFtSequence sequence;
  std::uint64_t lost = 0;
  std::uint64_t twice = 0;
  std::uint32_t rdt = 0;
  const auto push = [&] {
    ASSERT_EQ(receive(in), BusEvent::frame);
    (void)sequence.push(decode_net_ft_record(in.frame.bytes()).value(), in.stamp);
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint32_t> batch;
    for (int k = 0; k < 20; ++k) {
      ++rdt;
      const auto fate = random() % 10;
      lost += fate == 0 ? 1 : 0;
      twice += fate == 1 ? 1 : 0;
      for (int copy = 0; copy < (fate == 0 ? 0 : fate == 1 ? 2 : 1); ++copy) batch.push_back(rdt);
    }
    for (std::size_t k = batch.size(); k > 1; --k) std::swap(batch[k - 1], batch[random() % k]);
    // Both ends of the stream arrive, so that the losses at the ends are seen.
    if (round == 0) batch.insert(batch.begin(), 0);
    if (round == 199) batch.push_back(rdt + 1);
    for (const auto number : batch)
      peers[1].send(encode_net_ft_record(1, {number, 7 * number + 100'000, 0, {}}).bytes());
    for (std::size_t k = 0; k < batch.size(); ++k) push();
  }
  EXPECT_EQ(sequence.lost() - sequence.late(), lost);
  EXPECT_EQ(sequence.duplicate(), twice);
  EXPECT_EQ(bus->counters().kernel_drops, 0u);
}

TEST(UdpBusErrors, NameTheAddress) {
  const auto refused = [](const std::array<std::string, kFingerCount>& addresses) {
    const auto opened = open_udp(addresses);
    EXPECT_FALSE(opened);
    return opened ? failed({}, {}) : opened.error();
  };
  EXPECT_EQ(refused({"127.0.0.1:1", "box:2", "127.0.0.1:3"}).field, "box:2");
  EXPECT_EQ(refused({"127.0.0.1", "127.0.0.1:2", "127.0.0.1:3"}).field, "127.0.0.1");
  EXPECT_EQ(refused({"127.0.0.1:1", "127.0.0.1:2", "127.0.0.1:1"}).field, "127.0.0.1:1");
  EXPECT_EQ(refused({"127.0.0.1:1", "127.0.0.1:2", "255.255.255.255:3"}).code, Error::Code::failed);
  const auto bus = open_udp({"127.0.0.1:1", "127.0.0.1:2", "127.0.0.1:3"});
  ASSERT_TRUE(bus);
  ManualClock virtual_clock;
  EXPECT_FALSE((*bus)->start(virtual_clock));
}

// ---- an interface that somebody switches off, in a network of its own

constexpr std::uint32_t kOtherAddress = 0x0A090901;  // 10.9.9.1

template <class Set>
bool ask_kernel(unsigned long request, const char* interface, Set&& set) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  ifreq content{};
  std::strcpy(content.ifr_name, interface);
  set(content);
  const bool done = ::ioctl(socket, request, &content) == 0;
  ::close(socket);
  return done;
}
bool switch_interface(const char* interface, bool up) {
  return ask_kernel(SIOCSIFFLAGS, interface, [&](ifreq& content) {
    content.ifr_flags = static_cast<short>(up ? IFF_UP : 0);
  });
}
bool add_other_address() {
  return ask_kernel(SIOCSIFADDR, "lo:1", [](ifreq& content) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(kOtherAddress);
    std::memcpy(&content.ifr_addr, &address, sizeof address);
  });
}

constexpr int kNoNetwork = 77;

/// The exit status: 0 good, else the number of the step that failed.
int lose_and_find_the_interface() {
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0 || !switch_interface("lo", true) ||
      !add_other_address())
    return kNoNetwork;
  std::array<Peer, kFingerCount> peers{Peer(0), Peer(0, kOtherAddress), Peer(0)};
  const auto bus = open_udp({peers[0].address(), peers[1].address(), peers[2].address()}).value();
  SteadyClock clock;
  if (!bus->start(clock)) return 1;
  BusFrame frame;
  frame.id = 1;
  frame.length = 1;
  ReceivedFrame in;
  bus->send(frame);
  if (peers[1].receive().size() != 1) return 2;

  switch_interface("lo:1", false);
  bus->send(frame);
  if (bus->receive(clock.now() + kPatience, in) != BusEvent::interface_down) return 3;
  if (in.frame.error) return 4;
  bus->send(frame);
  if (bus->receive(clock.now() + 300ms, in) != BusEvent::timeout) return 5;  // told once
  if (bus->counters().unsent != 2) return 6;

  add_other_address();
  const Timestamp limit = clock.now() + kPatience;
  for (auto unsent = bus->counters().unsent;; unsent = bus->counters().unsent) {
    if (bus->receive(clock.now() + 10ms, in) != BusEvent::timeout) return 7;
    bus->send(frame);
    if (bus->counters().unsent == unsent) break;
    if (clock.now() > limit) return 8;
  }
  if (peers[1].receive().size() != 1) return 9;
  peers[1].send(numbered(1, 5));
  if (bus->receive(clock.now() + kPatience, in) != BusEvent::frame) return 10;
  return in.frame.id == 1 && number_of(in.frame) == 5 ? 0 : 11;
}

TEST(UdpBusInterface, IsToldWhenItIsSwitchedOffAndFoundWhenItIsBack) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(lose_and_find_the_interface());
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) == kNoNetwork) GTEST_SKIP() << "no network of its own for a test here";
  EXPECT_EQ(WEXITSTATUS(status), 0) << "the step that failed";
}

}  // namespace
}  // namespace isograsp::udp_bus_test
