// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/jr3_comedi_session.hpp"

#include <array>
#include <charconv>

#include "device/config/jr3_comedi_sensor.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kCardAnswerTime = std::chrono::milliseconds(100);

unsigned subdevice_of(const DeviceConfig& config, std::size_t finger) {
  return config.sensors[finger].as<Jr3ComediSensor>().subdevice;
}

}  // namespace

Jr3ComediSession::Jr3ComediSession(const DeviceConfig& config, std::size_t finger)
    : SensorSession({config.sensors[finger].serial_number,
                     "subdevice " + std::to_string(subdevice_of(config, finger)),
                     1.0 / config.rate_Hz}),
      sensor_(static_cast<std::uint32_t>(finger)),
      subdevice_(static_cast<std::uint8_t>(subdevice_of(config, finger))),
      filter_(*jr3_comedi_filter(config.filter_Hz)),
      filter_Hz_(config.filter_Hz) {}

bool Jr3ComediSession::owns(const BusFrame& frame) const noexcept {
  return frame.id == sensor_;
}

Vec6 Jr3ComediSession::units_per_count() const noexcept {
  constexpr double kFullScale = 16384.0;
  return full_scale_ / kFullScale;
}

double Jr3ComediSession::sensor_delay_s() const noexcept {
  return filter_Hz_ > 0.0 ? 1.0 / filter_Hz_ : 0.0;
}

BusFrame Jr3ComediSession::ask(Jr3ComediQuestion::Kind kind) const noexcept {
  return jr3_comedi_frame(sensor_, Jr3ComediQuestion{kind, subdevice_, filter_});
}

std::optional<SensorSession::Question> Jr3ComediSession::question(int) const noexcept {
  return Question{ask(Jr3ComediQuestion::Kind::identity), kCardAnswerTime};
}

SensorSession::Heard Jr3ComediSession::hear(std::optional<int> step, const BusFrame& frame,
                                            Timestamp, Measurement& out) noexcept {
  if (const auto identity = jr3_comedi_identity(frame))
    return step == 0 ? hear_identity(*identity) : Heard::nothing;
  const auto samples = jr3_comedi_samples(frame);
  if (!samples) {
    ++counters_.foreign;
    return Heard::nothing;
  }
  if (!awaits_) {
    ++counters_.late;
    return Heard::nothing;
  }
  awaits_ = false;
  out.raw_counts = jr3_comedi_counts(*samples);
  out.wrench_S = wrench_of(*samples, full_scale_);
  out.saturated = jr3_comedi_saturated(*samples);
  out.valid = !out.saturated;
  out.overload = false;
  out.status_error = false;
  out.numbered = false;
  out.status = 0;
  return Heard::measurement;
}

SensorSession::Heard Jr3ComediSession::hear_identity(const Jr3ComediIdentity& identity) noexcept {
  full_scale_ = identity.full_scale;
  if (!full_scale_.allFinite() || full_scale_.minCoeff() <= 0.0) return Heard::wrong_calibration;
  std::array<char, 16> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), identity.serial_number).ptr;
  return hear_serial({text.data(), static_cast<std::size_t>(end - text.data())});
}

std::optional<BusFrame> Jr3ComediSession::start(Timestamp now) noexcept {
  if (awaits_) ++counters_.lost;
  awaits_ = false;
  if (!next_poll_) next_poll_ = now;
  return std::nullopt;
}

Timestamp Jr3ComediSession::pace_due() const noexcept {
  return streaming() ? next_poll_.value_or(Timestamp::max()) : Timestamp::max();
}

std::optional<BusFrame> Jr3ComediSession::pace(Timestamp now) noexcept {
  const auto passed = (now - *next_poll_) / period() + 1;
  *next_poll_ += passed * period();
  counters_.lost += static_cast<std::uint64_t>(passed - 1) + (awaits_ ? 1 : 0);
  awaits_ = true;
  return ask(Jr3ComediQuestion::Kind::samples);
}

Text Jr3ComediSession::refusal() const {
  if (full_scale_.minCoeff() > 0.0) return {};
  return "one of its full scales is not positive"_text;
}

Text Jr3ComediSession::no_answer_remedy() const {
  return "check its cable; after it was plugged in the card needs ten seconds"_text;
}

}  // namespace isograsp
