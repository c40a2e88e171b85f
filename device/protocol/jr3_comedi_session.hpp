// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one sensor of a JR3 PCI card: serial number and full scales, then one
// question per sample.
#pragma once

#include <optional>
#include <string>

#include "device/codec/jr3_comedi_codec.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

/// A sensor that is not ready gives no samples. After 100 ms without samples it is identified
/// again, because the driver may have found another sensor; the driver needs about ten seconds to
/// begin.
class Jr3ComediSession final : public SensorSession {
 public:
  /// @pre config.sensors[finger] is reached as a Jr3ComediSensor, config.rate_Hz > 0 and
  /// jr3_comedi_filter(config.filter_Hz) exists
  Jr3ComediSession(const DeviceConfig& config, std::size_t finger);

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override;
  [[nodiscard]] Vec6 units_per_count() const noexcept override;
  /// The maker's rule for these filters: one over the cut-off.
  [[nodiscard]] double sensor_delay_s() const noexcept override;

 private:
  [[nodiscard]] int steps() const noexcept override { return 1; }
  [[nodiscard]] std::optional<Question> question(int step) const noexcept override;
  [[nodiscard]] Heard hear(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                           Measurement& out) noexcept override;
  [[nodiscard]] std::optional<BusFrame> start(Timestamp now) noexcept override;
  [[nodiscard]] std::optional<BusFrame> pace(Timestamp now) noexcept override;
  [[nodiscard]] Timestamp pace_due() const noexcept override;
  [[nodiscard]] Text refusal() const override;
  [[nodiscard]] Text no_answer_remedy() const override;

  [[nodiscard]] Heard hear_identity(const Jr3ComediIdentity& identity) noexcept;
  [[nodiscard]] BusFrame ask(Jr3ComediQuestion::Kind kind) const noexcept;

  std::uint32_t sensor_;
  std::uint8_t subdevice_;
  std::uint8_t filter_;
  double filter_Hz_;
  Vec6 full_scale_ = Vec6::Zero();
  std::optional<Timestamp> next_poll_;  ///< on one grid, also when the sensor is identified again
  bool awaits_ = false;
};

}  // namespace isograsp
