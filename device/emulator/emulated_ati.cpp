// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/emulated_ati.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/LU>

#include "device/config/ati_sensor.hpp"

namespace isograsp {

AtiCalibration synthetic_ati_calibration() noexcept {
  AtiCalibration calibration;
  calibration.matrix << 1250.5, -310.25, 95.75, -16820, -140.5, 16455.25,  //
      -702, 19850.5, 388.25, -9702.75, 512.5, -9533,                       //
      20110.75, 205.5, 20455, -88.25, 20290.5, 401.75,                     //
      -8.5, 128.75, -322.5, -61.25, 331.75, -64.5,                         //
      371.25, 4.5, -190, 109.75, -183.25, -112.5,                          //
      11.75, -196.5, 7.25, -193.25, 9.5, -197.75;
  return calibration;
}

EmulatedAti::EmulatedAti(std::size_t finger, const EmulatedAtiSettings& settings)
    : EmulatedSensor(finger), settings_(settings), next_base_(settings.base) {
  const AtiCalibration& calibration = settings.calibration;
  assert(calibration.usable());
  Vec6 counts_per_unit;
  counts_per_unit.head<3>().setConstant(calibration.counts.per_force /
                                        *ati_newton(calibration.units.force));
  counts_per_unit.tail<3>().setConstant(calibration.counts.per_torque /
                                        *ati_newton_metre(calibration.units.torque));
  inverse_ = calibration.matrix.inverse() * counts_per_unit.asDiagonal();
}

RawCounts EmulatedAti::gages_of(const Wrench& wrench_S) const noexcept {
  Vec6 wrench;
  wrench << wrench_S.force, wrench_S.torque;
  const Vec6 exact = inverse_ * wrench;
  RawCounts gages;
  for (std::size_t i = 0; i < gages.size(); ++i) {
    const double count = std::round(exact[static_cast<Eigen::Index>(i)]) + settings_.bias[i];
    gages[i] = static_cast<std::int32_t>(std::clamp(count, 1.0 * INT16_MIN, 1.0 * INT16_MAX));
  }
  return gages;
}

AtiReading EmulatedAti::read(Timestamp now, EmulatorWorld& world) {
  if (play_start_ == Timestamp::max()) play_start_ = now;
  AtiReading reading;
  reading.status = settings_.status;
  if (slot_ != settings_.good_slot) reading.status |= kAtiBadCalibration | kAtiAnyError;
  reading.gages = gages_of(world.feel(finger(), to_seconds(now - play_start_)));
  for (auto& gage : reading.gages)
    gage = std::clamp(gage + world.noise_counts(), INT16_MIN, INT16_MAX);
  return reading;
}

void EmulatedAti::receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) {
  const std::uint8_t base = settings_.base;
  if (!ati_owns(base, frame) || now < deaf_until_) return;
  const AtiWord word = ati_word(frame);
  if (word != AtiWord::request && word != AtiWord::either) return;
  const auto answer = [&](const BusFrame& content) {
    world.send_answer(finger(), now, std::array{content});
  };
  const std::uint8_t parameter = frame.data[0];
  switch (ati_opcode(frame)) {
    case AtiOpcode::gages:
      return world.send_sample(finger(), now + settings_.answer_delay,
                               ati_reading_frames(base, read(now, world)));
    case AtiOpcode::matrix_row: {
      if (parameter > 5) return;
      AtiRow row{};
      if (slot_ == settings_.good_slot)
        for (std::size_t i = 0; i < row.size(); ++i)
          row[i] = static_cast<float>(
              settings_.calibration.matrix(parameter, static_cast<Eigen::Index>(i)));
      return world.send_answer(finger(), now, ati_row_frames(base, row));
    }
    case AtiOpcode::serial_number:
      return answer(ati_serial_frame(base, world.serial_number(finger()).substr(0, 8)));
    case AtiOpcode::calibration:
      if (parameter > 15) return;
      slot_ = parameter;
      return answer(frame);
    case AtiOpcode::counts:
      if (settings_.firmware.tells_counts())
        answer(ati_counts_frame(base, settings_.calibration.counts));
      return;
    case AtiOpcode::units:
      if (settings_.firmware.tells_counts())
        answer(ati_units_frame(base, settings_.calibration.units));
      return;
    case AtiOpcode::diagnostic: return answer(ati_diagnostic_frame(base, 0));
    case AtiOpcode::reset: return reset(now);
    case AtiOpcode::set_base:
      if (parameter < 0x80) next_base_ = parameter;
      return answer(ati_request(base, AtiOpcode::set_base));
    case AtiOpcode::set_baud: return answer(ati_request(base, AtiOpcode::set_baud));
    case AtiOpcode::firmware: return answer(ati_firmware_frame(base, settings_.firmware));
    default: return;
  }
}

void EmulatedAti::reset(Timestamp now) noexcept {
  slot_ = 0;
  deaf_until_ = now + settings_.boot_time;
}

void EmulatedAti::power_dip(Timestamp now, EmulatorWorld&) {
  reset(now);
  settings_.base = next_base_;
}

void EmulatedAti::answer_unasked(Timestamp now, EmulatorWorld& world) {
  world.send_answer(finger(), now,
                    std::array{ati_serial_frame(settings_.base, world.serial_number(finger()))});
}

std::unique_ptr<EmulatedSensor> make_emulated_ati(std::size_t finger, const DeviceConfig& config) {
  const AtiSensor& sensor = config.sensors[finger].as<AtiSensor>();
  EmulatedAtiSettings settings;
  settings.base = sensor.base;
  settings.good_slot = sensor.calibration;
  return std::make_unique<EmulatedAti>(finger, settings);
}

}  // namespace isograsp
