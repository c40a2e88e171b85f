// SPDX-License-Identifier: GPL-3.0-or-later
// A peer of the client of the Leap service that sends any bytes: behind a true handshake, in its
// place, or as messages in frames that are right. Laws: where the stream is cut does not count,
// what is heard is what was said, nothing is heard behind the end, and the end is told once.
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/beast/_experimental/test/stream.hpp>

#include "device/hand/leap_conversation.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;
namespace asio = boost::asio;
namespace beast = boost::beast;

namespace {

using Wire = beast::test::stream;
using Link = HandReception::Link;

/// What a client is left with.
struct Heard {
  HandCounters counters;
  std::string service;
  int ends = 0;
  Link link = Link::nobody;
  std::vector<double> joints;  ///< of all rows; -1 for what is not there

  bool operator==(const Heard& other) const {
    return counters.frames == other.counters.frames && counters.late == other.counters.late &&
           counters.malformed == other.counters.malformed && ends == other.ends &&
           link == other.link && service == other.service && joints == other.joints;
  }
};

/// The desk of a client: a thread with a clock that stands.
class Desk {
 public:
  Desk() { fuzz::require(desk_.open().ok(), "the system has a descriptor"); }
  HandDesk& begin() {
    HandSample row;
    while (desk_.take(row)) continue;
    desk_.begin();
    return desk_;
  }
  Heard end(int ends, Link link) {
    Heard heard{desk_.reception().counters, desk_.service(), ends, link, {}};
    HandSample row;
    while (desk_.take(row))
      for (const Vec3& joint : row.frame.joints)
        for (const double c : joint) heard.joints.push_back(std::isnan(c) ? -1.0 : c);
    return heard;
  }

 private:
  ManualClock clock_;
  HandDesk desk_{std::nullopt, clock_};
};

/// A client and the other end of its wire, in one thread.
class Talk {
 public:
  /// `piece`: most bytes that the client gets at once.
  Talk(HandDesk& desk, std::size_t piece) : hearing_(desk) {
    Wire near(io_);
    near.read_size(piece);
    near.connect(far_);
    conversation_ = std::make_shared<LeapConversation<Wire>>(
        std::move(near), hearing_, [this](Link why) { ++ends_, link_ = why; });
    conversation_->greet("127.0.0.1:6437");
    io_.restart();
    io_.poll();
  }
  ~Talk() {
    conversation_->leave();
    conversation_.reset();
    service_.reset();
    io_.restart();
    io_.poll();  // what waited is told that it is over
  }
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;
  /// The handshake as a service does it; what it sends from then on.
  beast::websocket::stream<Wire>& accept() {
    service_.emplace(std::move(far_));
    service_->accept();
    io_.restart();
    io_.poll();
    link_ = Link::open;
    return *service_;
  }
  void send(std::string_view bytes) {
    Wire& wire = service_ ? service_->next_layer() : far_;
    beast::error_code gone;  // the client may have hung up
    asio::write(wire, asio::buffer(bytes.data(), bytes.size()), gone);
    io_.restart();
    io_.poll();
  }
  void hang_up() {
    (service_ ? service_->next_layer() : far_).close();
    io_.restart();
    io_.poll();
  }
  [[nodiscard]] int ends() const noexcept { return ends_; }
  [[nodiscard]] Link link() const noexcept { return link_; }

 private:
  static inline asio::io_context io_{1};  // one for all: its descriptors cost more than a talk
  Wire far_{io_};
  LeapHearing hearing_;
  std::shared_ptr<LeapConversation<Wire>> conversation_;
  std::optional<beast::websocket::stream<Wire>> service_;
  int ends_ = 0;
  Link link_ = Link::nobody;
};

Heard heard_of_bytes(std::string_view bytes, bool handshake, std::size_t piece) {
  static Desk desk;
  Talk talk(desk.begin(), piece);
  if (handshake) talk.accept();
  talk.send(bytes);
  talk.hang_up();
  fuzz::require(talk.ends() == 1, "an end is told, once");
  fuzz::require(talk.link() == (handshake ? Link::lost : Link::no_service),
                "who is no service is said to be none");
  return desk.end(talk.ends(), talk.link());
}

void messages_are_heard_as_they_are(std::string_view text) {
  static Desk desk, plain;
  Talk talk(desk.begin(), std::string_view::npos);
  LeapHearing straight(plain.begin());
  auto& service = talk.accept();
  for (std::string_view rest = text; !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const std::string_view message = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    service.binary(true);  // any bytes
    service.write_some(false, asio::buffer(message.substr(0, message.size() / 2)));
    service.write_some(true, asio::buffer(message.substr(message.size() / 2)));
    talk.send({});
    straight.hear(message);
  }
  fuzz::require(talk.ends() == 0, "messages end nothing");
  fuzz::require(desk.end(0, Link::open) == plain.end(0, Link::open), "messages are heard");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::size_t kPiece = 7;
  const std::string_view rest = fuzz::as_text(data + 1, size - 1);
  if (const int what = data[0] % 4; what == 0)
    messages_are_heard_as_they_are(rest);
  else
    fuzz::require(heard_of_bytes(rest, what != 1, std::string_view::npos) ==
                      heard_of_bytes(rest, what != 1, kPiece),
                  "where the stream is cut does not count");
  return 0;
}
