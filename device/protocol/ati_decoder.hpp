// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one ATI NETCANOEM sensor out of a log: learns matrix, counts and units from the answers in
// it and turns gages into wrenches in the sensor frame, bias zero. Pure; allocates nothing.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "device/codec/ati_codec.hpp"
#include "device/protocol/learning_counters.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct AtiSample {
  Timestamp stamp{0};  ///< of the frame that completed it
  AtiReading reading;
  Wrench wrench_S;     ///< [N, N m], before zero
  bool valid = false;  ///< no critical status and no saturated gage

  [[nodiscard]] std::string flags() const { return ati_flags(reading); }  ///< words, for logs
  [[nodiscard]] const RawCounts& raw() const noexcept { return reading.gages; }
};

/// Nothing is invented: a reading whose calibration is unknown makes no sample and is counted. A
/// log may hold readings before the answers that tell their calibration, so read it twice:
///   pass 1: AtiDecoder first(base);              push all, then take first.learned();
///   pass 2: AtiDecoder second(base, learned);    push all again, take the samples.
class AtiDecoder : public LearningCounters {
 public:
  /// `known` holds from the beginning until the log says something else.
  explicit AtiDecoder(std::uint8_t base,
                      const std::optional<AtiCalibration>& known = std::nullopt) noexcept
      : base_(base), calibration_(known) {
    if (!known) return;
    counts_ = known->counts;
    units_ = known->units;
  }

  /// A decoder for the second reading of the same log, with what the first one learned.
  [[nodiscard]] AtiDecoder again() const noexcept { return AtiDecoder(base_, learned()); }
  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept { return ati_owns(base_, frame); }
  /// Every command is for one sensor.
  [[nodiscard]] static bool for_all(const BusFrame&) noexcept { return false; }
  /// The sample that this frame completes. Frames in the order of the log, requests included.
  /// @pre owns(frame)
  [[nodiscard]] std::optional<AtiSample> push(const BusFrame& frame, Timestamp stamp) noexcept;
  /// Nothing more will come: half a reading is torn.
  void finish() noexcept { pairing_.ask(); }

  /// The first complete calibration of the log, with the first counts and units that it tells;
  /// those of firmware before 3.7 (1 000 000, N and N m) where it tells none. Nullopt: no usable
  /// one.
  [[nodiscard]] std::optional<AtiCalibration> learned() const noexcept;

  [[nodiscard]] std::uint64_t torn() const noexcept { return pairing_.torn(); }
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return pairing_.duplicate(); }

 private:
  void hear_request(const BusFrame& frame) noexcept;
  [[nodiscard]] std::optional<AtiSample> hear_answer(const BusFrame& frame,
                                                     Timestamp stamp) noexcept;
  void hear_row(const AtiRow& row) noexcept;
  void select(std::uint8_t slot) noexcept;

  std::uint8_t base_;
  AtiPairing pairing_;
  AtiRowAssembly assembly_;
  std::optional<AtiCalibration> calibration_;
  std::optional<std::uint8_t> slot_;  ///< unknown before the log tells it
  bool echo_due_ = false;             ///< a slot was asked for
  bool sees_requests_ = false;        ///< the log holds what the host asked
  std::size_t row_ = 0;               ///< that comes next
  std::array<std::optional<AtiRow>, 6> rows_{};
  std::optional<AtiCounts> counts_;
  std::optional<AtiUnits> units_;
  std::optional<AtiCalibration> first_;
  std::optional<AtiCounts> first_counts_;
  std::optional<AtiUnits> first_units_;
};

}  // namespace isograsp
