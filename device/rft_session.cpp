// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/rft_session.hpp"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace isograsp {

namespace {

constexpr Timestamp kAnswerTime = std::chrono::milliseconds(100);
constexpr Timestamp kStopTime = std::chrono::milliseconds(20);    // what was under way is discarded
constexpr Timestamp kCommandTime = std::chrono::milliseconds(1);  // after one without an answer
constexpr Timestamp kSilence = std::chrono::milliseconds(100);
constexpr Timestamp kNextRound =
    std::chrono::milliseconds(500);  // after three tries without answer
constexpr int kTries = 3;

}  // namespace

RftSession::RftSession(RftSessionOptions options)
    : options_(std::move(options)),
      pairing_(options_.ids),
      period_(from_seconds(1.0 / rft_rate_Hz(options_.rate_code))),
      silence_(std::max(kSilence, 3 * period_)) {}

void RftSession::begin(Timestamp now) noexcept {
  tries_ = 0;
  failure_ = Failure::none;
  enter(Step::stop, now);
}

void RftSession::enter(Step step, Timestamp now) noexcept {
  step_ = step;
  sent_ = false;
  due_ = now;
}

void RftSession::fail(Failure failure) noexcept {
  failure_ = failure;
  step_ = Step::failed;
  due_ += kNextRound;
}

CanFrame RftSession::command() const noexcept {
  const RftIds& ids = options_.ids;
  const std::uint8_t filter_type = options_.filter_code == 0 ? 0 : 1;
  switch (step_) {
    case Step::serial_number: return encode_command(ids, RftCommand::serial_number);
    case Step::read_filter: return encode_command(ids, RftCommand::read_filter);
    case Step::set_filter:
      return encode_command(ids, RftCommand::set_filter, {filter_type, options_.filter_code});
    case Step::read_rate: return encode_command(ids, RftCommand::read_rate);
    case Step::set_rate: return encode_command(ids, RftCommand::set_rate, {options_.rate_code});
    // A sensor forgets its bias when its power dips; the zero is therefore kept on this side.
    case Step::clear_bias: return encode_command(ids, RftCommand::set_bias, {0});
    case Step::start: return encode_command(ids, RftCommand::start);
    default: return encode_command(ids, RftCommand::stop);
  }
}

Timestamp RftSession::waiting_time() const noexcept {
  switch (step_) {
    case Step::stop: return kStopTime;
    case Step::clear_bias: return kCommandTime;
    default: return kAnswerTime;
  }
}

std::optional<CanFrame> RftSession::poll(Timestamp now) noexcept {
  while (step_ != Step::idle && now >= due_) {
    if (step_ < Step::streaming && !sent_) {
      const CanFrame out = command();
      sent_ = true;
      due_ = now + waiting_time();
      if (step_ == Step::start) {  // the first data may come at once
        step_ = Step::streaming;
        due_ = now + silence_;
      }
      return out;
    }
    time_out(now);
  }
  return std::nullopt;
}

void RftSession::time_out(Timestamp now) noexcept {
  switch (step_) {
    case Step::stop: return enter(Step::serial_number, now);
    case Step::clear_bias:
      step_ = Step::ready;
      due_ = Timestamp::max();
      return;
    case Step::streaming:  // silent for too long: perhaps its power dipped and it is idle now
    case Step::failed: return begin(now);
    default:
      // The stop may have been lost, and a sensor that streams hears nothing else: start over.
      if (++tries_ < kTries) return enter(Step::stop, now);
      return fail(Failure::no_answer);
  }
}

std::optional<RftCounts> RftSession::take(const CanFrame& frame, Timestamp stamp) noexcept {
  const auto packet = pairing_.push(frame, stamp);
  if (!packet) return std::nullopt;
  if (!packet->is_data()) {
    if (sent_) answer(*packet, stamp);
    return std::nullopt;
  }
  if (packet->command != static_cast<std::uint8_t>(RftCommand::start)) return std::nullopt;
  if (!streaming()) return std::nullopt;
  count_gap(stamp);
  due_ = stamp + silence_;
  return decode_counts(*packet);
}

void RftSession::reset_counters() noexcept {
  pairing_ = RftPairing(options_.ids);
  last_sample_.reset();
  lost_ = 0;
}

void RftSession::count_gap(Timestamp stamp) noexcept {
  if (last_sample_) {
    const double periods = to_seconds(stamp - *last_sample_) / to_seconds(period_);
    if (periods > 1.5) lost_ += static_cast<std::uint64_t>(std::llround(periods)) - 1;
  }
  last_sample_ = stamp;
}

void RftSession::answer(const RftPacket& packet, Timestamp now) noexcept {
  if (packet.command != command().data[0]) return;
  const auto& r = packet.content;
  switch (step_) {
    case Step::serial_number:
      for (std::size_t i = 0; i < serial_.size(); ++i) serial_[i] = static_cast<char>(r[i]);
      if (!options_.serial_number.empty() && serial_number() != options_.serial_number)
        return fail(Failure::wrong_serial);
      return enter(Step::read_filter, now);
    case Step::read_filter: {
      const bool same = options_.filter_code == 0 ? r[0] == 0 || r[1] == 0
                                                  : r[0] == 1 && r[1] == options_.filter_code;
      return enter(same ? Step::read_rate : Step::set_filter, now);
    }
    case Step::read_rate:
      return enter(
          rft_rate_Hz(r[0]) == rft_rate_Hz(options_.rate_code) ? Step::clear_bias : Step::set_rate,
          now);
    case Step::set_filter:
    case Step::set_rate:
      if (r[0] != 1) {
        refusal_ = r[1];
        return fail(Failure::refused);
      }
      return enter(step_ == Step::set_filter ? Step::read_rate : Step::clear_bias, now);
    default: return;
  }
}

std::string_view RftSession::serial_number() const noexcept {
  const auto end =
      std::find_if(serial_.begin(), serial_.end(), [](char c) { return c <= ' ' || c > '~'; });
  return {serial_.data(), static_cast<std::size_t>(end - serial_.begin())};
}

Error RftSession::error(std::string_view finger, const std::string& place) const {
  char id[16];
  std::snprintf(id, sizeof id, "0x%02X", static_cast<unsigned>(options_.ids.command));
  const std::string sensor = "the " + std::string(finger) + "'s sensor (identifier " + id + ")";
  Error error{Error::Code::failed, "", "", place, 0, ""};
  switch (failure_) {
    case Failure::wrong_serial:
      error.what = sensor + " has the serial number " + std::string(serial_number()) +
                   ", but the configuration says " + options_.serial_number;
      error.remedy = "connect the right sensor or correct serial_number";
      break;
    case Failure::refused:
      error.what =
          sensor + " refused a setting (its error code is " + std::to_string(refusal_) + ")";
      error.remedy = "check rate and filter_Hz against the sensor's model";
      break;
    default:
      error.what = sensor + " does not answer";
      error.remedy = "check its power, its cable and the 120 ohm at both ends of the bus";
  }
  return error;
}

}  // namespace isograsp
