// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one Robotous RFT sensor: stop, serial number, filter, rate, bias off,
// start. The sensor then sends by itself; its samples carry no number.
#pragma once

#include <optional>
#include <variant>

#include "device/codec/rft_codec.hpp"
#include "device/codec/rft_stream.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

/// How packets travel: as pairs of CAN frames with these identifiers, or as bytes of a serial line
/// or datagrams of one sensor.
struct RftPeer {
  std::uint32_t number = 0;  ///< BusFrame::id
};
using RftOnBus = std::variant<RftIds, RftPeer>;

class RftSession final : public SensorSession {
 public:
  struct Settings {
    RftOnBus on_bus;
    std::string address;        ///< for people, where the bus has no identifiers
    std::string serial_number;  ///< that the sensor must have; empty: any
    RftDivisors divisors;
    double rate_Hz = 100.0;
    double filter_Hz = 30.0;
    RftFilterTable filter_table = RftFilterTable::manual;
  };
  /// @pre rft_rate_code(rate_Hz) and rft_filter_code(filter_Hz) exist
  explicit RftSession(const Settings& settings);

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override;
  [[nodiscard]] std::optional<BusFrame> stop_frame() const noexcept override;
  [[nodiscard]] Vec6 units_per_count() const noexcept override;
  [[nodiscard]] double sensor_delay_s() const noexcept override;

 private:
  [[nodiscard]] int steps() const noexcept override;
  [[nodiscard]] std::optional<Question> question(int step) const noexcept override;
  [[nodiscard]] Heard hear(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                           Measurement& out) noexcept override;
  [[nodiscard]] std::optional<BusFrame> start(Timestamp now) noexcept override;
  void forget() noexcept override;
  void reset_protocol_counters() noexcept override;
  [[nodiscard]] SessionCounters protocol_counters() const noexcept override;
  [[nodiscard]] Text refusal() const override;
  [[nodiscard]] Text no_answer_remedy() const override;

  [[nodiscard]] BusFrame command(
      RftCommand command, std::initializer_list<std::uint8_t> parameters = {}) const noexcept;
  [[nodiscard]] Heard hear_packet(std::optional<int> step, const RftPacket& packet, Timestamp stamp,
                                  Measurement& out) noexcept;

  RftOnBus on_bus_;
  RftDivisors divisors_;
  double filter_Hz_;
  std::uint8_t rate_code_;
  std::uint8_t filter_code_;
  std::variant<RftPairing, RftStream> frames_;
  bool filter_is_right_ = false;
  bool rate_is_right_ = false;
  std::uint8_t refusal_ = 0;  ///< R2 of the answer that says no
};

}  // namespace isograsp
