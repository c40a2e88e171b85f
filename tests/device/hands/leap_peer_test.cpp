// SPDX-License-Identifier: GPL-3.0-or-later
// A WebSocket that does not keep to what the Leap service says: the client stays whole, counts it
// and tries again.
#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include "device/hand/emulated_leap.hpp"
#include "device/hand/leap_json.hpp"
#include "tests/device/hands/hand_trackers.hpp"

namespace isograsp::leap_peer_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;
namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using Socket = beast::websocket::stream<tcp::socket>;

constexpr double kRate_Hz = 100.0;

/// One connection after the other: each gets frames for a while, then what a test says.
class OddPeer {
 public:
  explicit OddPeer(std::function<void(Socket&)> odd) : odd_(std::move(odd)) {
    port_ = acceptor_.local_endpoint().port();
    thread_ = std::thread([this] { run(); });
  }
  ~OddPeer() {
    ended_ = true;
    {
      tcp::socket knock(io_);  // accept() waits for one
      beast::error_code ignored;
      knock.connect({asio::ip::address_v4(kHandComputer), port_}, ignored);
    }
    thread_.join();
  }
  OddPeer(const OddPeer&) = delete;
  OddPeer& operator=(const OddPeer&) = delete;
  [[nodiscard]] std::string uri() const { return "leap://127.0.0.1:" + std::to_string(port_); }

 private:
  void run() {
    constexpr int kFrames = 20;
    HandScene scene = hand_scene(hand_play(1000, kRate_Hz));
    SteadyClock clock;
    while (!ended_) {
      beast::error_code failure;
      tcp::socket plain(io_);
      acceptor_.accept(plain, failure);
      if (failure || ended_) return;
      Socket socket(std::move(plain));
      socket.accept(failure);
      if (failure) continue;
      for (int k = 0; k < kFrames && !failure; ++k) {
        socket.text(true);
        socket.write(asio::buffer(leap_frame(scene.take(), kRate_Hz)), failure);
        clock.wait_until(clock.now() + 10ms);
      }
      if (!failure) odd_(socket);
      // What the client still says is read, as a service does: else the system breaks off for both.
      std::array<char, 256> rest{};
      while (!failure) socket.next_layer().read_some(asio::buffer(rest), failure);
    }
  }
  std::function<void(Socket&)> odd_;
  std::atomic<bool> ended_{false};
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_, tcp::endpoint(asio::ip::address_v4(kHandComputer), 0)};
  std::uint16_t port_ = 0;
  std::thread thread_;
};

/// Reads until the connection has been made anew; the counters then.
HandCounters after_a_new_connection(const OddPeer& peer) {
  SteadyClock clock;
  const auto device = open_hands(peer.uri());
  must(device->start(clock));
  const Timestamp end = clock.now() + 10s;
  HandSample sample;
  std::int64_t number = -1;
  while (clock.now() < end && device->health().counters.restarts == 0)
    if (device->read(clock.now() + 5ms, sample) == ReadStatus::sample) {
      EXPECT_GT(sample.number, number);
      number = sample.number;
    }
  return device->health().counters;
}

TEST(LeapPeer, AMessageThatIsTooLongEndsTheConnectionAndIsCounted) {
  const OddPeer peer([](Socket& socket) {
    const std::string long_one(LeapDecoder::kLongestMessage + 1, ' ');
    beast::error_code ignored;
    socket.write(asio::buffer(long_one), ignored);
  });
  const HandCounters counters = after_a_new_connection(peer);
  EXPECT_EQ(counters.restarts, 1U);
  EXPECT_EQ(counters.malformed, 1U);
}

TEST(LeapPeer, TheLongestMessageThatIsAllowedIsRead) {
  const OddPeer peer([](Socket& socket) {
    const std::string blank(LeapDecoder::kLongestMessage - 2, ' ');
    beast::error_code ignored;
    socket.write(asio::buffer("{" + blank + "}"), ignored);
    socket.close(beast::websocket::close_code::normal, ignored);
  });
  const HandCounters counters = after_a_new_connection(peer);
  EXPECT_EQ(counters.restarts, 1U);
  EXPECT_EQ(counters.malformed, 0U) << "a notice of the service";
}

TEST(LeapPeer, BytesThatAreNoWebSocketEndTheConnectionAndANewOneIsMade) {
  const OddPeer peer([](Socket& socket) {
    beast::error_code ignored;
    asio::write(socket.next_layer(), asio::buffer(std::string(64, '\xff')), ignored);
  });
  const HandCounters counters = after_a_new_connection(peer);
  EXPECT_EQ(counters.restarts, 1U);
}

TEST(LeapPeer, AnEndWithoutAWordIsNoDamage) {
  const OddPeer peer([](Socket& socket) {
    beast::error_code ignored;
    socket.next_layer().close(ignored);
  });
  const HandCounters counters = after_a_new_connection(peer);
  EXPECT_EQ(counters.restarts, 1U);
  EXPECT_EQ(counters.malformed, 0U);
}

}  // namespace
}  // namespace isograsp::leap_peer_test
