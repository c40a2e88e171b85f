// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/log_samples.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "device/bus/candump_log.hpp"
#include "device/bus/datagram_log.hpp"
#include "device/protocol/net_ft_decoder.hpp"

namespace isograsp {

namespace {

Error empty_log(const std::string& path, const char* example) {
  return {Error::Code::bad_input,
          "holds no frame",
          std::string("give a log with lines like ") + example,
          path,
          0,
          ""};
}

Result<LogReport> read_can_log(const std::string& path, const DeviceConfig& config,
                               const TakeSample& take) {
  LogReport report;
  std::unique_ptr<LogDecoder> decoder = make_log_decoder(config);
  std::string interface;  // of the first frame of a sensor; the same numbers elsewhere are others
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
  const auto done = read([&](const CandumpEntry& entry, const DecodedSample& sample) {
    take(entry.time_text, entry.wall_time, sample);
  });
  if (!done) return done.error();
  if (!any_frame) return empty_log(path, "(1700000000.076479) can0 001#0B0269FEEDF69F00");
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

Result<LogReport> read_datagram_log(const std::string& path, const DeviceConfig& config,
                                    bool addresses_known, const TakeSample& take) {
  std::vector<Endpoint> senders;
  bool any_frame = false;
  auto done = read_datagrams(path, [&](const DatagramEntry& entry) {
    any_frame = true;
    const bool known = std::find(senders.begin(), senders.end(), entry.from) != senders.end();
    if (!known && holds_net_ft_records(entry.bytes.size())) senders.push_back(entry.from);
  });
  if (!done) return done.error();
  if (!any_frame) return empty_log(path, "(1700000000.076479) 192.168.1.1:49152 00000001…");
  const auto fingers =
      addresses_known ? NetFtFingers::of(config) : NetFtFingers::in_order(senders, path);
  if (!fingers) return fingers.error();

  LogReport report;
  std::array<NetFtDecoder, kFingerCount> decoders;
  std::vector<NetFtSample> samples;
  done = read_datagrams(path, [&](const DatagramEntry& entry) {
    const auto f = fingers->finger_of(entry.from);
    if (!f) {
      ++(decode_net_ft_request(entry.bytes) ? report.commands : report.foreign);
      return;
    }
    samples.clear();
    decoders[*f].push(entry.bytes, entry.wall_time, samples);
    report.sensors[*f].samples += samples.size();
    for (const auto& sample : samples) {
      const NetFtProduct product = decoders[*f].product();
      const NetFtVerdict verdict = judge(sample.record, product);
      DecodedSample decoded{*f, sample.wrench_S, sample.valid, flag_words(sample.record, product)};
      decoded.raw_counts = sample.record.raw;
      decoded.saturated = verdict.saturated;
      decoded.overload = verdict.overload;
      take(entry.time_text, entry.wall_time, decoded);
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

}  // namespace

Result<LogReport> read_log(const std::string& path, const DeviceConfig& config,
                           bool addresses_known, const TakeSample& take) {
  return config.protocol == Protocol::net_ft
             ? read_datagram_log(path, config, addresses_known, take)
             : read_can_log(path, config, take);
}

}  // namespace isograsp
