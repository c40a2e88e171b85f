// SPDX-License-Identifier: GPL-3.0-or-later
// A JR3 sensor behind the open CAN adaptor in software: idle until it is started, then one sample
// for each synchronisation, or on its own clock. Sensor frame.
#pragma once

#include <array>
#include <memory>

#include "device/codec/jr3_codec.hpp"
#include "device/config/device_config.hpp"
#include "device/emulator/emulated_sensor.hpp"

namespace isograsp {

struct EmulatedJr3Settings {
  std::uint8_t node = 1;
  Jr3Calibration calibration{{150, 150, 300}, {80, 80, 80}};  ///< that of the paper's sensors
  double sensor_rate_Hz = 8000.0;  ///< of the sensor's frames, which are numbered
  std::uint16_t first_number = 0;  ///< of the frame at power-up
  bool initialised = true;         ///< false: the adaptor finds no sensor
};

class EmulatedJr3 final : public EmulatedSensor {
 public:
  EmulatedJr3(std::size_t finger, const EmulatedJr3Settings& settings);

  void receive(const BusFrame& frame, Timestamp now, EmulatorWorld& world) override;
  [[nodiscard]] Timestamp next_measurement() const override;
  void measure(EmulatorWorld& world) override;
  void power_dip(Timestamp now, EmulatorWorld& world) override;
  void answer_unasked(Timestamp now, EmulatorWorld& world) override;
  [[nodiscard]] Timestamp play_start() const override { return play_start_; }

 private:
  enum class Mode : std::uint8_t { idle, sync, async };

  void start(Mode mode, Timestamp now, const BusFrame& frame);
  void send(Timestamp now, EmulatorWorld& world);
  [[nodiscard]] RawCounts filter(const Wrench& wrench_S, Timestamp now, const EmulatorWorld& world);

  EmulatedJr3Settings settings_;
  Mode mode_ = Mode::idle;
  double cutoff_Hz_ = 0.0;
  Timestamp powered_{0};  ///< numbers count from here
  Timestamp started_{0};
  double period_s_ = 0.01;  ///< own seconds, async mode
  double clock_factor_ = 1.0;
  double phase_ = 0.0;
  std::int64_t measured_ = 0;         ///< since start
  std::array<double, 6> low_pass_{};  ///< counts
  bool settled_ = false;              ///< low_pass_ holds the value at filtered_
  Timestamp filtered_{0};
  RawCounts zero_{};
  Timestamp play_start_ = Timestamp::max();
};

/// @pre config.sensors[finger] is reached as a Jr3Sensor
[[nodiscard]] std::unique_ptr<EmulatedSensor> make_emulated_jr3(std::size_t finger,
                                                                const DeviceConfig& config);

}  // namespace isograsp
