// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp record: finger forces of a device to CSV, and the raw frames of its bus to a log.
#include <atomic>
#include <cstdio>
#include <memory>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/live_device.hpp"
#include "core/csv.hpp"
#include "core/finger_forces.hpp"
#include "device/can_bus.hpp"
#include "device/candump_log.hpp"
#include "device/uri.hpp"

namespace isograsp {

namespace {

struct RecordOptions {
  std::string device;
  std::string out;
  std::string raw;
  double duration_s = 0.0;
};

/// Writes every frame of a bus to a candump log, commands included, on a thread and a socket of its
/// own: the log is complete whatever the driver does.
class RawLog {
 public:
  [[nodiscard]] static Result<std::unique_ptr<RawLog>> open(const RecordOptions& options) {
    const auto uri = Uri::parse(options.device);
    if (!uri) return uri.error();
    if (uri->scheme != "can")
      return Error{Error::Code::bad_input,
                   "only devices on a bus have raw frames",
                   "leave it out, or record a can:// device",
                   "",
                   0,
                   "--raw"};
    auto bus = open_socketcan(uri->target, {});
    if (!bus) return bus.error();
    auto file = FileWriter::create(options.raw);
    if (!file) return file.error();
    return std::unique_ptr<RawLog>(new RawLog(uri->target, *std::move(bus), *std::move(file)));
  }

  Result<void> start() {
    if (auto started = bus_->start(clock_); !started) return started;
    thread_ = std::thread([this] { run(); });
    return {};
  }
  Result<void> finish() {
    stop();
    return file_.commit();
  }
  ~RawLog() { stop(); }

 private:
  RawLog(std::string interface, std::unique_ptr<CanBus> bus, FileWriter file)
      : interface_(std::move(interface)), bus_(std::move(bus)), file_(std::move(file)) {}

  void stop() {
    running_ = false;
    if (thread_.joinable()) thread_.join();
  }
  void run() {
    constexpr Timestamp kLook = std::chrono::milliseconds(50);
    ReceivedFrame in;
    while (true) {
      const BusEvent event = bus_->receive(clock_.now() + kLook, in);
      if (event == BusEvent::frame || event == BusEvent::bus_off)
        file_.write(format_candump_line(in.wall_time, interface_, in.frame) + "\n");
      else if (!running_)
        return;
    }
  }

  std::string interface_;
  SteadyClock clock_;
  std::unique_ptr<CanBus> bus_;
  FileWriter file_;
  std::atomic<bool> running_{true};
  std::thread thread_;
};

Result<void> run_record(const RecordOptions& options) {
  auto live = LiveDevice::open(options.device);
  if (!live) return live.error();
  std::unique_ptr<RawLog> raw;
  if (!options.raw.empty()) {
    auto opened = RawLog::open(options);
    if (!opened) return opened.error();
    raw = *std::move(opened);
  }
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();

  const DeviceInfo& info = live->device().info();
  std::string text = "# isograsp finger forces, contact frames\n# device: " + info.uri + "\n";
  if (info.simulated) text += "# simulated\n";
  for (const auto& line : info.provenance) text += "# " + line + "\n";
  for (const auto& name : finger_forces_columns()) text += (name == "t_s" ? "" : ",") + name;
  file->write(text + "\n");

  if (raw)
    if (auto started = raw->start(); !started) return started;
  std::uint64_t rows = 0;
  std::uint64_t missing = 0;
  ProgressBar progress("Recording");
  DeviceHealth health;
  const auto done = live->run(options.duration_s, [&](const FingerFrame& frame) {
    FingerForcesRow row;
    row.t_s = frame.t_s;
    row.wrench_C = frame.wrench_C;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      row.present[f] = (frame.flags[f] & bit(SampleFlag::missing)) == 0;
    text.clear();
    append_finger_forces(text, row);
    file->write(text);
    ++rows;
    if (frame.any(SampleFlag::missing)) ++missing;
    health = live->device().health();
    progress.show(frame.t_s / options.duration_s, name_of(health.state));
    return true;
  });
  if (!done) return done.error();
  if (auto written = file->commit(); !written) return written;
  if (raw)
    if (auto written = raw->finish(); !written) return written;
  std::uint64_t lost = 0;
  for (const auto& sensor : health.sensors) lost += sensor.lost;
  std::printf("%s: %llu rows, %llu of them with a finger missing; %llu samples lost\n",
              options.out.c_str(), static_cast<unsigned long long>(rows),
              static_cast<unsigned long long>(missing), static_cast<unsigned long long>(lost));
  return {};
}

}  // namespace

void add_record(CLI::App& app, Action& action) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command = app.add_subcommand("record", "Finger forces to CSV, raw frames to a log");
  command->add_option("--device", options->device, "Device URI (see: isograsp devices)")
      ->required();
  command->add_option("--out", options->out, "Finger-forces file to write (CSV)")->required();
  command->add_option("--raw", options->raw, "Log of every frame on the bus (candump format)");
  command->add_option("--duration", options->duration_s, "Seconds")
      ->required()
      ->check(CLI::Range(0.001, 1e6));
  command->footer(
      "Example:\n  isograsp record --device 'can://can0?protocol=rft' --out forces.csv --raw "
      "frames.log --duration 60");
  command->callback([options, &action] { action = [options] { return run_record(*options); }; });
}

}  // namespace isograsp
