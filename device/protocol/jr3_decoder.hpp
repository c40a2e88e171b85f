// SPDX-License-Identifier: GPL-3.0-or-later
// Reads one JR3 sensor out of a log of its CAN adaptor: learns the full scales from the answers in
// it and turns counts into wrenches in the sensor frame. Pure; allocates nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "device/codec/jr3_codec.hpp"
#include "device/protocol/learning_counters.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct Jr3Sample {
  Timestamp stamp{0};  ///< of the frame that completed it
  Jr3Reading reading;
  Wrench wrench_S;     ///< [N, N m], before zero
  bool valid = false;  ///< no axis at the end of its number

  [[nodiscard]] std::string flags() const { return valid ? "" : "saturated"; }  ///< for logs
  [[nodiscard]] const RawCounts& raw() const noexcept { return reading.raw; }
};

/// Nothing is invented: a reading without known full scales makes no sample and is counted. Hosts
/// may ask for the full scales after the start, so read a log twice, as with AtiDecoder.
class Jr3Decoder : public LearningCounters {
 public:
  /// `known` holds from the beginning until the log says something else.
  explicit Jr3Decoder(std::uint8_t node,
                      const std::optional<Jr3Calibration>& known = std::nullopt) noexcept
      : node_(node) {
    if (!known) return;
    force_N_ = known->force_N;
    moment_dNm_ = known->moment_dNm;
  }

  /// A decoder for the second reading of the same log, with what the first one learned.
  [[nodiscard]] Jr3Decoder again() const noexcept { return Jr3Decoder(node_, learned()); }
  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept { return jr3_owns(node_, frame); }
  /// The synchronisation frame belongs to no sensor.
  [[nodiscard]] static bool for_all(const BusFrame& frame) noexcept { return is_jr3_sync(frame); }
  /// The sample that this frame completes. Frames in the order of the log, requests included.
  /// @pre owns(frame)
  [[nodiscard]] std::optional<Jr3Sample> push(const BusFrame& frame, Timestamp stamp) noexcept;
  /// Nothing more will come: half a reading is torn.
  void finish() noexcept { pairing_.forget(); }

  /// The first full scales of the log, if it tells those of force and of moment.
  [[nodiscard]] std::optional<Jr3Calibration> learned() const noexcept;

  [[nodiscard]] std::uint64_t torn() const noexcept { return pairing_.torn(); }
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return pairing_.duplicate(); }

 private:
  void hear_scales(const Jr3Scales& scales) noexcept;

  std::uint8_t node_;
  Jr3Pairing pairing_;
  std::optional<Jr3Scales> force_N_;
  std::optional<Jr3Scales> moment_dNm_;
  std::optional<Jr3Scales> first_force_N_;
  std::optional<Jr3Scales> first_moment_dNm_;
  bool sees_requests_ = false;    ///< the log holds what the host asked
  std::optional<Jr3Opcode> due_;  ///< the full scales that were asked for last
};

}  // namespace isograsp
