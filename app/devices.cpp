// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp devices: what can be connected here and what it would need.
#include <array>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "device/can_bus.hpp"
#include "device/device_config.hpp"

namespace isograsp {

namespace {

struct DevicesOptions {
  bool json = false;
  bool check = false;
  std::string config;
};

struct Scheme {
  const char* uri;
  const char* what;
  const char* needs;
};
constexpr std::array<Scheme, 4> kSchemes{
    {{"sim://healthy", "simulated sensors, pressed by a healthy virtual patient", "nothing"},
     {"sim://paretic", "simulated sensors, pressed by a paretic virtual patient", "nothing"},
     {"replay://FILE.csv?speed=1", "a recorded finger-forces file", "the file"},
     {"can://IFACE?protocol=rft", "three Robotous RFT sensors on one CAN bus",
      "a CAN adapter with a Linux driver, 1 Mbit/s, switched on"}}};

std::string needs_of(const CanInterface& interface) {
  return interface.up
             ? "nothing: it is on"
             : "sudo ip link set " + interface.name + " up type can bitrate 1000000 restart-ms 100";
}

Result<void> check_config(const DevicesOptions& options) {
  const auto config = RftConfig::read(options.config);
  if (!config) return config.error();
  nlohmann::ordered_json sensors = nlohmann::ordered_json::array();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& s = config->sensors[f];
    sensors.push_back({{"finger", kFingerNames[f]},
                       {"command_id", s.ids.command},
                       {"first_id", s.ids.first},
                       {"second_id", s.ids.second},
                       {"serial_number", s.serial_number},
                       {"force_divisor", s.divisors.force_per_N},
                       {"torque_divisor", s.divisors.torque_per_Nm}});
  }
  if (options.json) {
    const nlohmann::ordered_json document{
        {"config", options.config}, {"filter_Hz", config->filter_Hz}, {"sensors", sensors}};
    std::puts(document.dump(2).c_str());
    return {};
  }
  std::printf("%s is good.\n", options.config.c_str());
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& s = config->sensors[f];
    std::printf("  %-6s  command 0x%02X, data 0x%02X and 0x%02X, serial number %s\n",
                std::string(kFingerNames[f]).c_str(), static_cast<unsigned>(s.ids.command),
                static_cast<unsigned>(s.ids.first), static_cast<unsigned>(s.ids.second),
                s.serial_number.empty() ? "any" : s.serial_number.c_str());
  }
  return {};
}

Result<void> run_devices(const DevicesOptions& options) {
  if (!options.config.empty()) return check_config(options);
  if (options.check)
    return Error{
        Error::Code::bad_input, "there is nothing to check", "add --config FILE", "", 0, "--check"};
  const auto interfaces = list_can_interfaces();
  if (options.json) {
    nlohmann::ordered_json document{{"schemes", nlohmann::ordered_json::array()},
                                    {"can_interfaces", nlohmann::ordered_json::array()}};
    for (const auto& s : kSchemes)
      document["schemes"].push_back({{"uri", s.uri}, {"what", s.what}, {"needs", s.needs}});
    for (const auto& i : interfaces)
      document["can_interfaces"].push_back(
          {{"name", i.name}, {"up", i.up}, {"needs", needs_of(i)}});
    std::puts(document.dump(2).c_str());
    return {};
  }
  std::puts("Devices");
  for (const auto& s : kSchemes)
    std::printf("  %-26s  %s\n  %-26s  needs %s\n", s.uri, s.what, "", s.needs);
  std::puts("CAN interfaces of this computer");
  if (interfaces.empty()) std::puts("  none");
  for (const auto& i : interfaces)
    std::printf("  %-10s  %s  needs %s\n", i.name.c_str(), i.up ? "on " : "off",
                needs_of(i).c_str());
  return {};
}

}  // namespace

void add_devices(CLI::App& app, Action& action) {
  auto options = std::make_shared<DevicesOptions>();
  CLI::App* command = app.add_subcommand("devices", "What can be connected, and what it needs");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->add_option("--config", options->config, "Device file (TOML) to look at");
  command->add_flag("--check", options->check, "Check that file");
  command->footer("Example:\n  isograsp devices --config clinic.toml --check");
  command->callback([options, &action] { action = [options] { return run_devices(*options); }; });
}

}  // namespace isograsp
