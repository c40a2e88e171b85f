// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_log.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "device/bus/datagram_log.hpp"
#include "device/protocol/net_ft_decoder.hpp"

namespace isograsp {

namespace {

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

}  // namespace

Result<LogReport> read_net_ft_log(const std::string& path, const DeviceConfig& config,
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

}  // namespace isograsp
