// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp record: finger forces of a device to CSV, and the raw frames of its bus to a log.
#include <cstdio>
#include <memory>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/device/live_device.hpp"
#include "app/device/raw_log.hpp"
#include "app/realtime_option.hpp"
#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "hand/finger_forces.hpp"

namespace isograsp::app {

namespace {

struct RecordOptions {
  std::string device;
  std::string out;
  std::string raw;
  double duration_s = 0.0;
  RealtimeOption realtime;
};

Result<void> run_record(const RecordOptions& options) {
  std::unique_ptr<RawLog> raw;
  if (!options.raw.empty()) {
    auto opened = RawLog::open(options.device, options.raw);
    if (!opened) return opened.error();
    raw = *std::move(opened);
  }
  auto live = LiveDevice::open(options.device, raw ? raw->tap() : nullptr);
  if (!live) return live.error();
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();

  const DeviceInfo& info = live->device().info();
  std::string text = "# isograsp finger forces, contact frames\n# device: " + info.uri + "\n";
  if (info.simulated) text += "# simulated\n";
  for (const auto& line : info.provenance) text += "# " + line + "\n";
  for (const auto& name : finger_forces_columns()) text += (name == columns::t_s ? "" : ",") + name;
  file->write(text + "\n");

  if (raw) raw->start();
  if (auto got = LiveDevice::ask_for(options.realtime.wish()); !got) return got.error();
  std::uint64_t rows = 0;
  std::uint64_t missing = 0;
  ProgressBar progress("Recording"_text);
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
    progress.show(frame.t_s / options.duration_s, "%1"_text(std::string(name_of(health.state))));
    return true;
  });
  if (!done) return done.error();
  if (auto written = file->commit(); !written) return written;
  if (raw)
    if (auto written = raw->finish(); !written) return written;
  std::uint64_t lost = 0;
  for (const auto& sensor : health.sensors) lost += sensor.lost;
  print_line("%1: %2 rows, %3 of them with a finger missing; %4 samples lost"_text(
      options.out, rows, missing, lost));
  return {};
}

}  // namespace

void add_record(CommandLine& line) {
  auto options = std::make_shared<RecordOptions>();
  Subcommand command = line.subcommand("record", "Finger forces to CSV, raw frames to a log");
  command.option("--device", options->device, "Device URI (see: isograsp devices)").required();
  command.option("--out", options->out, "Finger-forces file to write (CSV)").required();
  command.option("--raw", options->raw, "Log of the frames to and from the sensors");
  command.option("--duration", options->duration_s, "Seconds").required().range(0.001, 1e6);
  options->realtime.add_to(command);
  command.footer(
      "Example:\n  isograsp record --device 'can://can0?protocol=rft' --out forces.csv --raw "
      "frames.log --duration 60");
  command.runs([options] { return run_record(*options); });
}

}  // namespace isograsp::app
