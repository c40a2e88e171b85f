// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp decode: a raw log to samples, offline. Values are in the sensor frames, before zero and
// mounting.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/live_device.hpp"
#include "core/csv.hpp"
#include "device/bus/candump_log.hpp"
#include "device/bus/datagram_log.hpp"
#include "device/device_config.hpp"
#include "device/protocol/log_decoder.hpp"
#include "device/protocol/net_ft_decoder.hpp"

namespace isograsp {

namespace {

struct DecodeOptions {
  std::string protocol;
  std::string config;
  std::string log;
  std::string out;
  bool json = false;
};

/// What a log held, by sensor and besides.
struct DecodeReport {
  std::array<DecodedCounts, kFingerCount> sensors{};
  std::uint64_t commands = 0;  ///< that are meant for all sensors
  std::uint64_t foreign = 0;   ///< frames that none of the sensors sends or hears
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

Error empty_log(const DecodeOptions& options, const char* example) {
  return {Error::Code::bad_input,
          "holds no frame",
          std::string("give a log with lines like ") + example,
          options.log,
          0,
          ""};
}

Result<DecodeReport> decode_can(const DecodeOptions& options, const DeviceConfig& config,
                                FileWriter& file) {
  DecodeReport report;
  std::unique_ptr<LogDecoder> decoder = make_log_decoder(config);
  std::string interface;  // of the first frame of a sensor; the same numbers elsewhere are others
  bool any_frame = false;
  const auto read = [&](const auto& on_sample) -> Result<void> {
    auto log = CandumpReader::open(options.log);
    if (!log) return log.error();
    report = {};
    CandumpEntry entry;
    while (true) {
      const auto more = log->next(entry);
      if (!more) return more.error();
      if (!*more) break;
      any_frame = true;
      constexpr std::uint32_t kSync = 0x080;
      if (config.protocol == Protocol::jr3_can && entry.frame.is_standard() &&
          entry.frame.id == kSync && entry.frame.length == 0) {
        ++report.commands;
        continue;
      }
      const bool ours = !entry.flexible_data_rate && decoder->owns(entry.frame);
      if (ours && interface.empty()) interface = entry.interface;
      if (!ours || entry.interface != interface) {
        ++report.foreign;
        continue;
      }
      if (const auto sample = decoder->push(entry.frame, entry.wall_time))
        on_sample(entry, *sample);
    }
    decoder->finish();
    return {};
  };
  if (decoder->second_reading() != nullptr) {
    if (auto learned = read([](const auto&, const auto&) {}); !learned) return learned.error();
    decoder = decoder->second_reading();
  }
  std::string text;
  const auto done = read([&](const CandumpEntry& entry, const DecodedSample& sample) {
    append_sample(text, entry.time_text, sample);
    file.write(text);
  });
  if (!done) return done.error();
  if (!any_frame) return empty_log(options, "(1700000000.076479) can0 001#0B0269FEEDF69F00");
  for (std::size_t f = 0; f < kFingerCount; ++f) report.sensors[f] = decoder->counts(f);
  return report;
}

/// Calls `take` with every datagram of the log.
Result<void> read_datagrams(const std::string& path,
                            const std::function<void(const DatagramEntry&)>& take) {
  auto log = DatagramLogReader::open(path);
  if (!log) return log.error();
  DatagramEntry entry;
  while (true) {
    const auto more = log->next(entry);
    if (!more) return more.error();
    if (!*more) return {};
    take(entry);
  }
}

Result<DecodeReport> decode_net_ft(const DecodeOptions& options, const DeviceConfig& config,
                                   FileWriter& file) {
  std::vector<Endpoint> senders;
  bool any_frame = false;
  auto done = read_datagrams(options.log, [&](const DatagramEntry& entry) {
    any_frame = true;
    const bool known = std::find(senders.begin(), senders.end(), entry.from) != senders.end();
    if (!known && holds_net_ft_records(entry.bytes.size())) senders.push_back(entry.from);
  });
  if (!done) return done.error();
  if (!any_frame) return empty_log(options, "(1700000000.076479) 192.168.1.1:49152 00000001…");
  const auto fingers = options.config.empty() ? NetFtFingers::in_order(senders, options.log)
                                              : NetFtFingers::of(config);
  if (!fingers) return fingers.error();

  DecodeReport report;
  std::array<NetFtDecoder, kFingerCount> decoders;
  std::vector<NetFtSample> samples;
  std::string text;
  done = read_datagrams(options.log, [&](const DatagramEntry& entry) {
    const auto f = fingers->finger_of(entry.from);
    if (!f) {
      ++(decode_net_ft_request(entry.bytes) ? report.commands : report.foreign);
      return;
    }
    samples.clear();
    decoders[*f].push(entry.bytes, entry.wall_time, samples);
    report.sensors[*f].samples += samples.size();
    for (const auto& sample : samples) {
      append_sample(
          text, entry.time_text,
          {*f, sample.wrench_S, sample.valid, flag_words(sample.record, decoders[*f].product())});
      file.write(text);
    }
  });
  if (!done) return done.error();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    report.sensors[f].duplicate = decoders[f].sequence().duplicate();
    report.sensors[f].foreign = decoders[f].foreign();
    report.sensors[f].commands = decoders[f].requests();
  }
  return report;
}

nlohmann::ordered_json as_json(const DecodeOptions& options, const DecodeReport& report) {
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
  const auto report = config->protocol == Protocol::net_ft ? decode_net_ft(options, *config, *file)
                                                           : decode_can(options, *config, *file);
  if (!report) return report.error();
  if (auto written = file->commit(); !written) return written;

  const auto document = as_json(options, *report);
  if (options.json) {
    std::puts(document.dump(2).c_str());
    return {};
  }
  const auto number = [&](const char* key) { return document[key].get<unsigned long long>(); };
  std::fprintf(stderr, "%s: %llu samples; frames: %llu torn, %llu duplicate, %llu foreign\n",
               options.log.c_str(), number("samples"), number("torn"), number("duplicate"),
               number("foreign"));
  if (number("uncalibrated") > 0)
    std::fprintf(stderr, "%s: %llu samples left out: the log does not tell their scale\n",
                 options.log.c_str(), number("uncalibrated"));
  return {};
}

}  // namespace

void add_decode(CLI::App& app, Action& action) {
  auto options = std::make_shared<DecodeOptions>();
  CLI::App* command = app.add_subcommand("decode", "A raw log to samples, offline");
  command->add_option("--protocol", options->protocol, "rft, ati-netcanoem, jr3-can or net-ft")
      ->required();
  command->add_option("--config", options->config, "Device file (TOML) with addresses and scales");
  command->add_option("LOG", options->log, "candump log; for net-ft a log of datagrams")
      ->required();
  command->add_option("--out", options->out, "Samples to write (CSV)")->required();
  command->add_flag("--json", options->json, "Print the counts as one JSON document");
  command->footer("Example:\n  isograsp decode --protocol rft frames.log --out samples.csv");
  command->callback([options, &action] { action = [options] { return run_decode(*options); }; });
}

}  // namespace isograsp
