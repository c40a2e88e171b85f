// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one Net F/T box or Ethernet Axia: stop, one record to see that it answers,
// start. The box then sends by itself; every record has two numbers. Its software bias is not used:
// this program keeps the zero.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "device/codec/net_ft_box_config.hpp"
#include "device/codec/net_ft_codec.hpp"
#include "device/codec/net_ft_sequence.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

class NetFtSession final : public SensorSession {
 public:
  /// `box` is what the box said about itself.
  /// @pre config.sensors[finger] is reached as a NetFtSensor
  NetFtSession(const DeviceConfig& config, std::size_t finger, NetFtBoxConfig box);

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override {
    return frame.id == finger_;
  }
  [[nodiscard]] std::optional<BusFrame> stop_frame() const noexcept override;
  [[nodiscard]] Vec6 units_per_count() const noexcept override;
  /// That of a first-order low-pass with the cut-off of the box; 0 for an Axia: not known.
  [[nodiscard]] double sensor_delay_s() const noexcept override;

 private:
  [[nodiscard]] int steps() const noexcept override;
  [[nodiscard]] std::optional<Question> question(int step) const noexcept override;
  [[nodiscard]] Heard hear(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                           Measurement& out) noexcept override;
  [[nodiscard]] std::optional<BusFrame> start(Timestamp now) noexcept override;
  [[nodiscard]] Text no_answer_remedy() const override {
    return "check its power, its cable and its address"_text;
  }
  void reset_protocol_counters() noexcept override;
  [[nodiscard]] SessionCounters protocol_counters() const noexcept override;

  std::uint32_t finger_;
  NetFtBoxConfig box_;
  NetFtSequence sequence_;
};

}  // namespace isograsp
