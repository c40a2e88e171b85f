// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/sensors/sensor_device.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/csv.hpp"
#include "device/config/family_facts.hpp"

namespace isograsp {

namespace {

constexpr Timestamp kRecent = std::chrono::seconds(1);  // how long a damaged sample is reported
constexpr Timestamp kRestartTold = std::chrono::seconds(10);  // how long a restart is reported
// The values of a sensor that measures change a little all the time. The screens say within 0.2 s
// that they stand still, but not before some repeats: a slow sensor sends few samples in that time.
constexpr Timestamp kLongestStandstill = std::chrono::milliseconds(150);
constexpr int kMostRepeats = 10;
constexpr double kSaturatedShare = 0.98;  // of the rating
constexpr int kMostFramesPastDeadline = 64;

bool is_recent(Timestamp event, Timestamp now, Timestamp span = kRecent) noexcept {
  return event != Timestamp::min() && now - event < span;
}

Vec6 turned(const Mounting& mounting, const Vec6& range) {
  const Mat3 turn = mounting.q_CS.toRotationMatrix().cwiseAbs();
  Vec6 out;
  out << turn * range.head<3>(), turn * range.tail<3>();
  return out;
}

bool at_limit(const Wrench& wrench_S, const Vec6& range) noexcept {
  return (wrench_S.force.array().abs() >= kSaturatedShare * range.head<3>().array()).any() ||
         (wrench_S.torque.array().abs() >= kSaturatedShare * range.tail<3>().array()).any();
}

}  // namespace

SensorDevice::SensorDevice(std::unique_ptr<Bus> bus, SensorSessions sessions,
                           const DeviceConfig& config, const std::vector<double>& fir,
                           std::string uri, std::string place)
    : bus_(std::move(bus)),
      sessions_(std::move(sessions)),
      config_(config),
      place_(std::move(place)),
      fir_delay_s_(fir_delay_s(fir.size(), config.rate_Hz)) {
  info_.uri = std::move(uri);
  info_.description = "%1 on %2"_text(config.family->title, Known{place_});
  info_.sample_period_s = 1.0 / config.rate_Hz;
  info_.hand = config.hand;
  info_.platform = config.platform;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const SensorConfig& sensor = config.sensors[f];
    tracks_[f].filter = FirFilter(fir);
    info_.serial_numbers[f] = sensor.serial_number;
    info_.range[f] = turned(sensor.mounting, sensor.range);
    info_.units_per_count[f] = sessions_[f]->units_per_count();
    info_.delay_s = std::max(info_.delay_s, sessions_[f]->sensor_delay_s() + fir_delay_s_);
    if (!sensor.calibration) continue;
    info_.provenance.push_back(std::string(kFingerNames[f]) + " calibration: " +
                               sensor.calibration->file + ", " + sensor.calibration->date);
    info_.calibration[f] = std::filesystem::path(sensor.calibration->file).filename().string() +
                           " " + sensor.calibration->date;
    for (Eigen::Index i = 0; i < 6; ++i)
      for (Eigen::Index j = 0; j < 6; ++j)
        info_.calibration[f] += " " + format_number(sensor.calibration->matrix(i, j));
  }
}

DeviceFault SensorDevice::fault_of(std::size_t finger, Timestamp now) const noexcept {
  const Track& track = tracks_[finger];
  const SensorSession& session = *sessions_[finger];
  using Failure = SensorSession::Failure;
  if (session.failure() != Failure::none && session.failure() != Failure::no_answer)
    return DeviceFault::wrong_sensor;
  if (!session.streaming()) return DeviceFault::silence;
  if (track.frozen) return DeviceFault::frozen;
  if (is_recent(track.last_status_error, now)) return DeviceFault::status;
  if (is_recent(track.last_overload, now)) return DeviceFault::overload;
  if (is_recent(track.last_restart, now, kRestartTold)) return DeviceFault::restarted;
  if (is_recent(track.last_damage, now)) return DeviceFault::damaged_samples;
  return DeviceFault::none;
}

DeviceHealth SensorDevice::health() const noexcept {
  DeviceHealth health;
  health.bus = bus_->counters();
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const SessionCounters counted = sessions_[f]->counters();
    SensorCounters& sensor = health.sensors[f];
    sensor = tracks_[f].counters;
    sensor.torn = counted.torn;
    sensor.duplicate = counted.duplicate;
    sensor.late = counted.late;
    sensor.lost = counted.lost;
    sensor.restarts = counted.restarts;
    health.foreign_frames += counted.foreign;
  }
  if (!started_) {
    health.state = stopped_ ? DeviceState::configured : DeviceState::absent;
    return health;
  }
  const Timestamp now = clock_->now();
  // The gravest fault of all; in the enumeration, what comes first is graver.
  health.fault = bus_fault_;
  if (health.fault == DeviceFault::none) {
    const auto graver = [&](DeviceFault fault, std::optional<Finger> finger) {
      if (fault == DeviceFault::none) return;
      if (health.fault != DeviceFault::none && health.fault <= fault) return;
      health.fault = fault;
      health.finger = finger;
    };
    for (std::size_t f = 0; f < kFingerCount; ++f) graver(fault_of(f, now), kFingers[f]);
    if (is_recent(last_overflow_, now)) graver(DeviceFault::bus_overflow, std::nullopt);
    graver(bus_trouble_, std::nullopt);
  }
  if (health.fault == DeviceFault::none)
    health.state = DeviceState::streaming;
  else
    health.state = stops_forces(health.fault) ? DeviceState::faulted : DeviceState::degraded;
  return health;
}

Timestamp SensorDevice::due() const noexcept {
  Timestamp soonest = Timestamp::max();
  for (const auto& session : sessions_) soonest = std::min(soonest, session->due());
  return soonest;
}

void SensorDevice::serve(Timestamp now) noexcept {
  const auto send_due = [&](SensorSession& session) {
    while (const auto frame = session.poll(now)) bus_->send(*frame);
  };
  for (auto& session : sessions_) send_due(*session);
  const bool all_ready =
      std::all_of(sessions_.begin(), sessions_.end(), [](const auto& s) { return s->ready(); });
  for (auto& session : sessions_) {
    if (!session->ready() || (!started_ && !all_ready)) continue;
    session->go(now);
    send_due(*session);
  }
}

Result<void> SensorDevice::start(Clock& clock) {
  if (auto started = bus_->start(clock); !started) return started.error();
  clock_ = &clock;
  bus_fault_ = bus_trouble_ = DeviceFault::none;
  newest_ = clock.now();
  for (auto& session : sessions_) session->begin(clock.now());

  while (!std::all_of(sessions_.begin(), sessions_.end(),
                      [](const auto& s) { return s->streaming(); })) {
    ReceivedFrame in;
    SensorSample early;
    const BusEvent event = bus_->receive(due(), in);
    if (event == BusEvent::frame)
      (void)take(in, early);
    else if (event == BusEvent::timeout)
      serve(clock.now());
    else
      note(event);
    if (bus_fault_ != DeviceFault::none) {
      stop();
      return failed("the bus failed while the sensors were started: %1"_text(words_of(bus_fault_)),
                    "check the adapter and its cable"_text)
          .at(place_);
    }
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if (sessions_[f]->failure() == SensorSession::Failure::none) continue;
      const Error error = sessions_[f]->error(kFingerNames[f], place_);
      stop();
      return error;
    }
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    SensorSession& session = *sessions_[f];
    if (!session.serial_number().empty()) info_.serial_numbers[f] = session.serial_number();
    info_.units_per_count[f] = session.units_per_count();
    session.reset_counters();  // answers damaged in the set-up are no damaged samples
    Track fresh;
    fresh.filter = tracks_[f].filter;
    fresh.filter.restart();
    tracks_[f] = fresh;
  }
  known_drops_ = bus_->counters().kernel_drops;
  started_ = true;
  return {};
}

void SensorDevice::note(BusEvent event) noexcept {
  switch (event) {
    case BusEvent::bus_off: bus_fault_ = DeviceFault::bus_off; break;
    case BusEvent::interface_down: bus_fault_ = DeviceFault::interface_down; break;
    case BusEvent::interface_gone: bus_fault_ = DeviceFault::interface_gone; break;
    case BusEvent::error_warning:
    case BusEvent::error_passive: bus_trouble_ = DeviceFault::bus_warning; break;
    case BusEvent::error_active: bus_trouble_ = DeviceFault::none; break;
    case BusEvent::overflow: last_overflow_ = clock_->now(); break;
    case BusEvent::restarted:
      bus_fault_ = bus_trouble_ = DeviceFault::none;
      for (auto& session : sessions_)  // so far they were asked in vain
        if (!session->streaming()) session->begin(clock_->now());
      break;
    case BusEvent::frame:
    case BusEvent::timeout: break;
  }
}

bool SensorDevice::take(const ReceivedFrame& in, SensorSample& out) noexcept {
  bus_fault_ = DeviceFault::none;  // frames arrive, so the bus works
  newest_ = std::max(newest_, in.stamp);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (!sessions_[f]->owns(in.frame)) continue;
    Measurement measurement;
    const bool measured = sessions_[f]->take(in.frame, newest_, measurement);
    watch_counters(newest_);
    if (measured) fill(f, measurement, out);
    return measured;
  }
  return false;
}

void SensorDevice::watch_counters(Timestamp now) noexcept {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const SessionCounters counted = sessions_[f]->counters();
    Track& track = tracks_[f];
    SensorCounters& known = track.counters;
    if (counted.torn + counted.lost != known.torn + known.lost) track.last_damage = now;
    if (counted.restarts != known.restarts) track.last_restart = now;
    known.torn = counted.torn;
    known.lost = counted.lost;
    known.restarts = counted.restarts;
  }
  if (const auto drops = bus_->counters().kernel_drops; drops != known_drops_) {
    known_drops_ = drops;
    last_overflow_ = now;
  }
}

/// The values of a sensor that measures vary by a count or two. If every sample has a number, the
/// number tells whether it measures; if not, one value repeated for too long means that it no
/// longer does.
bool SensorDevice::repeats_too_long(Track& track, const Measurement& measurement) const noexcept {
  if (measurement.numbered || track.repeated_since == Timestamp::min() ||
      measurement.raw_counts != track.repeated) {
    track.repeated = measurement.raw_counts;
    track.repeated_since = measurement.stamp;
    track.repeats = 0;
  } else {
    track.repeats = std::min(track.repeats + 1, kMostRepeats);
  }
  return track.repeats >= kMostRepeats &&
         measurement.stamp - track.repeated_since > kLongestStandstill;
}

bool SensorDevice::smooth(Track& track, std::uint64_t lost, Wrench& wrench_S) noexcept {
  Vec6 value;
  value << wrench_S.force, wrench_S.torque;
  const Vec6 input = value;
  // One lost sample is bridged by the straight line between its neighbours; more empty the filter.
  if (track.has_input && lost == 1) {
    Vec6 between = 0.5 * (track.last_input + value);
    (void)track.filter.push(between);
  } else if (lost > 0 || !track.has_input) {
    track.filter.restart();
  }
  track.last_input = input;
  track.has_input = true;
  const bool ready = track.filter.push(value);
  wrench_S = {value.head<3>(), value.tail<3>()};
  return ready;
}

void SensorDevice::fill(std::size_t finger, const Measurement& measurement,
                        SensorSample& out) noexcept {
  const SensorConfig& sensor = config_.sensors[finger];
  Track& track = tracks_[finger];
  SensorCounters& counters = track.counters;
  out.finger = kFingers[finger];
  out.stamp = measurement.stamp;
  out.raw_counts = measurement.raw_counts;
  out.valid = measurement.valid;
  out.flags = 0;
  Wrench wrench_S = measurement.wrench_S;
  // Reported at once and before any filter: a hand may be in danger.
  const bool saturated = measurement.saturated || at_limit(wrench_S, sensor.range);
  if (saturated) out.flags |= bit(SampleFlag::saturated);
  if (measurement.overload) out.flags |= bit(SampleFlag::overload);
  if (out.flags != 0) track.last_overload = measurement.stamp;
  counters.saturated += saturated ? 1 : 0;
  counters.overload += measurement.overload ? 1 : 0;

  track.frozen = repeats_too_long(track, measurement);
  counters.stale += track.frozen ? 1 : 0;
  if (measurement.status_error) {
    ++counters.status_errors;
    track.last_status_error = measurement.stamp;
  }
  out.valid = out.valid && !track.frozen;

  const std::uint64_t lost = sessions_[finger]->counters().lost;
  const std::uint64_t lost_before_this = lost - std::exchange(track.lost_before, lost);
  if (!out.valid) {
    track.has_input = false;
  } else {
    wrench_S = sensor.corrected(wrench_S);
    // The first samples after a gap are good but the filter has no value yet.
    out.valid = smooth(track, lost_before_this, wrench_S);
  }
  ++(out.valid ? counters.good : counters.invalid);
  out.wrench_C = out.valid ? sensor.mounting.to_contact(wrench_S) : Wrench{};
}

ReadStatus SensorDevice::read(Timestamp deadline, SensorSample& out) noexcept {
  if (!started_) return ReadStatus::finished;
  ReceivedFrame in;
  for (int frames = 0;; ++frames) {
    if (frames >= kMostFramesPastDeadline && clock_->now() >= deadline) return ReadStatus::timeout;
    const BusEvent event = bus_->receive(std::min(deadline, due()), in);
    if (event == BusEvent::frame) {
      if (take(in, out)) return ReadStatus::sample;
    } else if (event == BusEvent::timeout) {
      // Silence is judged only now, when nothing is left to read: after a stall of this computer
      // the frames have been waiting, and the sensors were not silent.
      const Timestamp now = clock_->now();
      serve(now);
      watch_counters(now);
      if (now >= deadline) return ReadStatus::timeout;
    } else {
      note(event);
    }
  }
}

void SensorDevice::stop() noexcept {
  if (clock_ == nullptr) return;
  for (const auto& session : sessions_)
    if (const auto frame = session->stop_frame()) bus_->send(*frame);
  // Frames that still wait for the bus are sent by receive().
  constexpr Timestamp kDrain = std::chrono::milliseconds(5);
  const Timestamp end = clock_->now() + kDrain;
  ReceivedFrame ignored;
  while (bus_->receive(end, ignored) == BusEvent::frame) {
  }
  started_ = false;
  stopped_ = true;
}

}  // namespace isograsp
