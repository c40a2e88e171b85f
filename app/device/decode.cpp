// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp decode: a raw log to samples, offline. Values are in the sensor frames, before zero and
// mounting.
#include <cstdio>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "app/device/live_device.hpp"
#include "core/csv.hpp"
#include "device/config/device_config.hpp"
#include "device/config/family_facts.hpp"
#include "device/recording/log_samples.hpp"

namespace isograsp::app {

namespace {

struct DecodeOptions {
  std::string protocol;
  std::string config;
  std::string log;
  std::string out;
  bool json = false;
};

void append_sample(std::string& text, const std::string& time_text, const DecodedSample& sample) {
  text = time_text + ',' + std::string(kFingerNames[sample.finger]);
  for (const Vec3& part : {sample.wrench_S.force, sample.wrench_S.torque})
    for (int axis = 0; axis < 3; ++axis) {
      text += ',';
      append_number(text, part[axis]);
    }
  text += sample.valid ? ",1," : ",0,";
  text += sample.flags + "\n";
}

nlohmann::ordered_json as_json(const DecodeOptions& options, const LogReport& report) {
  nlohmann::ordered_json document{{"log", options.log}, {"out", options.out}};
  nlohmann::ordered_json sensors = nlohmann::ordered_json::array();
  DecodedCounts sum;
  sum.foreign = report.foreign;
  sum.commands = report.commands;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const DecodedCounts& c = report.sensors[f];
    sum.samples += c.samples;
    sum.torn += c.torn;
    sum.duplicate += c.duplicate;
    sum.foreign += c.foreign;
    sum.uncalibrated += c.uncalibrated;
    sum.answers += c.answers;
    sum.commands += c.commands;
    sensors.push_back({{"finger", kFingerNames[f]},
                       {"samples", c.samples},
                       {"torn", c.torn},
                       {"duplicate", c.duplicate},
                       {"foreign", c.foreign},
                       {"uncalibrated", c.uncalibrated}});
  }
  document["samples"] = sum.samples;
  document["torn"] = sum.torn;
  document["duplicate"] = sum.duplicate;
  document["foreign"] = sum.foreign;
  document["uncalibrated"] = sum.uncalibrated;
  document["answers"] = sum.answers;
  document["commands"] = sum.commands;
  document["sensors"] = sensors;
  return document;
}

Result<void> run_decode(const DecodeOptions& options) {
  const auto config = family_config(options.protocol, options.config);
  if (!config) return config.error();
  if (auto different = check_different(options.log, options.out); !different) return different;
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();
  file->write("t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags\n");
  std::string text;
  const auto report =
      read_log(options.log, *config, !options.config.empty(),
               [&](const std::string& time_text, Timestamp, const DecodedSample& sample) {
                 append_sample(text, time_text, sample);
                 file->write(text);
               });
  if (!report) return report.error();
  if (auto written = file->commit(); !written) return written;

  const auto document = as_json(options, *report);
  if (options.json) {
    print_json(document);
    return {};
  }
  const auto number = [&](const char* key) { return document[key].get<unsigned long long>(); };
  print_aside("%s: %llu samples; frames: %llu torn, %llu duplicate, %llu foreign\n",
              printable(options.log).c_str(), number("samples"), number("torn"),
              number("duplicate"), number("foreign"));
  if (number("uncalibrated") > 0)
    print_aside("%s: %llu samples left out: the log does not tell their scale\n",
                printable(options.log).c_str(), number("uncalibrated"));
  return {};
}

}  // namespace

void add_decode(CommandLine& line) {
  auto options = std::make_shared<DecodeOptions>();
  Subcommand command = line.subcommand("decode", "A raw log to samples, offline");
  command.option("--protocol", options->protocol, family_names()).required();
  command.option("--config", options->config, "Device file (TOML) with addresses and scales");
  command.option("LOG", options->log, "candump log; for net-ft a log of datagrams").required();
  command.option("--out", options->out, "Samples to write (CSV)").required();
  command.flag("--json", options->json, "Print the counts as one JSON document");
  command.footer("Example:\n  isograsp decode --protocol rft frames.log --out samples.csv");
  command.runs([options] { return run_decode(*options); });
}

}  // namespace isograsp::app
