// SPDX-License-Identifier: GPL-3.0-or-later
// The Leap service over a WebSocket: asked for frames, heard, connected to again.
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

#include "device/bus/host.hpp"
#include "device/hand/hand_schemes.hpp"
#include "device/hand/leap_conversation.hpp"
#include "device/hand/live_hand.hpp"

namespace isograsp {

namespace asio = boost::asio;
namespace beast = boost::beast;

namespace {

constexpr std::uint16_t kLeapPort = 6437;
constexpr std::chrono::milliseconds kLeapAgain{250};

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
    hearing_.emplace(desk);
    connect();
    while (!io_.stopped()) try {
        io_.run();
      } catch (const std::exception&) {  // no memory for a message
        desk.malformed();
        lose(HandReception::Link::lost);
      }
    conversation_.reset();
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
  using Conversation = LeapConversation<beast::tcp_stream>;

  void connect() {
    conversation_ = std::make_shared<Conversation>(beast::tcp_stream(io_), *hearing_,
                                                   [this](HandReception::Link why) { lose(why); });
    beast::tcp_stream& transport = conversation_->transport();
    transport.expires_after(Conversation::kConnecting);
    const asio::ip::tcp::endpoint peer(asio::ip::address_v4(server_.address), server_.port);
    transport.async_connect(peer, [this, &transport](beast::error_code failure) {
      if (failure) return lose(HandReception::Link::nobody);
      beast::error_code ignored;
      transport.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
      transport.expires_never();
      conversation_->greet(host_.host + ":" + std::to_string(host_.port));
    });
  }
  void lose(HandReception::Link why) {
    hearing_->desk().link(why);
    conversation_->leave();
    beast::error_code ignored;
    conversation_->transport().socket().close(ignored);
    timer_.expires_after(kLeapAgain);
    timer_.async_wait([this](beast::error_code failure) {
      if (!failure) connect();
    });
  }

  HostAndPort host_;
  Endpoint server_;
  std::optional<LeapHearing> hearing_;  ///< from run() on
  asio::io_context io_{1};
  asio::steady_timer timer_{io_};
  std::shared_ptr<Conversation> conversation_;
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
