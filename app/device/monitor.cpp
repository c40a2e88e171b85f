// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp monitor: live forces, rates and health counters of a device.
#include <array>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/device/live_device.hpp"
#include "app/language.hpp"
#include "app/realtime_option.hpp"

namespace isograsp::app {

namespace {

struct MonitorOptions {
  std::string device;
  double duration_s = 0.0;
  bool json = false;
  RealtimeOption realtime;
};

/// What was seen so far of one finger.
struct Seen {
  Wrench last_C;
  double peak_N = 0.0;  ///< largest force along z
};

void print_live(const FingerFrame& frame, const DeviceHealth& health) {
  print("%8.2f s  %-9s", frame.t_s, std::string(name_of(health.state)).c_str());
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if ((frame.flags[f] & bit(SampleFlag::missing)) != 0)
      print("  %s %23s", std::string(kFingerNames[f]).c_str(), "no value");
    else
      print("  %s %7.2f %7.2f %7.2f", std::string(kFingerNames[f]).c_str(),
            frame.wrench_C[f].force.x(), frame.wrench_C[f].force.y(), frame.wrench_C[f].force.z());
  }
  print(" N\n");
  std::fflush(stdout);
}

nlohmann::ordered_json as_json(const DeviceInfo& info, const DeviceHealth& health,
                               const std::array<Seen, kFingerCount>& seen, double seconds,
                               std::uint64_t frames, std::uint64_t missing,
                               const session::Timing& timing) {
  nlohmann::ordered_json document{
      {"device", info.uri},
      {"description", english(info.description)},
      {"simulated", info.simulated},
      {"duration_s", seconds},
      {"frames", frames},
      {"frames_with_missing_values", missing},
      {"state", name_of(health.state)},
      {"fault", health.fault == DeviceFault::none ? nlohmann::ordered_json(nullptr)
                                                  : nlohmann::ordered_json(name_of(health.fault))},
      {"fault_text", words_of(health.fault, health.finger).english()},
      {"foreign_frames", health.foreign_frames},
      {"kernel_drops", health.bus.kernel_drops},
      {"bus_overflows", health.bus.overflows},
      {"error_frames", health.bus.error_frames},
      {"unsent_frames", health.bus.unsent}};
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& counters = health.sensors[f];
    const auto& w = seen[f].last_C;
    document["sensors"].push_back(
        {{"finger", kFingerNames[f]},
         {"serial_number", info.serial_numbers[f]},
         {"rate_Hz", seconds > 0.0 ? static_cast<double>(counters.good) / seconds : 0.0},
         {"force_N", {w.force.x(), w.force.y(), w.force.z()}},
         {"torque_Nm", {w.torque.x(), w.torque.y(), w.torque.z()}},
         {"peak_fz_N", seen[f].peak_N},
         {"good", counters.good},
         {"invalid", counters.invalid},
         {"torn", counters.torn},
         {"duplicate", counters.duplicate},
         {"late", counters.late},
         {"lost", counters.lost},
         {"stale", counters.stale},
         {"saturated", counters.saturated},
         {"overload", counters.overload},
         {"status_errors", counters.status_errors},
         {"restarts", counters.restarts}});
  }
  document["timing"] = nlohmann::ordered_json::parse(session::as_json(timing));
  return document;
}

void print_summary(const DeviceInfo& info, const DeviceHealth& health, double seconds) {
  print_line("%1, %2 s"_text(info.description, fixed(seconds, 2)));
  if (health.fault != DeviceFault::none) print_line(words_of(health.fault, health.finger));
  print("%-7s %8s %8s %8s %8s %8s %8s %8s %9s %8s %8s\n", "", "rate/Hz", "good", "invalid", "torn",
        "late", "lost", "stale", "saturated", "overload", "restarts");
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& c = health.sensors[f];
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    print("%-7s %8.2f %8llu %8llu %8llu %8llu %8llu %8llu %9llu %8llu %8llu\n",
          std::string(kFingerNames[f]).c_str(),
          seconds > 0.0 ? static_cast<double>(c.good) / seconds : 0.0, number(c.good),
          number(c.invalid), number(c.torn), number(c.late), number(c.lost), number(c.stale),
          number(c.saturated), number(c.overload), number(c.restarts));
  }
  print_line("foreign frames %1, frames that the kernel dropped %2"_text(health.foreign_frames,
                                                                         health.bus.kernel_drops));
}

Result<void> run_monitor(const MonitorOptions& options) {
  auto live = LiveDevice::open(options.device);
  if (!live) return live.error();
  if (auto got = LiveDevice::ask_for(options.realtime.wish()); !got) return got.error();
  constexpr double kPrintEvery_s = 0.5;
  std::array<Seen, kFingerCount> seen{};
  std::uint64_t frames = 0;
  std::uint64_t missing = 0;
  double seconds = 0.0;
  double next_print_s = 0.0;
  DeviceHealth health;
  const auto done = live->run(options.duration_s, [&](const FingerFrame& frame) {
    health = live->device().health();
    ++frames;
    if (frame.any(SampleFlag::missing)) ++missing;
    seconds = frame.t_s + live->device().info().frame_period_s;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if ((frame.flags[f] & bit(SampleFlag::missing)) != 0) continue;
      seen[f].last_C = frame.wrench_C[f];
      seen[f].peak_N = std::max(seen[f].peak_N, frame.wrench_C[f].force.z());
    }
    if (!options.json && frame.t_s >= next_print_s) {
      print_live(frame, health);
      next_print_s += kPrintEvery_s;
    }
    return true;
  });
  if (!done) return done.error();
  const DeviceInfo& info = live->device().info();
  if (options.json)
    print_json(as_json(info, health, seen, seconds, frames, missing, live->timing()));
  else
    print_summary(info, health, seconds);
  return {};
}

}  // namespace

void add_monitor(CommandLine& line) {
  auto options = std::make_shared<MonitorOptions>();
  Subcommand command = line.subcommand("monitor", "Live forces, rates and health of a device");
  command.option("--device", options->device, "Device URI (see: isograsp devices)").required();
  command.option("--duration", options->duration_s, "Seconds; without it until Ctrl-C")
      .range(0.001, 1e6);
  command.flag("--json", options->json, "Print one JSON document at the end");
  options->realtime.add_to(command);
  command.footer("Example:\n  isograsp monitor --device 'can://can0?protocol=rft' --duration 10");
  command.runs([options] { return run_monitor(*options); });
}

}  // namespace isograsp::app
