// SPDX-License-Identifier: GPL-3.0-or-later
// A raw log of a CAN bus to samples, offline. Values are in the sensor frames, before zero,
// calibration of the clinic and mounting. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "device/config/device_config.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct DecodedSample {
  std::size_t finger = 0;
  Wrench wrench_S;  ///< [N, N m]
  bool valid = true;
  std::string flags;  ///< words joined by "+": overload_fz, saturated, status_…
  RawCounts raw_counts{};
  bool saturated = false;
  bool overload = false;
};

/// What became of the frames of one sensor.
struct DecodedCounts {
  std::uint64_t samples = 0;
  std::uint64_t torn = 0;
  std::uint64_t duplicate = 0;
  std::uint64_t foreign = 0;
  std::uint64_t uncalibrated = 0;  ///< samples without a scale in the log: nothing is invented
  std::uint64_t answers = 0;
  std::uint64_t commands = 0;
};

class LogDecoder {
 public:
  virtual ~LogDecoder() = default;
  /// Whether the frame belongs to one of the sensors, as command, answer or sample.
  [[nodiscard]] virtual bool owns(const BusFrame& frame) const noexcept = 0;
  /// The sample that this frame completes. Frames in the order of the log. @pre owns(frame)
  [[nodiscard]] virtual std::optional<DecodedSample> push(const BusFrame& frame,
                                                          Timestamp stamp) = 0;
  /// Nothing more will come: half a sample is torn.
  virtual void finish() noexcept = 0;
  [[nodiscard]] virtual DecodedCounts counts(std::size_t finger) const noexcept = 0;
  /// Scales that this decoder found are used from the beginning by the next one; nullptr: there is
  /// nothing to learn from a log of this protocol, one reading is enough.
  [[nodiscard]] virtual std::unique_ptr<LogDecoder> second_reading() const { return nullptr; }
};

/// @pre the protocol is one of CAN
[[nodiscard]] std::unique_ptr<LogDecoder> make_log_decoder(const DeviceConfig& config);

}  // namespace isograsp
