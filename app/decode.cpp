// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp decode: a raw log to samples, offline. Values are in the sensor frames, before zero and
// mounting.
#include <array>
#include <cstdio>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "core/csv.hpp"
#include "device/candump_log.hpp"
#include "device/device_config.hpp"
#include "device/rft_codec.hpp"

namespace isograsp {

namespace {

struct DecodeOptions {
  std::string protocol;
  std::string config;
  std::string log;
  std::string out;
  bool json = false;
};

struct DecodeCounts {
  std::array<std::uint64_t, kFingerCount> samples{};
  std::uint64_t answers = 0;
  std::uint64_t commands = 0;
  std::uint64_t foreign = 0;  ///< frames that none of the sensors sends or hears
};

std::string overload_words(std::uint8_t overload) {
  constexpr std::array<const char*, 6> kAxes{"fx", "fy", "fz", "tx", "ty", "tz"};
  std::string words;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    if ((overload & (0x20U >> axis)) == 0) continue;
    words += words.empty() ? "overload_" : "+overload_";
    words += kAxes[axis];
  }
  return words;
}

void append_sample(std::string& text, const std::string& time_text, std::size_t finger,
                   const RftCounts& counts, const RftDivisors& divisors) {
  const Wrench wrench_S = wrench_of(counts, divisors);
  text += time_text;
  text += ',';
  text += kFingerNames[finger];
  for (const Vec3& part : {wrench_S.force, wrench_S.torque})
    for (int axis = 0; axis < 3; ++axis) {
      text += ',';
      append_number(text, part[axis]);
    }
  text += ",1," + overload_words(counts.overload) + "\n";
}

nlohmann::ordered_json as_json(const DecodeOptions& options, const DecodeCounts& counts,
                               const std::array<RftPairing, kFingerCount>& sensors) {
  nlohmann::ordered_json document{{"log", options.log}, {"out", options.out}};
  std::uint64_t samples = 0;
  std::uint64_t torn = 0;
  std::uint64_t duplicate = 0;
  std::uint64_t foreign = counts.foreign;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    samples += counts.samples[f];
    torn += sensors[f].torn();
    duplicate += sensors[f].duplicate();
    foreign += sensors[f].foreign();
  }
  document["samples"] = samples;
  document["torn"] = torn;
  document["duplicate"] = duplicate;
  document["foreign"] = foreign;
  document["answers"] = counts.answers;
  document["commands"] = counts.commands;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    document["sensors"].push_back({{"finger", kFingerNames[f]},
                                   {"samples", counts.samples[f]},
                                   {"torn", sensors[f].torn()},
                                   {"duplicate", sensors[f].duplicate()},
                                   {"foreign", sensors[f].foreign()}});
  return document;
}

Result<void> decode_rft(const DecodeOptions& options) {
  RftConfig config = RftConfig::standard();
  if (!options.config.empty()) {
    auto read = RftConfig::read(options.config);
    if (!read) return read.error();
    config = *std::move(read);
  }
  if (auto different = check_different(options.log, options.out); !different) return different;
  auto log = CandumpReader::open(options.log);
  if (!log) return log.error();
  auto file = FileWriter::create(options.out);
  if (!file) return file.error();
  file->write("t_s,sensor,fx_N,fy_N,fz_N,tx_Nm,ty_Nm,tz_Nm,valid,flags\n");

  std::array<RftPairing, kFingerCount> sensors{RftPairing(config.sensors[0].ids),
                                               RftPairing(config.sensors[1].ids),
                                               RftPairing(config.sensors[2].ids)};
  DecodeCounts counts;
  std::string
      interface;  // of the first frame of a sensor; the same identifiers elsewhere are others
  const auto sensor_of = [&](const CandumpEntry& entry) -> std::optional<std::size_t> {
    if (entry.flexible_data_rate) return std::nullopt;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const RftIds& ids = config.sensors[f].ids;
      if (entry.frame.id != ids.first && entry.frame.id != ids.second) continue;
      if (interface.empty()) interface = entry.interface;
      if (entry.interface == interface) return f;
    }
    return std::nullopt;
  };
  const auto is_command = [&](const CandumpEntry& entry) {
    if (entry.frame.extended || entry.frame.error || entry.frame.remote) return false;
    for (const auto& sensor : config.sensors)
      if (entry.frame.id == sensor.ids.command) return true;
    return false;
  };

  CandumpEntry entry;
  std::string text;
  bool any_frame = false;
  while (true) {
    const auto more = log->next(entry);
    if (!more) return more.error();
    if (!*more) break;
    any_frame = true;
    const auto f = sensor_of(entry);
    if (!f) {
      ++(is_command(entry) ? counts.commands : counts.foreign);
      continue;
    }
    const auto packet = sensors[*f].push(entry.frame, entry.wall_time);
    if (!packet) continue;
    if (!packet->is_data()) {
      ++counts.answers;
      continue;
    }
    ++counts.samples[*f];
    text.clear();
    append_sample(text, entry.time_text, *f, decode_counts(*packet), config.sensors[*f].divisors);
    file->write(text);
  }
  if (!any_frame)
    return Error{
        Error::Code::bad_input,
        "holds no frame",
        "give a candump log, with lines like (1700000000.076479) can0 001#0B0269FEEDF69F00",
        options.log,
        0,
        ""};
  for (auto& sensor : sensors) sensor.finish();
  if (auto written = file->commit(); !written) return written;

  const auto document = as_json(options, counts, sensors);
  if (options.json) {
    std::puts(document.dump(2).c_str());
  } else {
    const auto number = [&](const char* key) { return document[key].get<unsigned long long>(); };
    std::fprintf(stderr, "%s: %llu samples; frames: %llu torn, %llu duplicate, %llu foreign\n",
                 options.log.c_str(), number("samples"), number("torn"), number("duplicate"),
                 number("foreign"));
  }
  return {};
}

Result<void> run_decode(const DecodeOptions& options) {
  if (options.protocol != "rft")
    return Error{Error::Code::bad_input,
                 "no protocol is called '" + options.protocol + "'",
                 "use rft",
                 "",
                 0,
                 "--protocol"};
  return decode_rft(options);
}

}  // namespace

void add_decode(CLI::App& app, Action& action) {
  auto options = std::make_shared<DecodeOptions>();
  CLI::App* command = app.add_subcommand("decode", "A raw log to samples, offline");
  command->add_option("--protocol", options->protocol, "rft")->required();
  command->add_option("--config", options->config, "Device file (TOML) with identifiers, divisors");
  command->add_option("LOG", options->log, "candump log")->required();
  command->add_option("--out", options->out, "Samples to write (CSV)")->required();
  command->add_flag("--json", options->json, "Print the counts as one JSON document");
  command->footer("Example:\n  isograsp decode --protocol rft frames.log --out samples.csv");
  command->callback([options, &action] { action = [options] { return run_decode(*options); }; });
}

}  // namespace isograsp
