// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/rft_session.hpp"

#include <cstdio>
#include <numbers>

namespace isograsp {

namespace {

constexpr Timestamp kRftAnswerTime = std::chrono::milliseconds(100);
constexpr Timestamp kRftStopTime =
    std::chrono::milliseconds(20);                                // what was under way is discarded
constexpr Timestamp kCommandTime = std::chrono::milliseconds(1);  // after one without an answer

// Steps of the set-up in their order: numbers, with names of their own.
struct RftStep {
  enum : int { stop, serial_number, read_filter, set_filter, read_rate, set_rate, clear_bias, all };
};

std::string name_of(const RftOnBus& on_bus, const std::string& address) {
  const auto* ids = std::get_if<RftIds>(&on_bus);
  if (ids == nullptr) return "at " + address;
  char text[24];
  std::snprintf(text, sizeof text, "identifier 0x%02X", static_cast<unsigned>(ids->command));
  return text;
}

std::variant<RftPairing, RftStream> frames_of(const RftOnBus& on_bus) {
  if (const auto* ids = std::get_if<RftIds>(&on_bus)) return RftPairing(*ids);
  return RftStream();
}

}  // namespace

RftSession::RftSession(const Settings& settings)
    : SensorSession({settings.serial_number, name_of(settings.on_bus, settings.address),
                     1.0 / settings.rate_Hz}),
      on_bus_(settings.on_bus),
      divisors_(settings.divisors),
      filter_Hz_(settings.filter_Hz),
      rate_code_(*rft_rate_code(settings.rate_Hz)),
      filter_code_(*rft_filter_code(settings.filter_Hz, settings.filter_table)),
      frames_(frames_of(settings.on_bus)) {}

bool RftSession::owns(const BusFrame& frame) const noexcept {
  if (const auto* ids = std::get_if<RftIds>(&on_bus_))
    return frame.id == ids->first || frame.id == ids->second;
  return frame.id == std::get<RftPeer>(on_bus_).number;
}

Vec6 RftSession::units_per_count() const noexcept {
  Vec6 units;
  units.head<3>().setConstant(1.0 / divisors_.force_per_N);
  units.tail<3>().setConstant(1.0 / divisors_.torque_per_Nm);
  return units;
}

/// Of a first-order low-pass for slow signals; the pair of frames adds 0.26 ms.
double RftSession::sensor_delay_s() const noexcept {
  return filter_Hz_ > 0.0 ? 1.0 / (2.0 * std::numbers::pi * filter_Hz_) : 0.0;
}

BusFrame RftSession::command(RftCommand command,
                             std::initializer_list<std::uint8_t> parameters) const noexcept {
  if (const auto* ids = std::get_if<RftIds>(&on_bus_))
    return encode_command(*ids, command, parameters);
  return encode_stream_command(std::get<RftPeer>(on_bus_).number, command, parameters);
}

std::optional<BusFrame> RftSession::stop_frame() const noexcept {
  return command(RftCommand::stop);
}

int RftSession::steps() const noexcept {
  return RftStep::all;
}

std::optional<SensorSession::Question> RftSession::question(int step) const noexcept {
  const std::uint8_t filter_type = filter_code_ == 0 ? 0 : 1;
  switch (step) {
    case RftStep::stop: return Question{command(RftCommand::stop), kRftStopTime, false};
    case RftStep::serial_number:
      return Question{command(RftCommand::serial_number), kRftAnswerTime};
    case RftStep::read_filter: return Question{command(RftCommand::read_filter), kRftAnswerTime};
    case RftStep::set_filter:
      if (filter_is_right_) return std::nullopt;
      return Question{command(RftCommand::set_filter, {filter_type, filter_code_}), kRftAnswerTime};
    case RftStep::read_rate: return Question{command(RftCommand::read_rate), kRftAnswerTime};
    case RftStep::set_rate:
      if (rate_is_right_) return std::nullopt;
      return Question{command(RftCommand::set_rate, {rate_code_}), kRftAnswerTime};
    // A sensor forgets its bias when its power dips, so this program keeps the zero itself.
    default: return Question{command(RftCommand::set_bias, {0}), kCommandTime, false};
  }
}

std::optional<BusFrame> RftSession::start(Timestamp) noexcept {
  return command(RftCommand::start);
}

SensorSession::Heard RftSession::hear(std::optional<int> step, const BusFrame& frame,
                                      Timestamp stamp, Measurement& out) noexcept {
  const auto packet = std::holds_alternative<RftPairing>(frames_)
                          ? std::get<RftPairing>(frames_).push(frame, stamp)
                          : std::get<RftStream>(frames_).push(frame.bytes(), stamp);
  return packet ? hear_packet(step, *packet, stamp, out) : Heard::nothing;
}

SensorSession::Heard RftSession::hear_packet(std::optional<int> step, const RftPacket& packet,
                                             Timestamp stamp, Measurement& out) noexcept {
  if (packet.is_data()) {
    if (packet.command != static_cast<std::uint8_t>(RftCommand::start) || !streaming())
      return Heard::nothing;
    count_gap(stamp);
    const RftCounts counts = decode_counts(packet);
    out.raw_counts = counts.raw;
    out.wrench_S = wrench_of(counts, divisors_);
    out.overload = counts.overload != 0;
    out.saturated = at_end_of_numbers(counts);
    out.valid = !out.saturated;
    out.status = counts.overload;
    return Heard::measurement;
  }
  const auto& r = packet.content;
  const auto answers = [&](RftCommand asked) {
    return packet.command == static_cast<std::uint8_t>(asked);
  };
  if (!step) return Heard::nothing;
  switch (*step) {
    case RftStep::serial_number: {
      if (!answers(RftCommand::serial_number)) return Heard::nothing;
      std::array<char, 15> text{};
      for (std::size_t i = 0; i < text.size(); ++i) text[i] = static_cast<char>(r[i]);
      return hear_serial({text.data(), text.size()});
    }
    case RftStep::read_filter:
      if (!answers(RftCommand::read_filter)) return Heard::nothing;
      filter_is_right_ =
          filter_code_ == 0 ? r[0] == 0 || r[1] == 0 : r[0] == 1 && r[1] == filter_code_;
      return Heard::answer;
    case RftStep::read_rate:
      if (!answers(RftCommand::read_rate)) return Heard::nothing;
      rate_is_right_ = rft_rate_Hz(r[0]) == rft_rate_Hz(rate_code_);
      return Heard::answer;
    case RftStep::set_filter:
    case RftStep::set_rate:
      if (!answers(*step == RftStep::set_filter ? RftCommand::set_filter : RftCommand::set_rate))
        return Heard::nothing;
      if (r[0] == 1) return Heard::answer;
      refusal_ = r[1];
      return Heard::refusal;
    default: return Heard::nothing;
  }
}

Text RftSession::refusal() const {
  return "its error code is %1"_text(refusal_);
}

Text RftSession::no_answer_remedy() const {
  if (std::holds_alternative<RftIds>(on_bus_)) return SensorSession::no_answer_remedy();
  return "check its power, its cable, its address and the baud rate"_text;
}

void RftSession::forget() noexcept {
  filter_is_right_ = false;
  rate_is_right_ = false;
}

void RftSession::reset_protocol_counters() noexcept {
  frames_ = frames_of(on_bus_);
}

SessionCounters RftSession::protocol_counters() const noexcept {
  SessionCounters counters;
  if (const auto* pairs = std::get_if<RftPairing>(&frames_)) {
    counters.torn = pairs->torn();
    counters.duplicate = pairs->duplicate();
    counters.foreign = pairs->foreign();
  } else {
    counters.torn = std::get<RftStream>(frames_).torn();
    counters.foreign = std::get<RftStream>(frames_).foreign();
  }
  return counters;
}

}  // namespace isograsp
