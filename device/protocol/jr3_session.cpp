// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/jr3_session.hpp"

#include <numbers>

#include "device/config/jr3_sensor.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kJr3AnswerTime = std::chrono::milliseconds(100);
constexpr Timestamp kJr3StopTime =
    std::chrono::milliseconds(20);  // what was under way is discarded
constexpr Timestamp kSettleTime = std::chrono::milliseconds(100);
constexpr int kPatience = 3;  // answers "not initialised" until that is a failure

// Steps of the set-up in their order: numbers, with names of their own.
struct Jr3Step {
  enum : int { stop, state, force_scales, moment_scales, start_sync, settle, all };
};

std::uint8_t node_of(const DeviceConfig& config, std::size_t finger) {
  return config.sensors[finger].as<Jr3Sensor>().node;
}

}  // namespace

Jr3Session::Jr3Session(const DeviceConfig& config, std::size_t finger)
    : SensorSession({"", "node " + std::to_string(node_of(config, finger)), 1.0 / config.rate_Hz}),
      node_(node_of(config, finger)),
      conductor_(finger == 0),
      filter_Hz_(config.filter_Hz),
      cutoff_cHz_(*jr3_cutoff(config.filter_Hz)) {}

bool Jr3Session::owns(const BusFrame& frame) const noexcept {
  return jr3_owns(node_, frame);
}

std::optional<BusFrame> Jr3Session::stop_frame() const noexcept {
  return jr3_request(node_, Jr3Opcode::stop);
}

Vec6 Jr3Session::units_per_count() const noexcept {
  return calibration_.units_per_count();
}

/// Of a first-order low-pass for slow signals.
double Jr3Session::sensor_delay_s() const noexcept {
  return filter_Hz_ > 0.0 ? 1.0 / (2.0 * std::numbers::pi * filter_Hz_) : 0.0;
}

int Jr3Session::steps() const noexcept {
  return Jr3Step::all;
}

std::optional<SensorSession::Question> Jr3Session::question(int step) const noexcept {
  const auto ask = [&](Jr3Opcode opcode) {
    return Question{jr3_request(node_, opcode), kJr3AnswerTime};
  };
  switch (step) {
    // All acknowledgements look alike. The answer to a stop is not expected: it is discarded in the
    // waiting time, so that none is left over for the next step.
    case Jr3Step::stop: return Question{stop_frame(), kJr3StopTime, false};
    case Jr3Step::state: return ask(Jr3Opcode::state);
    case Jr3Step::force_scales: return ask(Jr3Opcode::force_scales);
    case Jr3Step::moment_scales: return ask(Jr3Opcode::moment_scales);
    case Jr3Step::start_sync: return Question{jr3_start_sync(node_, cutoff_cHz_), kJr3AnswerTime};
    default: return Question{std::nullopt, kSettleTime, false};
  }
}

void Jr3Session::forget() noexcept {
  pairing_.forget();
  newest_.reset();
}

SensorSession::Heard Jr3Session::hear(std::optional<int> step, const BusFrame& frame,
                                      Timestamp stamp, Measurement& out) noexcept {
  if (jr3_word(frame) != Jr3Word::answer) {
    ++counters_.foreign;
    return Heard::nothing;
  }
  switch (jr3_opcode(frame)) {
    case Jr3Opcode::boot_up: return Heard::restarted;
    case Jr3Opcode::acknowledge: return hear_acknowledge(step, jr3_acknowledge_of(frame));
    default: return hear_values(frame, stamp, out);
  }
}

SensorSession::Heard Jr3Session::hear_acknowledge(std::optional<int> step,
                                                  const Jr3Acknowledge& content) noexcept {
  const bool asked_scales = step == Jr3Step::force_scales || step == Jr3Step::moment_scales;
  const bool asked = asked_scales || step == Jr3Step::state || step == Jr3Step::start_sync;
  if (!asked || content.scales.has_value() != asked_scales) return Heard::nothing;
  if (!content.ready) {
    if (++not_ready_ < kPatience) return Heard::nothing;  // asked again after the waiting time
    not_ready_ = 0;
    objection_ = Objection::not_ready;
    return Heard::refusal;
  }
  not_ready_ = 0;
  if (step == Jr3Step::force_scales) calibration_.force_N = *content.scales;
  if (step == Jr3Step::moment_scales) {
    calibration_.moment_dNm = *content.scales;
    if (!calibration_.usable()) {
      objection_ = Objection::scales;
      return Heard::wrong_calibration;
    }
  }
  return Heard::answer;
}

SensorSession::Heard Jr3Session::hear_values(const BusFrame& frame, Timestamp stamp,
                                             Measurement& out) noexcept {
  const auto paired = pairing_.push(frame, stamp);
  if (!paired || !streaming()) return Heard::nothing;
  const Jr3Reading& reading = paired->reading;
  const int ahead = newest_ ? static_cast<std::int16_t>(reading.number - *newest_) : 1;
  if (ahead < 0) {
    ++counters_.late;
    return Heard::nothing;
  }
  newest_ = reading.number;
  count_gap(stamp);
  out.raw_counts = reading.raw;
  out.wrench_S = wrench_of(reading, calibration_);
  out.saturated = reading.saturated();
  out.valid = !out.saturated;
  out.overload = false;
  out.status_error = false;
  out.numbered = ahead > 0;
  out.status = 0;
  return Heard::measurement;
}

std::optional<BusFrame> Jr3Session::start(Timestamp now) noexcept {
  if (conductor_ && !next_sync_) next_sync_ = now;
  return std::nullopt;
}

Timestamp Jr3Session::pace_due() const noexcept {
  return next_sync_.value_or(Timestamp::max());
}

std::optional<BusFrame> Jr3Session::pace(Timestamp now) noexcept {
  *next_sync_ += ((now - *next_sync_) / period() + 1) * period();
  return jr3_sync();
}

void Jr3Session::reset_protocol_counters() noexcept {
  pairing_ = {};
}

SessionCounters Jr3Session::protocol_counters() const noexcept {
  SessionCounters counters;
  counters.torn = pairing_.torn();
  counters.duplicate = pairing_.duplicate();
  return counters;
}

Text Jr3Session::refusal() const {
  switch (objection_) {
    case Objection::none: return {};
    case Objection::not_ready: return "it says that its sensor is not initialised"_text;
    case Objection::scales: return "one of its full scales is zero"_text;
  }
  return {};
}

}  // namespace isograsp
