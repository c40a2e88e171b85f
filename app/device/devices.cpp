// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp devices: what can be connected here and what it would need.
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/device/live_device.hpp"
#include "app/language.hpp"
#include "device/bus/bus.hpp"
#include "device/config/device_config.hpp"
#include "device/config/family_facts.hpp"
#include "device/sensors/device_check.hpp"

namespace isograsp::app {

namespace {

struct DevicesOptions {
  bool json = false;
  bool check = false;
  std::string config;
  std::string device;
  double weight_N = 0.0;
  std::optional<Hand> hand;  ///< for which the platform stands
};

struct Scheme {
  std::string uri;
  std::string_view what;
  std::string_view needs;
};

/// What can be connected: the software, then the families of sensors, bus by bus.
std::vector<Scheme> schemes() {
  std::vector<Scheme> all{
      {"sim://healthy", "simulated sensors, pressed by a healthy virtual patient", "nothing"},
      {"sim://paretic", "simulated sensors, pressed by a paretic virtual patient", "nothing"},
      {"replay://FILE.csv?speed=1", "a recorded finger-forces file", "the file"},
      {"sim://arm?patient=healthy", "an arm with markers, moved by a virtual patient", "nothing"},
      {"replay://FILE?rig=RIG", "a recording of markers (C3D, TRC, TSV, CSV)", "the file, a rig"},
      {"qtm://HOST?rig=RIG", "markers from Qualisys Track Manager", "its computer, a rig"},
      {"natnet://HOST?rig=RIG", "markers from Motive (NatNet)", "its computer, a rig"}};
  constexpr std::array<std::string_view, 3> kBuses{"can://IFACE", "udp://HOST,HOST,HOST",
                                                   "serial://PORT,PORT,PORT"};
  for (const auto address : kBuses)
    for (const FamilyFacts* family : all_families())
      for (const FamilyBus& bus : family->buses)
        if (address.substr(0, address.find(':')) == bus.scheme && !bus.devices.empty())
          all.push_back({std::string(address) + "?protocol=" + std::string(family->name),
                         bus.devices, bus.needs});
  return all;
}

std::string needs_of(const CanInterface& interface) {
  return interface.up
             ? "nothing: it is on"
             : "sudo ip link set " + interface.name + " up type can bitrate 1000000 restart-ms 100";
}

nlohmann::ordered_json as_json(const std::string& path, const DeviceConfig& config) {
  nlohmann::ordered_json document{
      {"config", path},
      {"protocol", config.family->name},
      {"hand", config.hand ? nlohmann::ordered_json(name_of(*config.hand)) : "both"},
      {"rate_Hz", config.rate_Hz},
      {"filter_Hz", config.filter_Hz},
      {"fir_taps", config.fir_taps},
      {"sensors", nlohmann::ordered_json::array()}};
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& s = config.sensors[f];
    document["sensors"].push_back(
        {{"finger", kFingerNames[f]},
         {"way", config.family->place(s)},
         {"serial_number", s.serial_number},
         {"calibration", s.calibration ? nlohmann::ordered_json(s.calibration->file)
                                       : nlohmann::ordered_json(nullptr)}});
  }
  return document;
}

void print_config(const std::string& path, const DeviceConfig& config) {
  print_line("%1 is good: %2, %3 Hz."_text(path, config.family->title, shortest(config.rate_Hz)));
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& s = config.sensors[f];
    const Text number = s.serial_number.empty() ? "any serial number"_text
                                                : "serial number %1"_text(s.serial_number);
    print("  %-6s  %s, %s\n", std::string(kFingerNames[f]).c_str(),
          printable(config.family->place(s)).c_str(), printable(spoken(number)).c_str());
  }
}

/// Leads the therapist through every support; presses are detected without a key.
Result<nlohmann::ordered_json> walk_through(const DevicesOptions& options,
                                            const std::string& device) {
  auto live = LiveDevice::open(device);
  if (!live) return live.error();
  const auto say = [&](const Text& text) {
    if (!options.json) {
      print_line(text);
      std::fflush(stdout);
    }
  };
  std::optional<double> weight_N;
  if (options.weight_N > 0.0) weight_N = options.weight_N;
  // A platform for both hands is set up for one of them now, and so tells where the wrist is.
  const auto& info = live->device().info();
  const Hand hand = options.hand.value_or(info.hand.value_or(Hand::right));
  if (info.hand) {
    if (hand != *info.hand)
      return refused("the device is set up for the %1 hand"_text(
                         Known{std::string(name_of(*info.hand))}),
                     "leave out --hand"_text)
          .at(device)
          .about("--hand");
  } else if (!options.hand) {
    say("The platform is taken to stand for the right hand; add --hand left for the other one."_text);
  }
  DeviceCheck check(info.frame_period_s, hand, weight_N);
  say("Take everything off the supports and do not touch them."_text);
  bool empty_known = false;
  const auto run = live->run(0.0, [&](const FingerFrame& frame) {
    if (!empty_known) {
      empty_known = check.add_empty(frame);
      if (empty_known) say(check.step().instruction());
      return true;
    }
    const auto result = check.add(frame);
    if (!result) return true;
    say("  %1"_text(result->sentence()));
    if (!check.complete()) say(joined({"Let go."_text, check.step().instruction()}));
    return !check.complete();
  });
  if (!run) return run.error();
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();
  const CheckResult* wrong = nullptr;
  for (const auto& r : check.results()) {
    steps.push_back({{"finger", name_of(r.step.finger)},
                     {"press", name_of(r.step.press)},
                     {"good", r.verdict == CheckVerdict::good},
                     {"felt_by", name_of(r.felt_by)},
                     {"force_N", {r.force_N.x(), r.force_N.y(), r.force_N.z()}},
                     {"sentence", english(r.sentence())}});
    if (r.verdict != CheckVerdict::good && wrong == nullptr) wrong = &r;
  }
  if (!check.complete())
    return failed("the check was not finished"_text, "begin it again"_text).at(device);
  if (wrong != nullptr) return failed("the device did not pass"_text, wrong->sentence()).at(device);
  say("The device passed."_text);
  return steps;
}

/// The device of this file, if the options or the file name it; else empty.
std::string device_of(const DevicesOptions& options, const DeviceConfig& config) {
  if (!options.device.empty()) return options.device;
  if (config.interface.empty()) return "";
  return "can://" + config.interface + "?config=" + options.config;
}

Result<void> check_config(const DevicesOptions& options) {
  const auto config = DeviceConfig::read(options.config);
  if (!config) return config.error();
  auto document = as_json(options.config, *config);
  if (!options.json) print_config(options.config, *config);
  if (const auto device = device_of(options, *config); options.check && !device.empty()) {
    auto steps = walk_through(options, device);
    if (!steps) return steps.error();
    document["steps"] = *steps;
  } else if (options.check && !options.json) {
    print_line(
        "To be led through every support, connect the device and add its address, for example "
        "--device 'can://can0?config=%1'."_text(options.config));
  }
  if (options.json) print_json(document);
  return {};
}

Result<void> run_devices(const DevicesOptions& options) {
  if (!options.config.empty()) return check_config(options);
  if (options.check)
    return refused("there is nothing to check"_text, "add --config FILE"_text).about("--check");
  const auto interfaces = list_can_interfaces();
  if (options.json) {
    nlohmann::ordered_json document{{"schemes", nlohmann::ordered_json::array()},
                                    {"can_interfaces", nlohmann::ordered_json::array()}};
    for (const auto& s : schemes())
      document["schemes"].push_back({{"uri", s.uri}, {"what", s.what}, {"needs", s.needs}});
    for (const auto& i : interfaces)
      document["can_interfaces"].push_back(
          {{"name", i.name}, {"up", i.up}, {"needs", needs_of(i)}});
    print_json(document);
    return {};
  }
  print_line("Devices"_text);
  for (const auto& s : schemes())
    print("  %-26s  %s\n  %-26s  needs %s\n", s.uri.c_str(), std::string(s.what).c_str(), "",
          std::string(s.needs).c_str());
  print_line("CAN interfaces of this computer"_text);
  if (interfaces.empty()) print_line("  none"_text);
  for (const auto& i : interfaces)
    print("  %-10s  %s  needs %s\n", i.name.c_str(), i.up ? "on " : "off", needs_of(i).c_str());
  return {};
}

}  // namespace

void add_devices(CommandLine& line) {
  auto options = std::make_shared<DevicesOptions>();
  Subcommand command = line.subcommand("devices", "What can be connected, and what it needs");
  command.flag("--json", options->json, "Print one JSON document");
  command.option("--config", options->config, "Device file (TOML) to look at");
  command.flag("--check", options->check,
               "Check that file and, with the device connected, every support");
  command.option("--device", options->device,
                 "Where the sensors are, if the file does not name the interface");
  command.option("--weight", options->weight_N, "Reference weight in newtons").range(0.5, 100.0);
  command.option("--hand", options->hand,
                 "For which the platform stands, if its file does not say it");
  command.footer("Example:\n  isograsp devices --config clinic.toml --check");
  command.runs([options] { return run_devices(*options); });
}

}  // namespace isograsp::app
