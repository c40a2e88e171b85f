// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/ati_session.hpp"

#include <cstdio>

#include "device/config/ati_sensor.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kAtiAnswerTime = std::chrono::milliseconds(100);  // while it is set up
constexpr Timestamp kSampleTime = std::chrono::milliseconds(5);

// Steps of the set-up in their order: numbers, with names of their own.
struct AtiStep {
  enum : int {
    calibration,
    serial_number,
    firmware,
    first_row,
    last_row = first_row + 5,
    counts,
    units,
    first_reading,
    all
  };
};

std::string name_of(std::uint8_t base) {
  char text[24];
  std::snprintf(text, sizeof text, "base 0x%02X", static_cast<unsigned>(base));
  return text;
}

const AtiSensor& sensor_of(const DeviceConfig& config, std::size_t finger) {
  return config.sensors[finger].as<AtiSensor>();
}

}  // namespace

AtiSession::AtiSession(const DeviceConfig& config, std::size_t finger)
    : SensorSession({config.sensors[finger].serial_number, name_of(sensor_of(config, finger).base),
                     1.0 / config.rate_Hz}),
      base_(sensor_of(config, finger).base),
      slot_(sensor_of(config, finger).calibration) {}

bool AtiSession::owns(const BusFrame& frame) const noexcept {
  return ati_owns(base_, frame);
}

BusFrame AtiSession::select() const noexcept {
  return ati_request(base_, AtiOpcode::calibration, {slot_});
}

int AtiSession::steps() const noexcept {
  return AtiStep::all;
}

std::optional<SensorSession::Question> AtiSession::question(int step) const noexcept {
  const auto ask = [&](AtiOpcode opcode) {
    return Question{ati_request(base_, opcode), kAtiAnswerTime};
  };
  switch (step) {
    case AtiStep::calibration: return Question{select(), kAtiAnswerTime};
    case AtiStep::serial_number: return ask(AtiOpcode::serial_number);
    case AtiStep::firmware: return ask(AtiOpcode::firmware);
    case AtiStep::counts:
      if (!firmware_.tells_counts()) return std::nullopt;
      return ask(AtiOpcode::counts);
    case AtiStep::units:
      if (!firmware_.tells_counts()) return std::nullopt;
      return ask(AtiOpcode::units);
    case AtiStep::first_reading: return ask(AtiOpcode::gages);
    default: {
      const auto row = static_cast<std::uint8_t>(step - AtiStep::first_row);
      return Question{ati_request(base_, AtiOpcode::matrix_row, {row}), kAtiAnswerTime};
    }
  }
}

void AtiSession::forget() noexcept {
  pairing_.ask();
  assembly_.forget();
  calibration_ = {};
  firmware_ = {};
  awaits_ = Awaits::nothing;
}

SensorSession::Heard AtiSession::hear(std::optional<int> step, const BusFrame& frame,
                                      Timestamp stamp, Measurement& out) noexcept {
  switch (ati_word(frame)) {
    case AtiWord::either: return hear_slot(step, frame.data[0]);
    case AtiWord::answer: return hear_answer(step, frame, stamp, out);
    default:  // also a request: only this host asks
      ++counters_.foreign;
      return Heard::nothing;
  }
}

SensorSession::Heard AtiSession::hear_slot(std::optional<int> step, std::uint8_t slot) noexcept {
  if (step == AtiStep::calibration) {
    if (slot == slot_) return Heard::answer;
    objection_ = Objection::slot;
    other_slot_ = slot;
    return Heard::wrong_calibration;
  }
  if (slot != slot_) return Heard::restarted;  // another program selected another slot
  if (awaits_ == Awaits::echo) awaits_ = Awaits::nothing;
  return Heard::nothing;
}

SensorSession::Heard AtiSession::hear_answer(std::optional<int> step, const BusFrame& frame,
                                             Timestamp stamp, Measurement& out) noexcept {
  switch (ati_opcode(frame)) {
    case AtiOpcode::gages:
    case AtiOpcode::odd_gages: {
      const auto paired = pairing_.push(frame, stamp);
      if (!paired) return Heard::nothing;
      if (step == AtiStep::first_reading) return hear_first_reading(paired->reading);
      return hear_reading(paired->reading, stamp, out);
    }
    case AtiOpcode::matrix_row:
    case AtiOpcode::row_middle:
    case AtiOpcode::row_end: {
      if (!step || *step < AtiStep::first_row || *step > AtiStep::last_row) return Heard::nothing;
      const auto row = assembly_.push(frame);
      if (!row) return Heard::nothing;
      for (std::size_t i = 0; i < row->size(); ++i)
        calibration_.matrix(*step - AtiStep::first_row, static_cast<Eigen::Index>(i)) = (*row)[i];
      return Heard::answer;
    }
    case AtiOpcode::serial_number:
      return step == AtiStep::serial_number ? hear_serial(ati_serial_of(frame)) : Heard::nothing;
    case AtiOpcode::firmware:
      if (step != AtiStep::firmware) return Heard::nothing;
      firmware_ = ati_firmware_of(frame);
      return Heard::answer;
    case AtiOpcode::counts:
      if (step != AtiStep::counts) return Heard::nothing;
      calibration_.counts = ati_counts_of(frame);
      return Heard::answer;
    case AtiOpcode::units:
      if (step != AtiStep::units) return Heard::nothing;
      calibration_.units = ati_units_of(frame);
      return Heard::answer;
    default: return Heard::nothing;
  }
}

/// The last step of the set-up: is everything there, and does the board agree with its calibration?
SensorSession::Heard AtiSession::hear_first_reading(const AtiReading& reading) noexcept {
  objection_ = Objection::none;
  if (!calibration_.usable())
    objection_ = Objection::unusable;
  else if ((reading.status & kAtiBadCalibration) != 0)
    objection_ = Objection::status;
  watchdog_ = (reading.status & kAtiWatchdogReset) != 0;
  return objection_ == Objection::none ? Heard::answer : Heard::wrong_calibration;
}

SensorSession::Heard AtiSession::hear_reading(const AtiReading& reading, Timestamp stamp,
                                              Measurement& out) noexcept {
  if (awaits_ != Awaits::reading) {
    ++counters_.late;
    return Heard::nothing;
  }
  awaits_ = Awaits::nothing;
  if (stamp > deadline_) {
    ++counters_.late;
    ++counters_.lost;
    return Heard::nothing;
  }
  const bool new_watchdog = !watchdog_ && (reading.status & kAtiWatchdogReset) != 0;
  if (new_watchdog || (reading.status & kAtiBadCalibration) != 0) {
    ++counters_.lost;
    return Heard::restarted;
  }
  out.raw_counts = reading.gages;
  out.wrench_S = wrench_of(reading.gages, Vec6::Zero(), calibration_);
  out.valid = reading.valid();
  out.overload = false;
  out.saturated = reading.saturated();
  out.status_error = reading.critical();
  out.numbered = false;
  out.status = reading.status;
  return Heard::measurement;
}

std::optional<BusFrame> AtiSession::start(Timestamp now) noexcept {
  if (!next_poll_)
    next_poll_ = now;
  else  // set up again: samples that were not asked for meanwhile are lost
    counters_.lost += pass_slots(now);
  return std::nullopt;
}

std::uint64_t AtiSession::pass_slots(Timestamp now) noexcept {
  if (now < *next_poll_) return 0;
  const auto passed = (now - *next_poll_) / period() + 1;
  *next_poll_ += passed * period();
  return static_cast<std::uint64_t>(passed);
}

Timestamp AtiSession::pace_due() const noexcept {
  if (!streaming() || !next_poll_) return Timestamp::max();
  return awaits_ == Awaits::nothing ? *next_poll_ : std::min(deadline_, *next_poll_);
}

std::optional<BusFrame> AtiSession::pace(Timestamp now) noexcept {
  if (awaits_ != Awaits::nothing && now >= deadline_) {
    if (awaits_ == Awaits::reading) ++counters_.lost;
    pairing_.ask();
    awaits_ = Awaits::echo;
    deadline_ = now + kSampleTime;
    return select();
  }
  const std::uint64_t passed = pass_slots(now);
  if (passed == 0) return std::nullopt;
  if (awaits_ != Awaits::nothing) {
    counters_.lost += passed;
    return std::nullopt;
  }
  counters_.lost += passed - 1;
  pairing_.ask();
  awaits_ = Awaits::reading;
  deadline_ = now + kSampleTime;
  return ati_request(base_, AtiOpcode::gages);
}

void AtiSession::reset_protocol_counters() noexcept {
  pairing_ = {};
}

SessionCounters AtiSession::protocol_counters() const noexcept {
  SessionCounters counters;
  counters.torn = pairing_.torn();
  counters.duplicate = pairing_.duplicate();
  return counters;
}

Text AtiSession::refusal() const {
  switch (objection_) {
    case Objection::none: return {};
    case Objection::slot:
      return "calibration slot %1 was asked for, it chose slot %2"_text(slot_, other_slot_);
    case Objection::unusable:
      return "calibration slot %1 holds a matrix, counts or units that cannot be used"_text(slot_);
    case Objection::status: return "it says itself that calibration slot %1 is bad"_text(slot_);
  }
  return {};
}

Text AtiSession::no_answer_remedy() const {
  return "check its power, its cable, the 120 ohm at both ends of the bus, and the bit rate of the "
         "interface: boards leave the factory at 250 kbit/s"_text;
}

}  // namespace isograsp
