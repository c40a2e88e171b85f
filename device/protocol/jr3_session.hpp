// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one JR3 sensor behind the open CAN adaptor: stop, state, full scales, start
// with the low-pass, then one synchronisation frame per sample for all three sensors.
#pragma once

#include <optional>
#include <string>

#include "device/codec/jr3_codec.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

/// The session of the thumb's sensor is the conductor: from its first start on it sends the
/// synchronisation for all, also while its own sensor is being set up again.
///
/// Force and moment are paired by the number of the sensor's frame, and a sample whose number lies
/// behind the newest one is late; one with the same number shows that the sensor stands
/// still. The number says nothing about lost samples or time: the sensor
/// runs at 8 kHz when the adaptor has time and slower when it has not. Samples are made by the
/// synchronisation, so gaps in their stamps count what was lost.
///
/// The adaptor does not tell a serial number.
class Jr3Session final : public SensorSession {
 public:
  /// @pre config.sensors[finger] is reached as a Jr3Sensor, config.rate_Hz > 0 and
  /// jr3_cutoff(config.filter_Hz) exists
  Jr3Session(const DeviceConfig& config, std::size_t finger);

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override;
  [[nodiscard]] std::optional<BusFrame> stop_frame() const noexcept override;
  [[nodiscard]] Vec6 units_per_count() const noexcept override;
  [[nodiscard]] double sensor_delay_s() const noexcept override;
  [[nodiscard]] const Jr3Calibration& calibration() const noexcept { return calibration_; }

 private:
  enum class Objection : std::uint8_t { none, not_ready, scales };

  [[nodiscard]] int steps() const noexcept override;
  [[nodiscard]] std::optional<Question> question(int step) const noexcept override;
  [[nodiscard]] Heard hear(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                           Measurement& out) noexcept override;
  [[nodiscard]] std::optional<BusFrame> start(Timestamp now) noexcept override;
  [[nodiscard]] std::optional<BusFrame> pace(Timestamp now) noexcept override;
  [[nodiscard]] Timestamp pace_due() const noexcept override;
  void forget() noexcept override;
  void reset_protocol_counters() noexcept override;
  [[nodiscard]] SessionCounters protocol_counters() const noexcept override;
  [[nodiscard]] Text refusal() const override;

  [[nodiscard]] Heard hear_acknowledge(std::optional<int> step,
                                       const Jr3Acknowledge& content) noexcept;
  [[nodiscard]] Heard hear_values(const BusFrame& frame, Timestamp stamp,
                                  Measurement& out) noexcept;

  std::uint8_t node_;
  bool conductor_;
  double filter_Hz_;
  std::uint16_t cutoff_cHz_;
  Jr3Pairing pairing_;
  Jr3Calibration calibration_;
  std::optional<std::uint16_t> newest_;  ///< number of the newest sample
  std::optional<Timestamp> next_sync_;
  int not_ready_ = 0;  ///< answers "not initialised" in a row
  Objection objection_ = Objection::none;
};

}  // namespace isograsp
