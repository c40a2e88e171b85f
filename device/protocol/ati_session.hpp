// SPDX-License-Identifier: GPL-3.0-or-later
// The conversation with one ATI NETCANOEM sensor: select the calibration, read serial number,
// matrix, counts and units, then ask for every sample. One question is under way at a time.
#pragma once

#include <optional>
#include <string>

#include "device/codec/ati_codec.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

/// An answer must come within 5 ms. After one that did not, the calibration is selected again
/// before the next question. Its echo comes after everything older, so that no late answer is taken
/// for a new one, and a board that was reset in between has the right calibration again. What comes
/// late is dropped and counted.
///
/// The board tells a reset by its watchdog bit, or by a bad calibration if its first slot holds
/// none; it is set up again then, as after 100 ms of silence.
class AtiSession final : public SensorSession {
 public:
  /// @pre config.sensors[finger] is reached as an AtiSensor and config.rate_Hz > 0
  AtiSession(const DeviceConfig& config, std::size_t finger);

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override;
  /// Zero: each axis mixes all gages.
  [[nodiscard]] Vec6 units_per_count() const noexcept override { return Vec6::Zero(); }
  /// As the board told it; firmware before 3.7 tells no counts (they are 1 000 000) and no units:
  /// N and N m are assumed.
  [[nodiscard]] const AtiCalibration& calibration() const noexcept { return calibration_; }
  [[nodiscard]] const AtiFirmware& firmware() const noexcept { return firmware_; }

 private:
  enum class Awaits : std::uint8_t { nothing, reading, echo };
  enum class Objection : std::uint8_t { none, slot, unusable, status };

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
  [[nodiscard]] Text no_answer_remedy() const override;

  [[nodiscard]] Heard hear_answer(std::optional<int> step, const BusFrame& frame, Timestamp stamp,
                                  Measurement& out) noexcept;
  [[nodiscard]] Heard hear_slot(std::optional<int> step, std::uint8_t slot) noexcept;
  [[nodiscard]] Heard hear_first_reading(const AtiReading& reading) noexcept;
  [[nodiscard]] Heard hear_reading(const AtiReading& reading, Timestamp stamp,
                                   Measurement& out) noexcept;
  /// Samples whose time has come since the last call; moves on to the next one.
  [[nodiscard]] std::uint64_t pass_slots(Timestamp now) noexcept;
  [[nodiscard]] BusFrame select() const noexcept;

  std::uint8_t base_;
  std::uint8_t slot_;
  AtiPairing pairing_;
  AtiRowAssembly assembly_;
  AtiCalibration calibration_;
  AtiFirmware firmware_;
  bool watchdog_ = false;  ///< the bit was set already when the board was set up
  Awaits awaits_ = Awaits::nothing;
  Timestamp deadline_{0};               ///< of what is awaited
  std::optional<Timestamp> next_poll_;  ///< on one grid, also through a new set-up
  Objection objection_ = Objection::none;
  std::uint8_t other_slot_ = 0;
};

}  // namespace isograsp
