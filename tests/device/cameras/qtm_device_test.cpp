// SPDX-License-Identifier: GPL-3.0-or-later
// What is special about Qualisys: a connection, and who may be at its other end.
#include <array>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "device/cameras/qtm_conversation.hpp"
#include "tests/device/cameras/marker_servers.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::qtm_device_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr Timestamp kPatience = 10s;

/// Reads until `done` says so.
template <class Done>
bool read_until(MarkerDevice& device, SteadyClock& clock, Done&& done) {
  const Timestamp end = clock.now() + kPatience;
  MarkerSample sample;
  while (clock.now() < end)
    if (done(device.read(clock.now() + 5ms, sample), sample)) return true;
  return false;
}

/// Somebody else at a port of this computer: says something to whoever comes, then waits.
class Stranger {
 public:
  explicit Stranger(std::string says) : says_(std::move(says)) {
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(kThisComputer);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&at), sizeof at), 0);
    EXPECT_EQ(::listen(socket_, 1), 0);
    socklen_t size = sizeof at;
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size), 0);
    port_ = ntohs(at.sin_port);
    thread_ = std::thread([this] {
      const int guest = ::accept(socket_, nullptr, nullptr);
      if (guest < 0) return;
      static_cast<void>(::send(guest, says_.data(), says_.size(), MSG_NOSIGNAL));
      std::array<char, 256> room{};
      while (::recv(guest, room.data(), room.size(), 0) > 0) {
      }
      ::close(guest);
    });
  }
  ~Stranger() {
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
  }
  [[nodiscard]] std::string uri() const { return "qtm://127.0.0.1:" + std::to_string(port_); }

 private:
  std::string says_;
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

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

TEST(QtmDevice, SaysWhyItCannotStart) {
  std::uint16_t closed = 0;
  {
    const auto server = qtm_server(marker_play(10));
    closed = server->address().port;
  }
  EXPECT_NE(start_problem("qtm://127.0.0.1:" + std::to_string(closed))
                .find("nobody answers at 127.0.0.1:"),
            std::string::npos);
  EXPECT_NE(start_problem(Stranger("HTTP/1.1 400 Bad Request\r\n\r\n").uri())
                .find("is not Qualisys Track Manager"),
            std::string::npos);
  EXPECT_NE(start_problem(Stranger("").uri()).find("does not answer"), std::string::npos);
  MarkerPlay nothing;
  nothing.t_s = {0.0, 0.01};
  const auto unlabelled = qtm_server(nothing);
  EXPECT_NE(start_problem("qtm://" + unlabelled->address().text()).find("no labelled markers"),
            std::string::npos);
  const auto still = qtm_server(marker_play(10), {"silence@0s"});
  EXPECT_NE(start_problem("qtm://" + still->address().text()).find("sends no pictures"),
            std::string::npos);
}

TEST(QtmDevice, AConnectionThatWasClosedIsMadeAnewWithoutAnyAllocation) {
  const auto server = qtm_server(marker_play(400, 200.0), {"close@400ms"});
  SteadyClock clock;
  auto device = open_cameras(uri_of("qtm", *server));
  must(device->start(clock));
  bool lost = false;
  std::int64_t last = -1;
  const auto before = allocations();
  const bool came_back = read_until(*device, clock, [&](ReadStatus status, MarkerSample& sample) {
    const MarkerHealth health = device->health();
    if (health.fault == MarkerFault::connection_lost) {
      lost = true;
      if (health.state != DeviceState::faulted) return true;
    }
    if (status != ReadStatus::sample) return false;
    if (sample.number <= last) return true;
    last = sample.number;
    return health.counters.restarts == 1;
  });
  EXPECT_EQ(allocations(), before);
  EXPECT_TRUE(came_back);
  EXPECT_TRUE(lost);
  EXPECT_EQ(device->health().counters.restarts, 1U);
  EXPECT_GT(device->health().counters.lost, 0U);
}

TEST(QtmDevice, OtherMarkersAfterAnInterruptionAreAFaultAndGiveNoPicture) {
  const auto server = qtm_server(marker_play(2000, 200.0), {"rename=A:Z@300ms", "close@400ms"});
  SteadyClock clock;
  auto device = open_cameras(uri_of("qtm", *server));
  must(device->start(clock));
  std::uint64_t good = 0;
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus, MarkerSample&) {
    good = device->health().counters.good;
    return device->health().fault == MarkerFault::wrong_labels;
  }));
  EXPECT_EQ(device->health().state, DeviceState::faulted);
  MarkerSample sample;
  EXPECT_EQ(device->read(clock.now() + 200ms, sample), ReadStatus::timeout);
  EXPECT_EQ(device->health().counters.good, good);
  EXPECT_EQ(device->info().labels, (std::vector<std::string>{"A", "B", "C"}));
}

TEST(QtmDevice, ASystemThatIsStartedAnewIsFoundAgain) {
  auto server = qtm_server(marker_play(2000, 200.0));
  const std::uint16_t port = server->address().port;
  SteadyClock clock;
  auto device = open_cameras("qtm://127.0.0.1:" + std::to_string(port));
  must(device->start(clock));
  server.reset();
  ASSERT_TRUE(read_until(*device, clock, [&](ReadStatus, MarkerSample&) {
    return device->health().fault == MarkerFault::connection_lost;
  }));
  server = qtm_server(marker_play(2000, 200.0), {}, port);
  EXPECT_TRUE(read_until(*device, clock, [&](ReadStatus status, MarkerSample&) {
    return status == ReadStatus::sample && device->health().counters.restarts == 1;
  }));
}

TEST(QtmDevice, ReadsItsUri) {
  const auto refusal = [](const std::string& uri) {
    const auto device = open_marker_device(must(Uri::parse(uri)));
    return device ? "accepted" : device.error().message();
  };
  EXPECT_EQ(refusal("qtm://some-computer?rig=r.toml"), "accepted");
  for (const char* uri : {"qtm://", "qtm://host:0", "qtm://host:70000", "qtm://a/b"})
    EXPECT_NE(refusal(uri).find("is no computer with a port"), std::string::npos) << uri;
  EXPECT_NE(refusal("qtm://host?rate=100").find("unknown parameter"), std::string::npos);
}

// ----------------------------------------------------------------------------- what is said

using Step = QtmRtStream::Step;

TEST(QtmConversation, AsksForMarkersThenForFrames) {
  QtmConversation talk;
  talk.begin(0s);
  EXPECT_EQ(talk.say(), "") << "the greeting comes first";
  talk.hear(Step::message, "QTM RT Interface connected", 10ms);
  EXPECT_EQ(talk.say(), "Version 1.23");
  EXPECT_EQ(talk.say(), "") << "once";
  talk.hear(Step::message, "Version set to 1.23", 20ms);
  EXPECT_EQ(talk.say(), "GetParameters General 3D");
  talk.hear(Step::labels, "", 30ms);
  EXPECT_EQ(talk.say(), "StreamFrames AllFrames 3DRes");
  EXPECT_FALSE(talk.streaming());
  talk.hear(Step::row, "", 40ms);
  EXPECT_TRUE(talk.streaming());
  talk.ask_again(5s);
  EXPECT_EQ(talk.say(), "GetParameters General 3D");
}

TEST(QtmConversation, SaysItAnotherWayWhereItIsRefused) {
  QtmConversation talk;
  talk.begin(0s);
  talk.look(2s);
  EXPECT_EQ(talk.say(), "Version 1.23") << "a system that does not greet is asked all the same";
  talk.hear(Step::refusal, "Version NOT supported", 2s);
  EXPECT_EQ(talk.say(), "Version 1.19");
  talk.hear(Step::message, "Version set to 1.19", 2s);
  static_cast<void>(talk.say());
  talk.hear(Step::refusal, "Parse error", 2s);
  EXPECT_EQ(talk.say(), "GetParameters 3D");
  talk.hear(Step::labels, "", 2s);
  static_cast<void>(talk.say());
  talk.hear(Step::refusal, "Parse error", 2s);
  EXPECT_EQ(talk.say(), "StreamFrames AllFrames 3D");
  talk.hear(Step::refusal, "No data", 2s);
  EXPECT_EQ(talk.failure(), QtmConversation::Failure::no_frames);
  EXPECT_EQ(talk.refusal(), "No data");
}

TEST(QtmConversation, EveryQuestionHasItsPatience) {
  QtmConversation talk;
  talk.begin(0s);
  talk.hear(Step::message, "QTM RT Interface connected", 0s);
  talk.look(talk.due() - 1ns);
  EXPECT_EQ(talk.failure(), QtmConversation::Failure::none);
  talk.look(talk.due());
  EXPECT_EQ(talk.failure(), QtmConversation::Failure::no_answer);
}

}  // namespace
}  // namespace isograsp::qtm_device_test
