// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_session.hpp"

#include <numbers>
#include <string>
#include <utility>

#include "device/config/net_ft_sensor.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kNetFtStopTime =
    std::chrono::milliseconds(20);  // what was under way is discarded
constexpr Timestamp kNetFtAnswerTime = std::chrono::milliseconds(100);
enum NetFtStep : int { kStop, kProbe, kSteps };

}  // namespace

NetFtSession::NetFtSession(const DeviceConfig& config, std::size_t finger, NetFtBoxConfig box)
    : SensorSession({config.sensors[finger].serial_number,
                     config.sensors[finger].as<NetFtSensor>().host, 1.0 / config.rate_Hz}),
      finger_(static_cast<std::uint32_t>(finger)),
      box_(std::move(box)),
      sequence_(config.rate_Hz) {
  // The serial number was checked when the box was asked: its records do not contain it.
  (void)hear_serial(box_.serial_number);
}

std::optional<BusFrame> NetFtSession::stop_frame() const noexcept {
  return encode_net_ft_request(finger_, {NetFtCommand::stop, 0});
}

Vec6 NetFtSession::units_per_count() const noexcept {
  return isograsp::units_per_count(box_.scale);
}

double NetFtSession::sensor_delay_s() const noexcept {
  const double cutoff_Hz = box_.filter_Hz.value_or(0.0);
  return cutoff_Hz > 0.0 ? 1.0 / (2.0 * std::numbers::pi * cutoff_Hz) : 0.0;
}

int NetFtSession::steps() const noexcept {
  return kSteps;
}

std::optional<SensorSession::Question> NetFtSession::question(int step) const noexcept {
  if (step == kStop) return Question{stop_frame(), kNetFtStopTime, false};
  return Question{encode_net_ft_request(finger_, {NetFtCommand::start, 1}), kNetFtAnswerTime};
}

std::optional<BusFrame> NetFtSession::start(Timestamp now) noexcept {
  sequence_.start(now);
  return encode_net_ft_request(finger_, {NetFtCommand::start, 0});
}

SensorSession::Heard NetFtSession::hear(std::optional<int> step, const BusFrame& frame,
                                        Timestamp stamp, Measurement& out) noexcept {
  const auto record = frame.is_standard() && frame.length == kNetFtRecord
                          ? decode_net_ft_record(frame.bytes())
                          : std::nullopt;
  if (!record) {
    ++counters_.foreign;
    return Heard::nothing;
  }
  // Records of a stream that still runs have other numbers.
  if (step == kProbe) return record->rdt_sequence == 1 ? Heard::answer : Heard::nothing;
  if (!streaming()) return Heard::nothing;

  const auto place = sequence_.push(*record, stamp);
  using Place = NetFtSequence::Place;
  if (place == Place::restarted) return Heard::restarted;
  if (place != Place::in_order && place != Place::stalled) return Heard::nothing;
  const NetFtVerdict verdict = judge(*record, box_.product);
  out = {};
  out.raw_counts = record->raw;
  out.wrench_S = wrench_of(record->raw, box_.scale);
  // A value that was measured long ago says nothing about now.
  out.valid = verdict.valid() && place == Place::in_order;
  out.numbered = place == Place::in_order;
  out.overload = verdict.overload;
  out.saturated = verdict.saturated;
  out.status_error = verdict.critical;
  out.status = record->status;
  return Heard::measurement;
}

void NetFtSession::reset_protocol_counters() noexcept {
  sequence_.reset_counters();
}

SessionCounters NetFtSession::protocol_counters() const noexcept {
  SessionCounters counted;
  counted.lost = sequence_.lost();
  counted.duplicate = sequence_.duplicate();
  counted.late = sequence_.late();
  counted.foreign = sequence_.impossible();
  return counted;
}

}  // namespace isograsp
