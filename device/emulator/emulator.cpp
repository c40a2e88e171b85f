// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/emulator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "device/config/family_facts.hpp"

namespace isograsp {

namespace {

using Kind = Fault::Kind;

constexpr Timestamp kAnswerDelay = std::chrono::microseconds(600);  // assumed; not specified
constexpr double kBeyondRange = 1.3;                                // of a saturated sensor
constexpr std::uint8_t kFramesOnDemand = 64;

bool happens_once(const Fault& fault) noexcept {
  return fault.kind == Kind::restart || fault.kind == Kind::burst;
}

}  // namespace

Emulator::Emulator(EmulatorOptions options, FingerPlay play)
    : options_(std::move(options)), play_(std::move(play)), random_(options_.seed) {
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    clock_error_[f] = options_.clock_error * (2.0 * uniform() - 1.0);
    phase_[f] = uniform();
    sensors_[f] = options_.config.family->make_emulated(f, options_.config);
  }
  struck_.resize(options_.faults.size());
  departures_.reserve(kFramesOnDemand);
}

double Emulator::uniform() noexcept {
  return static_cast<double>(random_() >> 11) * 0x1p-53;
}

double Emulator::clock_factor(std::size_t finger) const {
  return 1.0 + clock_error_[finger];
}

int Emulator::noise_counts() {
  if (options_.noise_counts <= 0) return 0;
  return static_cast<int>(uniform() * (2 * options_.noise_counts + 1)) - options_.noise_counts;
}

std::string Emulator::serial_number(std::size_t finger) const {
  const auto number = std::to_string(finger + 1);
  for (const auto& fault : options_.faults)
    if (fault.kind == Kind::wrong_serial && fault.fingers[finger]) return "WRONG-" + number;
  const auto& wanted = options_.config.sensors[finger].serial_number;
  return wanted.empty() ? "EMUL-" + number : wanted;
}

double Emulator::play_time_s(Timestamp now) const noexcept {
  return play_start_ == Timestamp::max() ? -1.0 : to_seconds(now - play_start_);
}

const Fault* Emulator::acting(Kind kind, std::size_t finger, double t_s) const noexcept {
  for (const auto& fault : options_.faults)
    if (fault.kind == kind && fault.fingers[finger] && fault.acts_at(t_s)) return &fault;
  return nullptr;
}

const Fault* Emulator::hit(Kind kind, std::size_t finger) {
  const Fault* found = nullptr;
  for (const auto& fault : options_.faults)
    if (fault.kind == kind && fault.fingers[finger] && uniform() < fault.probability)
      found = &fault;
  return found;
}

bool Emulator::silent(std::size_t finger, Timestamp now) const noexcept {
  return acting(Kind::silence, finger, play_time_s(now)) != nullptr;
}

Wrench Emulator::feel(std::size_t finger, double play_s) {
  const SensorConfig& sensor = options_.config.sensors[finger];
  Wrench wrench_S = sensor.mounting.to_sensor(play_.at(play_s)[finger]);
  if (sensor.calibration) {
    Vec6 value;
    value << wrench_S.force, wrench_S.torque;
    value = sensor.calibration->matrix.partialPivLu().solve(value);
    wrench_S = {value.head<3>(), value.tail<3>()};
  }
  if (const Fault* drift = acting(Kind::drift, finger, play_s))
    wrench_S.force.z() += drift->amount * (play_s - drift->at_s);
  if (acting(Kind::saturate, finger, play_s) != nullptr)
    wrench_S.force.z() = -kBeyondRange * sensor.range[2];
  return wrench_S;
}

void Emulator::depart(Timestamp when, const BusFrame& frame) {
  const auto place =
      std::upper_bound(departures_.begin(), departures_.end(), when,
                       [](Timestamp t, const Departure& departure) { return t < departure.when; });
  departures_.insert(place, {when, frame});
}

void Emulator::send_answer(std::size_t finger, Timestamp now, std::span<const BusFrame> frames) {
  if (silent(finger, now)) return;
  for (const auto& frame : frames) depart(now + kAnswerDelay, frame);
}

void Emulator::send_sample(std::size_t finger, Timestamp when, std::span<const BusFrame> fresh) {
  if (silent(finger, when)) return;
  EmulatorCounters& counters = counters_[finger];
  ++counters.samples;
  std::vector<BusFrame>& frames = last_sample_[finger];
  if (acting(Kind::freeze, finger, play_time_s(when)) != nullptr && !frames.empty())
    ++counters.frozen;
  else
    frames.assign(fresh.begin(), fresh.end());

  bool first = !std::exchange(lose_first_of_next_[finger], false);
  bool second = true;
  if (hit(Kind::lose_first, finger) != nullptr) first = false;
  if (hit(Kind::lose_second, finger) != nullptr) second = false;
  if (hit(Kind::lose_sample, finger) != nullptr) first = second = false;
  if (hit(Kind::lose_across, finger) != nullptr) {
    second = false;
    lose_first_of_next_[finger] = true;
  }
  const bool whole = frames.size() == 1;  // a single frame is both the first and the second
  counters.lost_first += first ? 0 : 1;
  counters.lost_second += second || whole ? 0 : 1;
  counters.lost_samples += first && second ? 0 : 1;
  std::vector<BusFrame> out;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (whole ? first && second : (i == 0 ? first : second)) out.push_back(frames[i]);

  bool broken = !first || !second;
  if (out.size() > 1 && hit(Kind::swap, finger) != nullptr) {
    ++counters.swapped;
    broken = true;
    std::reverse(out.begin(), out.end());
  }
  if (!out.empty() && hit(Kind::length, finger) != nullptr) {
    ++counters.cut;
    broken = true;
    out.front().length = static_cast<std::uint8_t>(out.front().length / 2);
  }
  if (!out.empty() && hit(Kind::foreign, finger) != nullptr) {
    ++counters.foreign;
    BusFrame other = out.front();
    (uniform() < 0.5 ? other.extended : other.remote) = true;
    out.insert(out.begin(), other);
  }
  counters.broken += broken ? 1 : 0;
  if (hit(Kind::answer, finger) != nullptr) {
    ++counters.answers;
    sensors_[finger]->answer_unasked(when, *this);
  }
  const bool twice = hit(Kind::duplicate, finger) != nullptr;
  counters.duplicated += twice ? 1 : 0;
  if (const Fault* delay = hit(Kind::delay, finger)) {
    ++counters.delayed;
    when += from_seconds(delay->amount);
  }
  for (const auto& frame : out)
    for (int copy = 0; copy < (twice ? 2 : 1); ++copy) depart(when, frame);
}

void Emulator::receive(const BusFrame& frame, Timestamp now) {
  make_measurements(now);
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (silent(f, now)) continue;
    sensors_[f]->receive(frame, now, *this);
    play_start_ = std::min(play_start_, sensors_[f]->play_start());
  }
}

Timestamp Emulator::instant_of(const Fault& fault) const noexcept {
  return play_start_ == Timestamp::max() ? play_start_ : play_start_ + from_seconds(fault.at_s);
}

Timestamp Emulator::next_strike() const noexcept {
  Timestamp soonest = Timestamp::max();
  for (std::size_t i = 0; i < options_.faults.size(); ++i)
    if (!struck_[i] && happens_once(options_.faults[i]))
      soonest = std::min(soonest, instant_of(options_.faults[i]));
  return soonest;
}

void Emulator::strike(Timestamp now) {
  for (std::size_t i = 0; i < options_.faults.size(); ++i) {
    const Fault& fault = options_.faults[i];
    if (struck_[i] || !happens_once(fault) || now < instant_of(fault)) continue;
    struck_[i] = true;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      if (!fault.fingers[f]) continue;
      if (fault.kind == Kind::restart) {
        ++counters_[f].restarts;
        sensors_[f]->power_dip(now, *this);
      } else if (!last_sample_[f].empty()) {
        const auto copies = static_cast<std::uint64_t>(fault.amount);
        counters_[f].burst += copies;
        for (std::uint64_t n = 0; n < copies; ++n) depart(now, last_sample_[f].back());
      }
    }
  }
}

Timestamp Emulator::next() const noexcept {
  Timestamp soonest = departures_.empty() ? Timestamp::max() : departures_.front().when;
  if (finished_) return soonest;
  soonest = std::min(soonest, next_strike());
  for (const auto& sensor : sensors_) soonest = std::min(soonest, sensor->next_measurement());
  return soonest;
}

void Emulator::make_measurements(Timestamp now) {
  while (!finished_) {
    std::size_t soonest = 0;
    for (std::size_t f = 1; f < kFingerCount; ++f)
      if (sensors_[f]->next_measurement() < sensors_[soonest]->next_measurement()) soonest = f;
    const Timestamp when = sensors_[soonest]->next_measurement();
    strike(std::min(when, now));
    if (sensors_[soonest]->next_measurement() != when) continue;  // a fault came first
    if (when > now || when == Timestamp::max()) return;
    sensors_[soonest]->measure(*this);
  }
}

bool Emulator::take(Timestamp now, BusFrame& out) {
  make_measurements(now);
  if (departures_.empty() || departures_.front().when > now) return false;
  out = departures_.front().frame;
  departures_.erase(departures_.begin());
  return true;
}

void Emulator::finish(Timestamp now) {
  make_measurements(now);
  finished_ = true;
}

}  // namespace isograsp
