// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "device/bus/udp_port.hpp"
#include "device/emulator/marker_server.hpp"
#include "device/emulator/play_timer.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kForgotten = std::chrono::seconds(5);  // of a client that says nothing more

struct NatNetClient {
  Endpoint address;
  Timestamp heard{0};
};

class NatNetServer final : public MarkerServer {
 public:
  NatNetServer(MarkerScene scene, const EmulatedNatNetOptions& options)
      : timer_(std::move(scene)), options_(options), cameras_(options) {}

  [[nodiscard]] Result<void> open(const Endpoint& on) {
    if (auto opened = port_.open(on, false); !opened) return opened;
    if (options_.group != 0) port_.send_groups_through(on.address);
    return {};
  }

  [[nodiscard]] Endpoint address() const override { return port_.local(); }
  [[nodiscard]] bool over() const override { return timer_.over(); }
  [[nodiscard]] const MarkerScene& scene() const override { return timer_.scene(); }
  [[nodiscard]] const MarkerServerCounters& counters() const override { return counters_; }

  void serve(Clock& clock, Timestamp until) override {
    for (;;) {
      const Timestamp now = clock.now();
      while (hear(now)) {
      }
      while (timer_.due() <= now) show(timer_.scene().take(), now);
      if (now >= until) return;
      UdpPort::wait(port_, none_, std::min(until, timer_.due()) - now);
    }
  }

 private:
  bool hear(Timestamp now) {
    Endpoint from;
    const auto size = port_.receive(room_, from);
    if (!size) return false;
    bool stays = false;
    const auto request = std::span(room_).first(std::min(*size, room_.size()));
    const auto answer = cameras_.answer(request, timer_.scene().labels(timer_.play_s(now)),
                                        timer_.scene().rate_Hz(), stays);
    if (!answer.empty()) port_.send(from, answer);
    if (!stays) return true;
    const auto known =
        std::find_if(clients_.begin(), clients_.end(),
                     [&](const NatNetClient& client) { return client.address == from; });
    if (known == clients_.end()) {
      clients_.push_back({from, now});
      ++counters_.clients;
      timer_.begin(now);
    } else {
      known->heard = now;
    }
    return true;
  }

  void show(const MarkerPicture& picture, Timestamp now) {
    if (!picture.sent) return;
    const auto message = cameras_.frame(picture);
    if (options_.group != 0) {
      if (port_.send({options_.group, options_.data_port}, message)) ++counters_.sent;
      return;
    }
    std::erase_if(clients_,
                  [&](const NatNetClient& client) { return now - client.heard > kForgotten; });
    for (const NatNetClient& client : clients_)
      if (port_.send(client.address, message)) ++counters_.sent;
  }

  PlayTimer<MarkerScene> timer_;
  EmulatedNatNetOptions options_;
  EmulatedNatNet cameras_;
  UdpPort port_;
  UdpPort none_;
  std::array<std::uint8_t, 2048> room_{};
  std::vector<NatNetClient> clients_;
  MarkerServerCounters counters_;
};

}  // namespace

Result<std::unique_ptr<MarkerServer>> open_natnet_server(const Endpoint& on, MarkerScene scene,
                                                         const EmulatedNatNetOptions& options) {
  for (const EmulatedMarkerFault& fault : scene.faults())
    if (fault.of_connection())
      return refused("NatNet has no connection that this fault could be of"_text,
                     "use --protocol qtm-rt"_text)
          .about("--fault");
  constexpr std::size_t kMostMarkers = 1000;  // of one datagram, whatever its version
  if (scene.labels(0.0).size() > kMostMarkers)
    return refused("no datagram holds so many markers"_text, "play fewer of them"_text)
        .about("--play");
  auto server = std::make_unique<NatNetServer>(std::move(scene), options);
  if (auto opened = server->open(on); !opened) return opened.error();
  return std::unique_ptr<MarkerServer>(std::move(server));
}

}  // namespace isograsp
