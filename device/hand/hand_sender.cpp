// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "device/bus/udp_port.hpp"
#include "device/emulator/play_timer.hpp"
#include "device/hand/hand_json.hpp"
#include "device/hand/hand_server.hpp"

namespace isograsp {

namespace {

class HandSender final : public HandServer {
 public:
  HandSender(const Endpoint& to, HandScene scene) : to_(to), timer_(std::move(scene)) {}

  [[nodiscard]] Result<void> open() { return port_.open({}, false); }
  [[nodiscard]] Endpoint address() const override { return to_; }
  [[nodiscard]] bool over() const override { return timer_.over(); }
  [[nodiscard]] const HandScene& scene() const override { return timer_.scene(); }
  [[nodiscard]] const HandServerCounters& counters() const override { return counters_; }

  void serve(Clock& clock, Timestamp until) override {
    timer_.begin(clock.now());
    for (;;) {
      const Timestamp now = clock.now();
      while (timer_.due() <= now) show(timer_.scene().take());
      if (now >= until || timer_.over()) return;
      clock.wait_until(std::min(until, timer_.due()));
    }
  }

 private:
  void show(const HandPicture& picture) {
    if (!picture.sent) return;
    for (const HandFrame& hand : picture.hands) {
      std::string message = hand_json(hand);
      if (picture.cut) message = cut_off(std::move(message));
      const std::span bytes(reinterpret_cast<const std::uint8_t*>(message.data()), message.size());
      if (port_.send(to_, bytes)) ++counters_.sent;
    }
  }

  Endpoint to_;
  PlayTimer<HandScene> timer_;
  UdpPort port_;
  HandServerCounters counters_;
};

}  // namespace

Result<std::unique_ptr<HandServer>> open_hand_sender(const Endpoint& to, HandScene scene) {
  for (const EmulatedHandFault& fault : scene.faults())
    if (fault.of_connection())
      return refused("datagrams have no connection that this fault could be of"_text,
                     "use --listen, which emulates the Leap service"_text)
          .about("--fault");
  auto sender = std::make_unique<HandSender>(to, std::move(scene));
  if (auto opened = sender->open(); !opened) return opened.error();
  return std::unique_ptr<HandServer>(std::move(sender));
}

}  // namespace isograsp
