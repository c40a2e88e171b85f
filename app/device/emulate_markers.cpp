// SPDX-License-Identifier: GPL-3.0-or-later
// Emulated cameras on a port of this computer.
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/device/emulate.hpp"
#include "app/device/live_device.hpp"
#include "app/language.hpp"
#include "device/emulator/marker_server.hpp"

namespace isograsp::app {

namespace {

constexpr const char* kQtm = "qtm-rt";
constexpr const char* kNatNet = "natnet";

/// "3.1"; a version that is not known is none.
std::optional<NatNetVersion> parse_version(const std::string& text) {
  NatNetVersion version;
  int end = 0;
  if (std::sscanf(text.c_str(), "%d.%d%n", &version.major, &version.minor, &end) != 2 ||
      static_cast<std::size_t>(end) != text.size() || !version.known())
    return std::nullopt;
  return version;
}

Result<MarkerScene> scene_of(const EmulateOptions& options) {
  std::vector<EmulatedMarkerFault> faults;
  for (const auto& text : options.faults) {
    auto fault = EmulatedMarkerFault::parse(text);
    if (!fault) return fault.error();
    faults.push_back(*std::move(fault));
  }
  auto play = MarkerPlay::read(options.play);
  if (!play) return play.error();
  play->repeat = options.loop;
  return MarkerScene::make(*std::move(play), std::move(faults), options.seed);
}

Result<std::unique_ptr<MarkerServer>> open_server(const EmulateOptions& options,
                                                  MarkerScene scene) {
  const auto on = parse_endpoint(options.on);
  if (!on)
    return refused("'%1' is no address in numbers with a port"_text(options.on),
                   "write it as 127.0.0.1:22223"_text)
        .about("--on");
  if (options.protocol == kQtm) return open_qtm_server(*on, std::move(scene));
  EmulatedNatNetOptions natnet;
  const auto version = parse_version(options.natnet_version);
  if (!version)
    return refused("'%1' is no known version of NatNet"_text(options.natnet_version),
                   "give one from 2.5 to 4.1"_text)
        .about("--bitstream");
  natnet.version = *version;
  if (!options.multicast.empty()) {
    const auto group = parse_ipv4(options.multicast);
    if (!group)
      return refused("'%1' is no address in numbers"_text(options.multicast),
                     "write it as 192.168.0.7"_text)
          .about("--multicast");
    natnet.group = *group;
  }
  return open_natnet_server(*on, std::move(scene), natnet);
}

void print_pictures(const MarkerServer& server, bool json) {
  const MarkerSceneCounters& made = server.scene().counters();
  const MarkerServerCounters& given = server.counters();
  if (json)
    print_json({{"pictures", made.pictures},
                {"dropped", made.dropped},
                {"silent", made.silent},
                {"restarts", made.restarts},
                {"sent", given.sent},
                {"clients", given.clients},
                {"closed", given.closed}});
  else
    print("%s\n",
          spoken("%1 pictures, %2 lost on purpose"_text(made.pictures, made.dropped + made.silent))
              .c_str());
}

}  // namespace

bool is_marker_protocol(const std::string& protocol) noexcept {
  return protocol == kQtm || protocol == kNatNet;
}

Result<void> emulate_markers(const EmulateOptions& options) {
  auto scene = scene_of(options);
  if (!scene) return scene.error();
  auto server = open_server(options, *std::move(scene));
  if (!server) return server.error();
  watch_for_interrupt();
  if (!options.json)
    print_note("cameras (%1) play %2 on %3"_text(options.protocol, options.play,
                                                 (*server)->address().text()));
  constexpr Timestamp kLook = std::chrono::milliseconds(100);
  SteadyClock clock;
  const Timestamp end =
      options.duration_s > 0.0 ? clock.now() + from_seconds(options.duration_s) : Timestamp::max();
  while (!interrupted() && clock.now() < end && !(*server)->over())
    (*server)->serve(clock, std::min(end, clock.now() + kLook));
  print_pictures(**server, options.json);
  return {};
}

}  // namespace isograsp::app
