// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that a script sends as datagrams to a port of this computer.
#include <array>
#include <atomic>
#include <exception>
#include <utility>

#include "device/bus/host.hpp"
#include "device/bus/udp_port.hpp"
#include "device/hand/hand_json.hpp"
#include "device/hand/hand_schemes.hpp"
#include "device/hand/live_hand.hpp"

namespace isograsp {

namespace {

constexpr std::uint16_t kUdpHandPort = 6440;
constexpr std::uint32_t kLoopback = 0x7F000001;
constexpr const char* kNetworkConfirmed = "confirmed";
/// How long an end() may wait.
constexpr Timestamp kUdpHandLook = std::chrono::milliseconds(20);
/// A sender that says nothing for longer may be followed by another one.
constexpr Timestamp kSenderGone = std::chrono::seconds(1);

class UdpHandReceiver final : public HandReceiver {
 public:
  explicit UdpHandReceiver(const Endpoint& local) : local_(local) {}

  [[nodiscard]] Result<void> open() override { return port_.open(local_, false); }
  void run(HandDesk& desk) override {
    while (!ended_) {
      hear_all(desk);
      UdpPort::wait(port_, none_, kUdpHandLook);
    }
    port_.close();
  }
  void end() noexcept override { ended_ = true; }
  [[nodiscard]] Error nothing_came(HandReception::Link) const override {
    return failed("nobody sends a hand to %1"_text(local_.text()),
                  "start the script that sends hands, and check its address and port"_text);
  }

 private:
  void hear_all(HandDesk& desk) {
    Endpoint from;
    while (!ended_) {
      const auto size = port_.receive(room_, from);
      if (!size) return;
      const Timestamp now = desk.now();
      if (from != sender_ && sender_.port != 0 && now - heard_ < kSenderGone) {
        desk.foreign();
        continue;
      }
      try {
        hear(desk, *size, from, now);
      } catch (const std::exception&) {  // no memory for a message
        desk.malformed();
      }
    }
  }
  void hear(HandDesk& desk, std::size_t size, const Endpoint& from, Timestamp now) {
    if (size > room_.size()) return desk.malformed();
    const auto frame = parse_hand_json({reinterpret_cast<const char*>(room_.data()), size});
    if (!frame) return desk.malformed();
    sender_ = from;
    heard_ = now;
    desk.frame(frame->t_s, std::span(&*frame, 1));
  }

  Endpoint local_;
  Endpoint sender_;  ///< whose hands they are; port 0: nobody's yet
  Timestamp heard_{0};
  UdpPort port_;
  UdpPort none_;
  std::array<std::uint8_t, kLongestHandJson> room_{};
  std::atomic<bool> ended_{false};
};

}  // namespace

Result<std::unique_ptr<HandDevice>> open_udp_hand(const Uri& uri, std::optional<Hand> side) {
  if (auto known = uri.require_known({"mounting", "delay_ms", "network", "hand", "size"}); !known)
    return known.error();
  auto info = live_hand_info(uri);
  if (!info) return info.error();
  const auto host = parse_host(uri.target, kUdpHandPort);
  const auto address = host ? parse_ipv4(host->host) : std::nullopt;
  if (!address)
    return refused("'%1' is no address of this computer in numbers"_text(uri.target),
                   "write udp-hand://127.0.0.1 or udp-hand://127.0.0.1:6440"_text)
        .at(uri.text);
  const std::string network = uri.text_or("network", "");
  if (!network.empty() && network != kNetworkConfirmed)
    return refused("'%1' confirms nothing"_text(network), "write network=confirmed"_text)
        .at(uri.text)
        .about("network");
  if (*address != kLoopback && network.empty())
    return refused(
               "at this address every computer of the network could send hands, and joints are "
               "sent unsealed"_text,
               "use 127.0.0.1, or confirm a network of your own with network=confirmed"_text)
        .at(uri.text);
  const Endpoint local{*address, host->port};
  info->description = "Hands sent to %1"_text(local.text());
  return live_hand(*std::move(info), side, [local] {
    return std::unique_ptr<HandReceiver>(std::make_unique<UdpHandReceiver>(local));
  });
}

}  // namespace isograsp
