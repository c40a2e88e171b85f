// SPDX-License-Identifier: GPL-3.0-or-later
// The Leap service over a WebSocket: asked for frames, heard, connected to again.
#include <array>
#include <exception>
#include <string>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include "device/bus/host.hpp"
#include "device/hand/hand_schemes.hpp"
#include "device/hand/leap_json.hpp"
#include "device/hand/live_hand.hpp"

namespace isograsp {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;

namespace {

constexpr std::uint16_t kLeapPort = 6437;
constexpr const char* kLeapPath = "/v6.json";
constexpr std::size_t kLeapPiece = std::size_t{1} << 16;
constexpr std::chrono::seconds kLeapConnecting{2};
constexpr std::chrono::milliseconds kLeapAgain{250};
/// Without a word for so long, not even the answer to a ping, the connection counts as lost.
constexpr std::chrono::seconds kLeapIdle{5};
/// What a client must say to get frames, also while the service thinks that nobody looks.
constexpr std::array<std::string_view, 2> kLeapWishes{R"({"focused":true})",
                                                      R"({"background":true})"};

class LeapReceiver final : public HandReceiver {
 public:
  explicit LeapReceiver(HostAndPort host) : host_(std::move(host)) {}

  [[nodiscard]] Result<void> open() override {
    const auto server = find_host(host_);
    if (!server) return server.error();
    server_ = *server;
    return {};
  }
  void run(HandDesk& desk) override {
    desk_ = &desk;
    connect();
    while (!io_.stopped()) try {
        io_.run();
      } catch (const std::exception&) {  // no memory for a message
        desk.malformed();
        lose(HandReception::Link::lost);
      }
    socket_.reset();
  }
  void end() noexcept override { io_.stop(); }
  [[nodiscard]] Error nothing_came(HandReception::Link link) const override {
    if (link == HandReception::Link::nobody)
      return failed("nobody answers at %1"_text(server_.text()),
                    "start the tracking service with its WebSocket, check its address and the "
                    "firewall"_text);
    if (link == HandReception::Link::no_service)
      return failed("what answers is not the Leap service"_text,
                    "give the address and port of its WebSocket, usually 6437"_text);
    return failed("the tracking service sends no frames"_text,
                  "plug its camera in, and look in its control panel whether it sees a hand"_text);
  }

 private:
  using Socket = websocket::stream<beast::tcp_stream>;

  /// Calls `next` with what came of a step, unless the connection is another one by now.
  template <class Next>
  auto step(Next next) {
    return [this, visit = visit_, next](beast::error_code failure, auto&&...) {
      if (visit == visit_) next(failure);
    };
  }
  void connect() {
    ++visit_;
    buffer_.clear();
    Socket& socket = socket_.emplace(io_);
    beast::get_lowest_layer(socket).expires_after(kLeapConnecting);
    const asio::ip::tcp::endpoint peer(asio::ip::address_v4(server_.address), server_.port);
    beast::get_lowest_layer(socket).async_connect(peer, step([this](beast::error_code failure) {
                                                    failure ? lose(HandReception::Link::nobody)
                                                            : greet();
                                                  }));
  }
  void greet() {
    Socket& socket = *socket_;
    beast::error_code ignored;
    beast::get_lowest_layer(socket).socket().set_option(asio::ip::tcp::no_delay(true), ignored);
    beast::get_lowest_layer(socket).expires_never();
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = kLeapConnecting;
    timeout.idle_timeout = kLeapIdle;
    timeout.keep_alive_pings = true;
    socket.set_option(timeout);
    socket.read_message_max(0);  // listen() watches it
    socket.async_handshake(host_.host + ":" + std::to_string(host_.port), kLeapPath,
                           step([this](beast::error_code failure) {
                             if (failure) return lose(HandReception::Link::no_service);
                             desk_->link(HandReception::Link::open);
                             wish(0);
                             listen();
                           }));
  }
  void wish(std::size_t which) {
    if (which == kLeapWishes.size()) return;
    socket_->text(true);
    socket_->async_write(asio::buffer(kLeapWishes[which]),
                         step([this, which](beast::error_code failure) {
                           if (!failure) wish(which + 1);  // listen() hears of a failure
                         }));
  }
  /// A message comes in as many pieces as it likes. Its length is watched here: what Beast ends by
  /// itself it tells only when the other end has hung up, and as if that had ended it.
  void listen() {
    socket_->async_read_some(
        buffer_, kLeapPiece, step([this](beast::error_code failure) {
          if (failure) return lose(HandReception::Link::lost);
          if (buffer_.size() > LeapDecoder::kLongestMessage) {
            desk_->malformed();
            return lose(HandReception::Link::lost);
          }
          if (socket_->is_message_done()) {
            hear({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
            buffer_.consume(buffer_.size());
          }
          listen();
        }));
  }
  void hear(std::string_view message) {
    auto kind = decoder_.take(message, hands_);
    if (kind == LeapDecoder::Kind::late && decoder_.late_s() > HandTimes::kOverlap_s) {
      decoder_.restart();  // the service began anew, and its clock with it
      kind = decoder_.take(message, hands_);
    }
    switch (kind) {
      case LeapDecoder::Kind::frame: desk_->frame(decoder_.time_s(), hands_); break;
      case LeapDecoder::Kind::notice: desk_->service(decoder_.service()); break;
      case LeapDecoder::Kind::damaged: desk_->malformed(); break;
      case LeapDecoder::Kind::late: desk_->late(); break;
    }
  }
  void lose(HandReception::Link why) {
    ++visit_;
    desk_->link(why);
    if (socket_) {
      beast::error_code ignored;
      beast::get_lowest_layer(*socket_).socket().close(ignored);
    }
    timer_.expires_after(kLeapAgain);
    timer_.async_wait(step([this](beast::error_code failure) {
      if (!failure) connect();
    }));
  }

  HostAndPort host_;
  Endpoint server_;
  HandDesk* desk_ = nullptr;
  LeapDecoder decoder_;
  std::vector<HandFrame> hands_;
  asio::io_context io_{1};
  asio::steady_timer timer_{io_};
  std::optional<Socket> socket_;
  beast::flat_buffer buffer_;
  std::uint64_t visit_ = 0;
};

}  // namespace

Result<std::unique_ptr<HandDevice>> open_leap(const Uri& uri, std::optional<Hand> side) {
  if (auto known = uri.require_known({"mounting", "delay_ms", "hand", "size"}); !known)
    return known.error();
  auto info = live_hand_info(uri);
  if (!info) return info.error();
  auto host = parse_host(uri.target, kLeapPort);
  if (!host)
    return refused("'%1' is no computer with a port"_text(uri.target),
                   "write leap://127.0.0.1 or leap://127.0.0.1:6437"_text)
        .at(uri.text);
  info->description = "Leap service at %1"_text(host->host);
  return live_hand(*std::move(info), side, [host = *std::move(host)] {
    return std::unique_ptr<HandReceiver>(std::make_unique<LeapReceiver>(host));
  });
}

}  // namespace isograsp
