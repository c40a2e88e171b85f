// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/log_samples.hpp"

#include <memory>

#include "device/bus/candump_log.hpp"
#include "device/config/family_facts.hpp"

namespace isograsp {

namespace {

Result<LogReport> read_can_log(const std::string& path, const DeviceConfig& config,
                               const TakeSample& take) {
  LogReport report;
  std::unique_ptr<LogDecoder> decoder = config.family->make_log_decoder(config);
  std::string interface;  // of the first frame of a sensor: only this bus is decoded
  bool any_frame = false;
  const auto read = [&](const auto& on_sample) -> Result<void> {
    auto log = CandumpReader::open(path);
    if (!log) return log.error();
    report = {};
    CandumpEntry entry;
    while (true) {
      const auto more = log->next(entry);
      if (!more) return more.error();
      if (!*more) break;
      any_frame = true;
      if (decoder->for_all(entry.frame)) {
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
  const auto done = read([&](const CandumpEntry& entry, const DecodedSample& sample) {
    take(entry.time_text, entry.wall_time, sample);
  });
  if (!done) return done.error();
  if (!any_frame) return empty_log(path, "(1700000000.076479) can0 001#0B0269FEEDF69F00");
  for (std::size_t f = 0; f < kFingerCount; ++f) report.sensors[f] = decoder->counts(f);
  return report;
}

}  // namespace

Result<LogReport> read_log(const std::string& path, const DeviceConfig& config,
                           bool addresses_known, const TakeSample& take) {
  return config.family->read_log != nullptr
             ? config.family->read_log(path, config, addresses_known, take)
             : read_can_log(path, config, take);
}

}  // namespace isograsp
