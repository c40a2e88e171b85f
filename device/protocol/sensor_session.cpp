// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/sensor_session.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isograsp {

namespace {

constexpr Timestamp kSilence = std::chrono::milliseconds(100);
constexpr Timestamp kNextRound = std::chrono::milliseconds(250);  // after three failed tries
constexpr int kTries = 3;
constexpr double kLongestGap = 1.5;  // periods between two samples of which none is lost
constexpr std::size_t kLongestSerial = 32;

}  // namespace

SensorSession::SensorSession(Options options)
    : options_(std::move(options)),
      period_(from_seconds(options_.period_s)),
      silence_(std::max(kSilence, 3 * period_)) {
  serial_number_.reserve(kLongestSerial);
}

void SensorSession::begin(Timestamp now) noexcept {
  tries_ = 0;
  failure_ = Failure::none;
  enter(0, now);
}

void SensorSession::enter(int step, Timestamp now) noexcept {
  if (step == 0) forget();
  phase_ = Phase::setup;
  step_ = step;
  sent_ = false;
  due_ = now;
}

void SensorSession::advance(Timestamp now) noexcept {
  enter(step_ + 1, now);
}

void SensorSession::go(Timestamp now) noexcept {
  phase_ = Phase::streaming;
  sent_ = false;
  due_ = now;
}

Timestamp SensorSession::due() const noexcept {
  return std::min(due_, phase_ == Phase::idle ? Timestamp::max() : pace_due());
}

std::optional<BusFrame> SensorSession::poll(Timestamp now) noexcept {
  while (phase_ != Phase::idle && now >= due_) {
    if (phase_ == Phase::streaming && !sent_) {
      sent_ = true;
      due_ = now + silence_;
      if (auto frame = start(now)) return frame;
    } else if (phase_ == Phase::setup && !sent_) {
      if (step_ == steps()) {
        phase_ = Phase::ready;
        due_ = Timestamp::max();
        break;
      }
      const auto next = question(step_);
      if (!next) {
        advance(now);
        continue;
      }
      sent_ = true;
      due_ = now + next->wait;
      if (next->frame) return next->frame;
    } else {
      time_out(now);
    }
  }
  if (phase_ != Phase::idle && now >= pace_due()) return pace(now);
  return std::nullopt;
}

std::optional<BusFrame> SensorSession::pace(Timestamp) noexcept {
  return std::nullopt;
}

void SensorSession::time_out(Timestamp now) noexcept {
  switch (phase_) {
    case Phase::setup:
      if (!question(step_)->answered) return advance(now);
      // An earlier command may have been lost, and a sensor that streams may ignore this one: begin
      // with the first step again.
      if (++tries_ < kTries) return enter(0, now);
      return fail(Failure::no_answer, now);
    case Phase::streaming:  // silent for too long: perhaps its power dipped and it is idle now
      ++counters_.restarts;
      return begin(now);
    default: return begin(now);
  }
}

void SensorSession::fail(Failure failure, Timestamp now) noexcept {
  failure_ = failure;
  phase_ = Phase::failed;
  due_ = now + kNextRound;
}

bool SensorSession::take(const BusFrame& frame, Timestamp stamp, Measurement& out) noexcept {
  const bool waits = phase_ == Phase::setup && sent_ && question(step_)->answered;
  const Heard heard = hear(waits ? std::optional(step_) : std::nullopt, frame, stamp, out);
  switch (heard) {
    case Heard::nothing: return false;
    case Heard::answer:
      if (waits) advance(stamp);
      return false;
    case Heard::restarted:
      if (phase_ == Phase::idle) return false;
      ++counters_.restarts;
      begin(stamp);
      return false;
    case Heard::refusal: fail(Failure::refused, stamp); return false;
    case Heard::wrong_serial: fail(Failure::wrong_serial, stamp); return false;
    case Heard::wrong_calibration: fail(Failure::wrong_calibration, stamp); return false;
    case Heard::measurement:
    case Heard::alive:
      if (!streaming() || !sent_) return false;
      due_ = stamp + silence_;
      out.stamp = stamp;
      return heard == Heard::measurement;
  }
  return false;
}

SensorSession::Heard SensorSession::hear_serial(std::string_view text) noexcept {
  const auto end =
      std::find_if(text.begin(), text.end(), [](char c) { return c <= ' ' || c > '~'; });
  const auto length = std::min(static_cast<std::size_t>(end - text.begin()), kLongestSerial);
  serial_number_.assign(text.data(), length);
  const bool wrong = !options_.serial_number.empty() && serial_number_ != options_.serial_number;
  return wrong ? Heard::wrong_serial : Heard::answer;
}

void SensorSession::count_gap(Timestamp stamp) noexcept {
  if (last_sample_) {
    const double periods = to_seconds(stamp - *last_sample_) / to_seconds(period_);
    if (periods > kLongestGap)
      counters_.lost += static_cast<std::uint64_t>(std::llround(periods)) - 1;
  }
  last_sample_ = stamp;
}

SessionCounters SensorSession::counters() const noexcept {
  const SessionCounters more = protocol_counters();
  SessionCounters sum = counters_;
  sum.torn += more.torn;
  sum.duplicate += more.duplicate;
  sum.late += more.late;
  sum.lost += more.lost;
  sum.foreign += more.foreign;
  return sum;
}

void SensorSession::reset_counters() noexcept {
  counters_ = {};
  last_sample_.reset();
  reset_protocol_counters();
}

Error SensorSession::error(std::string_view finger, const std::string& place) const {
  const Text sensor = finger == "thumb" ? "the thumb's sensor (%1)"_text(options_.address)
                      : finger == "index"
                          ? "the index finger's sensor (%1)"_text(options_.address)
                          : "the middle finger's sensor (%1)"_text(options_.address);
  Error error = failed({}, {}).at(place);
  switch (failure_) {
    case Failure::wrong_serial:
      error.what = "%1 has the serial number %2, but the configuration says %3"_text(
          sensor, serial_number_, options_.serial_number);
      error.remedy = "connect the right sensor or correct serial_number"_text;
      break;
    case Failure::wrong_calibration:
      error.what =
          refusal().empty()
              ? "%1 does not have the calibration that the configuration names"_text(sensor)
              : "%1 does not have the calibration that the configuration names (%2)"_text(
                    sensor, refusal());
      error.remedy =
          "do not measure with it: have the sensor checked or correct the configuration"_text;
      break;
    case Failure::refused:
      error.what = "%1 refused a setting (%2)"_text(sensor, refusal());
      error.remedy = "check rate and filter_Hz against the sensor's model"_text;
      break;
    default: error.what = "%1 does not answer"_text(sensor); error.remedy = no_answer_remedy();
  }
  return error;
}

}  // namespace isograsp
