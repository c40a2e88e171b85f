// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. One connection to the Leap service, from the handshake to its end. Over
// any transport: what a peer may send is tried without a socket.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <boost/asio/buffer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

#include "device/hand/leap_json.hpp"
#include "device/hand/live_hand.hpp"

namespace isograsp {

/// Messages of one service after the other, put on the desk.
class LeapHearing {
 public:
  explicit LeapHearing(HandDesk& desk) : desk_(desk) {}

  [[nodiscard]] HandDesk& desk() noexcept { return desk_; }
  void hear(std::string_view message) {
    auto kind = decoder_.take(message, hands_);
    if (kind == LeapDecoder::Kind::late && decoder_.late_s() > HandTimes::kOverlap_s) {
      decoder_.restart();  // the service began anew, and its clock with it
      kind = decoder_.take(message, hands_);
    }
    switch (kind) {
      case LeapDecoder::Kind::frame: desk_.frame(decoder_.time_s(), hands_); break;
      case LeapDecoder::Kind::notice: desk_.service(decoder_.service()); break;
      case LeapDecoder::Kind::damaged: desk_.malformed(); break;
      case LeapDecoder::Kind::late: desk_.late(); break;
    }
  }

 private:
  HandDesk& desk_;
  LeapDecoder decoder_;
  std::vector<HandFrame> hands_;
};

/// Owned by a shared pointer: what is under way keeps it until it is over.
template <class Transport>
class LeapConversation final : public std::enable_shared_from_this<LeapConversation<Transport>> {
 public:
  static constexpr std::chrono::seconds kConnecting{2};

  /// `ended` is told why, once, unless leave() came first.
  LeapConversation(Transport transport, LeapHearing& hearing,
                   std::function<void(HandReception::Link)> ended)
      : socket_(std::move(transport)), hearing_(hearing), ended_(std::move(ended)) {}

  [[nodiscard]] Transport& transport() noexcept { return socket_.next_layer(); }
  /// Begins behind an open transport. `host` with its port.
  void greet(const std::string& host) {
    namespace websocket = boost::beast::websocket;
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = kConnecting;
    timeout.idle_timeout = kIdle;
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.read_message_max(0);  // listen() watches it
    socket_.async_handshake(host, kPath, step([this](Failure failure) {
                              if (failure) return finish(HandReception::Link::no_service);
                              hearing_.desk().link(HandReception::Link::open);
                              wish(0);
                              listen();
                            }));
  }
  /// Nothing is heard or told any more.
  void leave() noexcept { here_ = false; }

 private:
  using Failure = boost::beast::error_code;

  static constexpr const char* kPath = "/v6.json";
  static constexpr std::size_t kPiece = std::size_t{1} << 16;
  /// Without a word for so long, not even the answer to a ping, the connection counts as lost.
  static constexpr std::chrono::seconds kIdle{5};
  /// What a client must say to get frames, also while the service thinks that nobody looks.
  static constexpr std::array<std::string_view, 2> kWishes{R"({"focused":true})",
                                                           R"({"background":true})"};

  /// Calls `next` with what came of a step, unless it is over by now.
  template <class Next>
  auto step(Next next) {
    return [self = this->shared_from_this(), next](Failure failure, auto&&...) {
      if (self->here_) next(failure);
    };
  }
  void wish(std::size_t which) {
    if (which == kWishes.size()) return;
    socket_.text(true);
    socket_.async_write(boost::asio::buffer(kWishes[which]), step([this, which](Failure failure) {
                          if (!failure) wish(which + 1);  // listen() hears of a failure
                        }));
  }
  /// A message comes in as many pieces as it likes. Its length is watched here: what Beast ends by
  /// itself it tells only when the other end has hung up, and as if that had ended it.
  void listen() {
    socket_.async_read_some(
        buffer_, kPiece, step([this](Failure failure) {
          if (failure) return finish(HandReception::Link::lost);
          if (buffer_.size() > LeapDecoder::kLongestMessage) {
            hearing_.desk().malformed();
            return finish(HandReception::Link::lost);
          }
          if (socket_.is_message_done()) {
            hearing_.hear({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
            buffer_.consume(buffer_.size());
          }
          listen();
        }));
  }
  void finish(HandReception::Link why) {
    here_ = false;
    ended_(why);
  }

  boost::beast::websocket::stream<Transport> socket_;
  boost::beast::flat_buffer buffer_;
  LeapHearing& hearing_;
  std::function<void(HandReception::Link)> ended_;
  bool here_ = true;
};

}  // namespace isograsp
