// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/emulated_jr3.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "device/config/jr3_sensor.hpp"

namespace isograsp {

EmulatedJr3::EmulatedJr3(std::size_t finger, const EmulatedJr3Settings& settings)
    : EmulatedSensor(finger), settings_(settings) {}

Timestamp EmulatedJr3::next_measurement() const {
  if (mode_ != Mode::async) return Timestamp::max();
  const double own_s = (static_cast<double>(measured_) + phase_) * period_s_;
  return started_ + from_seconds(own_s * clock_factor_);
}

void EmulatedJr3::measure(EmulatorWorld& world) {
  const Timestamp when = next_measurement();
  ++measured_;
  send(when, world);
}

void EmulatedJr3::start(Mode mode, Timestamp now, const BusFrame& frame) {
  mode_ = mode;
  started_ = now;
  measured_ = 0;
  settled_ = false;
  cutoff_Hz_ = (frame.data[0] | frame.data[1] << 8) / 100.0;
}

void EmulatedJr3::receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) {
  if (is_jr3_sync(frame)) {
    if (mode_ == Mode::sync) send(now, world);
    return;
  }
  if (!jr3_owns(settings_.node, frame) || jr3_word(frame) != Jr3Word::request) return;
  clock_factor_ = world.clock_factor(finger());
  phase_ = world.phase(finger());
  Jr3Acknowledge answer{settings_.initialised, std::nullopt};
  switch (jr3_opcode(frame)) {
    case Jr3Opcode::start_sync: start(Mode::sync, now, frame); break;
    case Jr3Opcode::start_async:
      start(Mode::async, now, frame);
      period_s_ = 1e-6 * std::max(1U, static_cast<unsigned>(frame.data[2]) |
                                          static_cast<unsigned>(frame.data[3]) << 8 |
                                          static_cast<unsigned>(frame.data[4]) << 16 |
                                          static_cast<unsigned>(frame.data[5]) << 24);
      break;
    case Jr3Opcode::stop: mode_ = Mode::idle; break;
    case Jr3Opcode::set_filter:
      cutoff_Hz_ = (frame.data[0] | frame.data[1] << 8) / 100.0;
      settled_ = false;
      break;
    case Jr3Opcode::zero_offsets: {
      if (play_start_ == Timestamp::max()) break;
      zero_ = {};
      zero_ = filter(world.feel(finger(), to_seconds(now - play_start_)), now, world);
      break;
    }
    case Jr3Opcode::force_scales: answer.scales = settings_.calibration.force_N; break;
    case Jr3Opcode::moment_scales: answer.scales = settings_.calibration.moment_dNm; break;
    case Jr3Opcode::reset:
      world.send_answer(finger(), now, std::array{jr3_acknowledge(settings_.node, answer)});
      return power_dip(now, world);
    case Jr3Opcode::gripper: return;
    default: break;  // state
  }
  world.send_answer(finger(), now, std::array{jr3_acknowledge(settings_.node, answer)});
}

RawCounts EmulatedJr3::filter(const Wrench& wrench_S, Timestamp now, const EmulatorWorld& world) {
  const double passed_s = to_seconds(now - filtered_);
  const double pass = world.filtered() && cutoff_Hz_ > 0.0 && settled_
                          ? -std::expm1(-2.0 * std::numbers::pi * cutoff_Hz_ * passed_s)
                          : 1.0;
  filtered_ = now;
  settled_ = true;
  const Vec6 unit = settings_.calibration.units_per_count();
  RawCounts counts;
  for (std::size_t axis = 0; axis < counts.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    const double value = axis < 3 ? wrench_S.force[i] : wrench_S.torque[i - 3];
    const double exact = value / unit[i];
    low_pass_[axis] = pass == 1.0 ? exact : low_pass_[axis] + pass * (exact - low_pass_[axis]);
    const double count = std::round(low_pass_[axis]) - zero_[axis];
    counts[axis] = static_cast<std::int32_t>(std::clamp(count, 1.0 * INT16_MIN, 1.0 * INT16_MAX));
  }
  return counts;
}

void EmulatedJr3::send(Timestamp now, EmulatorWorld& world) {
  if (play_start_ == Timestamp::max()) play_start_ = now;
  Jr3Reading reading;
  const double own_s = to_seconds(now - powered_) / clock_factor_;
  reading.number = static_cast<std::uint16_t>(
      settings_.first_number +
      static_cast<std::uint64_t>(std::max(0.0, own_s) * settings_.sensor_rate_Hz));
  reading.raw = filter(world.feel(finger(), to_seconds(now - play_start_)), now, world);
  for (auto& count : reading.raw)
    count = std::clamp(count + world.noise_counts(), INT16_MIN, INT16_MAX);
  world.send_sample(finger(), now, jr3_reading_frames(settings_.node, reading));
}

void EmulatedJr3::power_dip(Timestamp now, EmulatorWorld& world) {
  mode_ = Mode::idle;
  cutoff_Hz_ = 0.0;
  zero_ = {};
  powered_ = now;
  world.send_answer(finger(), now, std::array{jr3_request(settings_.node, Jr3Opcode::boot_up)});
}

void EmulatedJr3::answer_unasked(Timestamp now, EmulatorWorld& world) {
  const Jr3Acknowledge ready{settings_.initialised, std::nullopt};
  world.send_answer(finger(), now, std::array{jr3_acknowledge(settings_.node, ready)});
}

std::unique_ptr<EmulatedSensor> make_emulated_jr3(std::size_t finger, const DeviceConfig& config) {
  EmulatedJr3Settings settings;
  settings.node = config.sensors[finger].as<Jr3Sensor>().node;
  return std::make_unique<EmulatedJr3>(finger, settings);
}

}  // namespace isograsp
