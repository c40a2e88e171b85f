// SPDX-License-Identifier: GPL-3.0-or-later
// An ATI sensor with a NETCANOEM board in software: it answers when it is asked and forgets the
// chosen calibration when its power dips. Matrix rows are Fx Fy Fz Tx Ty Tz of the sensor frame.
#pragma once

#include <memory>
#include <optional>

#include "device/codec/ati_codec.hpp"
#include "device/config/device_config.hpp"
#include "device/emulator/emulated_sensor.hpp"

namespace isograsp {

/// A made-up transducer of the Mini class, in N and N m, 1 000 000 counts per unit.
[[nodiscard]] AtiCalibration synthetic_ati_calibration() noexcept;

struct EmulatedAtiSettings {
  std::uint8_t base = 0x20;
  std::uint8_t good_slot = 0;  ///< holds the calibration; all others are bad
  AtiCalibration calibration = synthetic_ati_calibration();
  RawCounts bias{};               ///< gages without load
  AtiFirmware firmware{3, 8, 2};  ///< below 3.7: counts and units are not told
  std::uint16_t status = 0;       ///< bits that are always set
  Timestamp answer_delay = std::chrono::microseconds(300);  ///< assumed; not documented
  Timestamp boot_time = std::chrono::milliseconds(200);     ///< assumed; not documented
};

class EmulatedAti final : public EmulatedSensor {
 public:
  /// @pre settings.calibration.usable()
  EmulatedAti(std::size_t finger, const EmulatedAtiSettings& settings);

  void receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) override;
  /// Never: it only answers.
  [[nodiscard]] Timestamp next_measurement() const override { return Timestamp::max(); }
  void measure(EmulatorWorld&) override {}
  void power_dip(Timestamp now, EmulatorWorld& world) override;
  void answer_unasked(Timestamp now, EmulatorWorld& world) override;
  [[nodiscard]] Timestamp play_start() const override { return play_start_; }

  /// Gages at this wrench (sensor frame), rounded and clamped to 16 bits.
  [[nodiscard]] RawCounts gages_of(const Wrench& wrench_S) const noexcept;

 private:
  [[nodiscard]] AtiReading read(Timestamp now, EmulatorWorld& world);
  void reset(Timestamp now) noexcept;

  EmulatedAtiSettings settings_;
  Eigen::Matrix<double, 6, 6> inverse_;  ///< counts of the gages per N, N m
  std::uint8_t slot_ = 0;                ///< every reset chooses it
  std::uint8_t next_base_;               ///< after the next power-up
  Timestamp deaf_until_ = Timestamp::min();
  Timestamp play_start_ = Timestamp::max();
};

/// @pre config.sensors[finger] is reached as an AtiSensor
[[nodiscard]] std::unique_ptr<EmulatedSensor> make_emulated_ati(std::size_t finger,
                                                                const DeviceConfig& config);

}  // namespace isograsp
