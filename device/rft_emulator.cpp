// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/rft_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "core/csv.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kAnswerDelay = std::chrono::microseconds(600);  // assumed; not specified
constexpr double kOverload = 1.2;  // of the rating, from which on the overload bit is set
constexpr double kSameInstant_s = 1e-9;
constexpr std::uint8_t kSuccess = 1;
constexpr std::uint8_t kUnsupported = 1;
constexpr std::uint8_t kOutOfRange = 2;

Error bad_fault(std::string_view text, std::string what) {
  return {Error::Code::bad_input,
          std::move(what),
          "use lose=FINGER:tx1:PROBABILITY, lose=FINGER:tx2:PROBABILITY, silence=FINGER@SECONDSs "
          "or dip=FINGER@SECONDSs",
          "",
          0,
          "--fault " + std::string(text)};
}

/// Cuts the text before `separator` off; the whole text if there is none.
std::string_view take_until(std::string_view& text, char separator) {
  const auto end = text.find(separator);
  const auto part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return part;
}

}  // namespace

const FingerWrenches& FingerPlay::at(double play_time_s) const noexcept {
  if (repeat) play_time_s = std::fmod(play_time_s, duration_s);
  // n / rate and the row's own time may differ by a rounding: they mean the same instant.
  const auto after = std::upper_bound(t_s.begin(), t_s.end(), play_time_s + kSameInstant_s);
  const auto row = after == t_s.begin() ? 0 : after - t_s.begin() - 1;
  return wrench_C[static_cast<std::size_t>(row)];
}

Result<RftFault> RftFault::parse(std::string_view text) {
  RftFault fault;
  std::string_view rest = text;
  const auto word = take_until(rest, '=');
  const bool loses = word == "lose";
  if (!loses && word != "silence" && word != "dip")
    return bad_fault(text, "there is no such fault");
  const auto name = take_until(rest, loses ? ':' : '@');
  const auto finger = finger_from_name(name);
  if (!finger) return bad_fault(text, "'" + std::string(name) + "' is not a finger");
  fault.finger = *finger;
  if (loses) {
    const auto frame = take_until(rest, ':');
    if (frame != "tx1" && frame != "tx2")
      return bad_fault(text, "'" + std::string(frame) + "' is not a frame of a sample");
    fault.kind = frame == "tx1" ? Kind::lose_first : Kind::lose_second;
    if (!parse_number(rest, fault.probability) || fault.probability < 0 || fault.probability > 1)
      return bad_fault(text, "'" + std::string(rest) + "' is not a probability");
    return fault;
  }
  fault.kind = word == "silence" ? Kind::silence : Kind::power_dip;
  if (rest.ends_with('s')) rest.remove_suffix(1);
  if (!parse_number(rest, fault.at_s) || fault.at_s < 0)
    return bad_fault(text, "'" + std::string(rest) + "' is not a time in seconds");
  return fault;
}

RftEmulator::RftEmulator(RftEmulatorOptions options, FingerPlay play)
    : options_(std::move(options)), play_(std::move(play)), random_(options_.seed) {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    Sensor& sensor = sensors_[f];
    sensor.ids = sensor.ids_after_reboot = options_.config.sensors[f].ids;
    sensor.clock_factor = 1.0 + options_.clock_error * (2.0 * uniform() - 1.0);
    sensor.phase = uniform();
  }
  struck_.resize(options_.faults.size());
  departures_.reserve(64);
}

double RftEmulator::uniform() noexcept {
  return static_cast<double>(random_() >> 11) * 0x1p-53;
}

double RftEmulator::period_s(const Sensor& sensor) const noexcept {
  return 1.0 / rft_rate_Hz(sensor.rate_code);
}

Timestamp RftEmulator::next_measurement(const Sensor& sensor) const noexcept {
  if (!sensor.streaming) return Timestamp::max();
  const double own_s = (static_cast<double>(sensor.measured) + sensor.phase) * period_s(sensor);
  return sensor.started + from_seconds(own_s * sensor.clock_factor);
}

Timestamp RftEmulator::next() const noexcept {
  Timestamp soonest = departures_.empty() ? Timestamp::max() : departures_.front().when;
  for (const auto& sensor : sensors_) soonest = std::min(soonest, next_measurement(sensor));
  return soonest;
}

void RftEmulator::receive(const CanFrame& frame, Timestamp now) {
  if (frame.extended || frame.remote || frame.error || frame.length != 8) return;
  make_measurements(now);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (frame.id == sensors_[f].ids.command && !sensors_[f].dead) obey(f, frame, now);
}

void RftEmulator::obey(std::size_t finger, const CanFrame& frame, Timestamp now) {
  Sensor& sensor = sensors_[finger];
  const auto& d = frame.data;
  const auto text = [&](std::string_view words) {
    std::array<std::uint8_t, 15> content{};
    std::copy(words.begin(), words.end(), content.begin());
    reply(finger, d[0], content, now);
  };
  const auto result = [&](bool good) {
    const std::array<std::uint8_t, 2> content{good ? kSuccess : std::uint8_t{0},
                                              good ? std::uint8_t{0} : kOutOfRange};
    reply(finger, d[0], content, now);
  };
  const auto command = static_cast<RftCommand>(d[0]);
  if (command == RftCommand::stop) {
    sensor.streaming = false;
    return;
  }
  if (command == RftCommand::set_bias) {
    sensor.bias = {};
    if (d[1] == 1) sensor.bias = measure(finger).raw;
    return;
  }
  if (sensor.streaming) return;  // deaf to everything else
  switch (command) {
    case RftCommand::model_name: return text("RFT60-HA01");
    case RftCommand::serial_number:
      return text(options_.config.sensors[finger].serial_number.empty()
                      ? "EMULATED-" + std::to_string(finger + 1)
                      : options_.config.sensors[finger].serial_number.substr(0, 15));
    case RftCommand::firmware_version: return text("1.82");
    case RftCommand::set_ids: {
      const bool good =
          d[1] != 0 && d[2] != 0 && d[3] != 0 && d[1] != d[2] && d[2] != d[3] && d[1] != d[3];
      if (good) sensor.ids_after_reboot = {d[1], d[2], d[3]};
      return result(good);
    }
    case RftCommand::read_ids: {
      const RftIds& a = sensor.ids;
      const RftIds& b = sensor.ids_after_reboot;
      const std::array content{a.command, a.first, a.second, b.command, b.first, b.second};
      return reply(finger, d[0], content, now);
    }
    case RftCommand::set_filter: {
      const bool good = d[1] == 0 || (d[1] == 1 && d[2] <= 14);
      if (good) {
        sensor.filter_type = d[1];
        sensor.filter_code = d[2];
        sensor.filter_settled = false;
      }
      return result(good);
    }
    case RftCommand::read_filter:
      return reply(finger, d[0], std::array{sensor.filter_type, sensor.filter_code}, now);
    case RftCommand::read_once: {
      const auto frames = encode_counts(sensor.ids, measure(finger), RftCommand::read_once);
      return depart(frames, now + kAnswerDelay, true, true);
    }
    case RftCommand::start:
      sensor.streaming = true;
      sensor.started = now;
      sensor.measured = 0;
      if (first_start_ == Timestamp::min()) first_start_ = now;
      return;
    case RftCommand::set_rate:
      if (d[1] <= 8) sensor.rate_code = d[1];
      return result(d[1] <= 8);
    case RftCommand::read_rate: return reply(finger, d[0], std::array{sensor.rate_code}, now);
    case RftCommand::overload_counts: return reply(finger, d[0], sensor.overload_counts, now);
    default: return reply(finger, d[0], std::array<std::uint8_t, 2>{0, kUnsupported}, now);
  }
}

void RftEmulator::reply(std::size_t finger, std::uint8_t command,
                        std::span<const std::uint8_t> content, Timestamp now) {
  depart(encode_packet(sensors_[finger].ids, command, content), now + kAnswerDelay, true, true);
}

void RftEmulator::depart(const std::array<CanFrame, 2>& frames, Timestamp when, bool first,
                         bool second) {
  const auto insert = [this](Timestamp at, const CanFrame& frame) {
    const auto place = std::upper_bound(
        departures_.begin(), departures_.end(), at,
        [](Timestamp t, const Departure& departure) { return t < departure.when; });
    departures_.insert(place, {at, frame});
  };
  if (first) insert(when, frames[0]);
  if (second) insert(when, frames[1]);  // the bus itself spaces them
}

RftCounts RftEmulator::measure(std::size_t finger) {
  Sensor& sensor = sensors_[finger];
  const RftSensorConfig& config = options_.config.sensors[finger];
  const double own_s = static_cast<double>(sensor.measured) * period_s(sensor);
  const Wrench wrench_S = config.mounting.to_sensor(play_.at(own_s)[finger]);
  const double cutoff_Hz = sensor.filter_type == 1 ? rft_filter_Hz(sensor.filter_code) : 0.0;
  const double pass = options_.filtered && cutoff_Hz > 0.0 && sensor.filter_settled
                          ? 1.0 - std::exp(-2.0 * std::numbers::pi * cutoff_Hz * period_s(sensor))
                          : 1.0;
  RftCounts counts;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const auto i = static_cast<int>(axis % 3);
    const double per_unit = axis < 3 ? config.divisors.force_per_N : config.divisors.torque_per_Nm;
    const double true_value = (axis < 3 ? wrench_S.force[i] : wrench_S.torque[i]) * per_unit;
    double& value = sensor.filter_state[axis];
    value += pass * (true_value - value);
    std::int64_t count = std::llround(pass == 1.0 ? true_value : value);
    if (options_.noise_counts > 0)
      count += static_cast<std::int64_t>(uniform() * (2 * options_.noise_counts + 1)) -
               options_.noise_counts;
    count -= sensor.bias[axis];
    counts.raw[axis] =
        static_cast<std::int32_t>(std::clamp<std::int64_t>(count, INT16_MIN, INT16_MAX));
    if (std::abs(static_cast<double>(count)) >
        kOverload * config.range[static_cast<int>(axis)] * per_unit) {
      counts.overload |= static_cast<std::uint8_t>(0x20 >> axis);
      if (sensor.overload_counts[axis] < 255) ++sensor.overload_counts[axis];
    }
  }
  sensor.filter_settled = true;
  return counts;
}

bool RftEmulator::strikes(RftFault::Kind kind, std::size_t finger) {
  bool hit = false;
  for (const auto& fault : options_.faults)
    if (fault.kind == kind && index_of(fault.finger) == finger)
      hit |= uniform() < fault.probability;
  return hit;
}

void RftEmulator::strike_faults(Timestamp now) {
  for (std::size_t i = 0; i < options_.faults.size(); ++i) {
    const RftFault& fault = options_.faults[i];
    const bool once =
        fault.kind == RftFault::Kind::silence || fault.kind == RftFault::Kind::power_dip;
    if (!once || struck_[i] || first_start_ == Timestamp::min()) continue;
    if (now < first_start_ + from_seconds(fault.at_s)) continue;
    struck_[i] = true;
    Sensor& sensor = sensors_[index_of(fault.finger)];
    reset(sensor);
    sensor.dead = fault.kind == RftFault::Kind::silence;
  }
}

/// Power off and on: settings survive, start and bias do not, new identifiers act.
void RftEmulator::reset(Sensor& sensor) {
  sensor.streaming = false;
  sensor.bias = {};
  sensor.ids = sensor.ids_after_reboot;
  sensor.filter_settled = false;
}

void RftEmulator::make_measurements(Timestamp now) {
  while (true) {
    std::size_t soonest = 0;
    for (std::size_t f = 1; f < kFingerCount; ++f)
      if (next_measurement(sensors_[f]) < next_measurement(sensors_[soonest])) soonest = f;
    const Timestamp when = next_measurement(sensors_[soonest]);
    strike_faults(std::min(when, now));
    if (when > now || when == Timestamp::max()) return;
    if (!sensors_[soonest].streaming) continue;  // a fault came first
    const auto counts = measure(soonest);
    const bool first = !strikes(RftFault::Kind::lose_first, soonest);
    const bool second = !strikes(RftFault::Kind::lose_second, soonest);
    depart(encode_counts(sensors_[soonest].ids, counts), when, first, second);
    RftEmulatorCounters& counter = counters_[soonest];
    ++counter.samples;
    counter.lost_first += first ? 0 : 1;
    counter.lost_second += second ? 0 : 1;
    counter.lost_samples += first && second ? 0 : 1;
    ++sensors_[soonest].measured;
  }
}

bool RftEmulator::take(Timestamp now, CanFrame& out) {
  make_measurements(now);
  if (departures_.empty() || departures_.front().when > now) return false;
  out = departures_.front().frame;
  departures_.erase(departures_.begin());
  return true;
}

}  // namespace isograsp
