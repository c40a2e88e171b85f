// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp emulate: sensors or cameras in software on a real bus or network, for everybody without
// the hardware.
#include "app/device/emulate.hpp"

#include <memory>

#include "app/commands.hpp"
#include "device/config/family_facts.hpp"

namespace isograsp::app {

namespace {

Result<void> run_emulate(const EmulateOptions& options) {
  return is_marker_protocol(options.protocol) ? emulate_markers(options) : emulate_sensors(options);
}

}  // namespace

void add_emulate(CommandLine& line) {
  auto options = std::make_shared<EmulateOptions>();
  Subcommand command =
      line.subcommand("emulate", "Sensors or cameras in software on a real bus or network");
  command.option("--protocol", options->protocol, family_names() + "; cameras: qtm-rt, natnet")
      .required();
  command
      .option("--on", options->on,
              "CAN interface (vcan0), an adapter made of it (slcan:can0), the address of the first "
              "box (127.0.0.1:49152:8080) or that of the cameras (127.0.0.1:22223)")
      .required();
  command.option("--config", options->config, "Device file (TOML) with addresses and scales");
  command.option("--play", options->play, "healthy, paretic or FILE.csv; of cameras, a recording")
      .shows_default();
  command.option("--seed", options->seed, "Seed of person, clocks and faults").shows_default();
  command.option("--fault", options->faults,
                 "NAME=FINGER:DETAIL@SECONDSs, e.g. lose=index:tx2:0.01, freeze=thumb:2s@10s, "
                 "busoff@5s (docs/devices.md lists them)");
  command.option("--duration", options->duration_s, "Seconds; without it until Ctrl-C")
      .range(0.001, 1e6);
  command.flag("--loop", options->loop, "Cameras play their recording again and again");
  command.option("--bitstream", options->natnet_version, "Version of NatNet: 2.5 to 4.1")
      .shows_default();
  command.option("--multicast", options->multicast,
                 "Group that NatNet frames are sent to, e.g. 239.255.42.99; else to who asks");
  command.flag("--json", options->json, "Print what was sent as one JSON document");
  command.footer(
      "Example:\n  isograsp emulate --protocol rft --on vcan0 --play paretic --seed 7 "
      "--fault lose=index:tx2:0.01\n  isograsp emulate --protocol qtm-rt --on 127.0.0.1:22223 "
      "--play markers.csv --fault freeze=F1:2s@5s");
  command.runs([options] { return run_emulate(*options); });
}

}  // namespace isograsp::app
