// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/rft_device.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <linux/can/error.h>

namespace isograsp {

namespace {

constexpr Timestamp kRecent = std::chrono::seconds(1);  // how long a lost sample is told
constexpr double kSaturated = 0.98;                     // of the rating
constexpr int kMostFramesPastDeadline = 64;

RftSession make_session(const RftConfig& config, std::size_t finger, double rate_Hz) {
  const RftSensorConfig& sensor = config.sensors[finger];
  return RftSession({sensor.ids, sensor.serial_number, *rft_rate_code(rate_Hz),
                     *rft_filter_code(config.filter_Hz, config.filter_table)});
}

bool is_recent(Timestamp event, Timestamp now) noexcept {
  return event != Timestamp::min() && now - event < kRecent;
}

}  // namespace

RftDevice::RftDevice(std::unique_ptr<CanBus> bus, const RftConfig& config, double rate_Hz,
                     std::string uri, std::string place)
    : bus_(std::move(bus)),
      config_(config),
      place_(std::move(place)),
      sessions_{make_session(config, 0, rate_Hz), make_session(config, 1, rate_Hz),
                make_session(config, 2, rate_Hz)} {
  info_.uri = std::move(uri);
  info_.description = "Robotous RFT on " + place_;
  info_.sample_period_s = 1.0 / rate_Hz;
  // Delay of a first-order low-pass for slow signals; the pair of frames adds 0.26 ms.
  info_.delay_s = config.filter_Hz > 0.0 ? 1.0 / (2.0 * std::numbers::pi * config.filter_Hz) : 0.0;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const RftSensorConfig& sensor = config.sensors[f];
    const Mat3 turn = sensor.mounting.q_CS.toRotationMatrix().cwiseAbs();
    info_.serial_numbers[f] = sensor.serial_number;
    info_.units_per_count[f].head<3>().setConstant(1.0 / sensor.divisors.force_per_N);
    info_.units_per_count[f].tail<3>().setConstant(1.0 / sensor.divisors.torque_per_Nm);
    info_.range[f].head<3>() = turn * sensor.range.head<3>();
    info_.range[f].tail<3>() = turn * sensor.range.tail<3>();
  }
}

std::uint64_t RftDevice::trouble() const noexcept {
  std::uint64_t sum = bus_->drops();
  for (const auto& session : sessions_) sum += session.torn() + session.lost();
  return sum;
}

DeviceHealth RftDevice::health() const noexcept {
  DeviceHealth health;
  health.sensors = counters_;
  health.kernel_drops = bus_->drops();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    health.sensors[f].torn = sessions_[f].torn();
    health.sensors[f].lost = sessions_[f].lost();
    health.foreign_frames += sessions_[f].foreign();
  }
  if (!started_) {
    health.state = stopped_ ? DeviceState::configured : DeviceState::absent;
    return health;
  }
  const Timestamp now = clock_->now();
  const bool all_stream = std::all_of(sessions_.begin(), sessions_.end(),
                                      [](const RftSession& s) { return s.streaming(); });
  if (bus_fault_ != DeviceFault::none)
    health.fault = bus_fault_;
  else if (!all_stream)
    health.fault = DeviceFault::silence;
  if (health.fault != DeviceFault::none) {
    health.state = DeviceState::faulted;
    return health;
  }
  if (is_recent(last_overload_, now))
    health.fault = DeviceFault::overload;
  else if (is_recent(last_trouble_, now))
    health.fault = DeviceFault::torn_samples;
  health.state = health.fault == DeviceFault::none ? DeviceState::streaming : DeviceState::degraded;
  return health;
}

Timestamp RftDevice::due() const noexcept {
  Timestamp soonest = Timestamp::max();
  for (const auto& session : sessions_) soonest = std::min(soonest, session.due());
  return soonest;
}

void RftDevice::serve(Timestamp now) noexcept {
  const auto send_due = [&](RftSession& session) {
    while (const auto command = session.poll(now)) bus_->send(*command);
  };
  for (auto& session : sessions_) send_due(session);
  const bool all_ready = std::all_of(sessions_.begin(), sessions_.end(),
                                     [](const RftSession& s) { return s.ready(); });
  for (auto& session : sessions_) {
    if (!session.ready() || (!started_ && !all_ready)) continue;
    session.go(now);
    send_due(session);
  }
}

Result<void> RftDevice::start(Clock& clock) {
  if (auto started = bus_->start(clock); !started) return started.error();
  clock_ = &clock;
  bus_fault_ = DeviceFault::none;
  newest_ = clock.now();
  for (auto& session : sessions_) session.begin(clock.now());

  const auto streams = [](const RftSession& s) { return s.streaming(); };
  while (!std::all_of(sessions_.begin(), sessions_.end(), streams)) {
    ReceivedFrame in;
    SensorSample early;
    const BusEvent event = bus_->receive(due(), in);
    if (event == BusEvent::frame) {
      (void)take(in, early);
    } else if (event == BusEvent::timeout) {
      serve(clock.now());
    } else {
      stop();
      return Error{Error::Code::failed,
                   "the CAN interface failed while the sensors were started",
                   "check the adapter and its cable",
                   place_,
                   0,
                   ""};
    }
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if (sessions_[f].failure() == RftSession::Failure::none) continue;
      const Error error = sessions_[f].error(kFingerNames[f], place_);
      stop();
      return error;
    }
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    info_.serial_numbers[f] = sessions_[f].serial_number();
    sessions_[f].reset_counters();  // damaged answers are no damaged samples
  }
  counters_ = {};
  known_trouble_ = trouble();
  started_ = true;
  return {};
}

bool RftDevice::take(const ReceivedFrame& in, SensorSample& out) noexcept {
  if (in.frame.error) {
    if ((in.frame.id & CAN_ERR_RESTARTED) != 0) bus_fault_ = DeviceFault::none;
    return false;
  }
  bus_fault_ = DeviceFault::none;  // frames arrive, so the bus works
  newest_ = std::max(newest_, in.stamp);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const RftIds& ids = sessions_[f].ids();
    if (in.frame.id != ids.first && in.frame.id != ids.second) continue;
    const auto counts = sessions_[f].take(in.frame, newest_);
    if (const auto sum = trouble(); sum != known_trouble_) {
      known_trouble_ = sum;
      last_trouble_ = newest_;
    }
    if (!counts) return false;
    fill(f, *counts, newest_, out);
    return true;
  }
  return false;
}

void RftDevice::fill(std::size_t finger, const RftCounts& counts, Timestamp stamp,
                     SensorSample& out) noexcept {
  const RftSensorConfig& sensor = config_.sensors[finger];
  const Wrench wrench_S = wrench_of(counts, sensor.divisors);
  out.finger = kFingers[finger];
  out.stamp = stamp;
  out.wrench_C = sensor.mounting.to_contact(wrench_S);
  out.raw_counts = counts.raw;
  out.valid = true;
  out.flags = 0;
  const bool saturated =
      (wrench_S.force.array().abs() >= kSaturated * sensor.range.head<3>().array()).any() ||
      (wrench_S.torque.array().abs() >= kSaturated * sensor.range.tail<3>().array()).any();
  if (saturated) out.flags |= bit(SampleFlag::saturated);
  if (counts.overload != 0) {
    out.flags |= bit(SampleFlag::overload);
    last_overload_ = stamp;
  }
  ++counters_[finger].good;
  if (out.flags != 0) ++counters_[finger].overloaded;
}

ReadStatus RftDevice::read(Timestamp deadline, SensorSample& out) noexcept {
  ReceivedFrame in;
  for (int frames = 0;; ++frames) {
    if (frames >= kMostFramesPastDeadline && clock_->now() >= deadline) return ReadStatus::timeout;
    switch (bus_->receive(std::min(deadline, due()), in)) {
      case BusEvent::frame:
        if (take(in, out)) return ReadStatus::sample;
        break;
      case BusEvent::timeout: {
        // Only now, with nothing left to read, is a sensor's silence its own: after a stall of this
        // computer the frames have been waiting.
        const Timestamp now = clock_->now();
        serve(now);
        if (now >= deadline) return ReadStatus::timeout;
        break;
      }
      case BusEvent::bus_off: bus_fault_ = DeviceFault::bus_off; break;
      case BusEvent::interface_down: bus_fault_ = DeviceFault::interface_down; break;
      case BusEvent::interface_gone: bus_fault_ = DeviceFault::interface_gone; break;
    }
  }
}

void RftDevice::stop() noexcept {
  if (clock_ == nullptr) return;
  for (const auto& session : sessions_) bus_->send(encode_command(session.ids(), RftCommand::stop));
  // Frames that found the bus busy leave while somebody receives.
  constexpr Timestamp kDrain = std::chrono::milliseconds(5);
  const Timestamp end = clock_->now() + kDrain;
  ReceivedFrame ignored;
  while (bus_->receive(end, ignored) == BusEvent::frame) {
  }
  started_ = false;
  stopped_ = true;
}

}  // namespace isograsp
