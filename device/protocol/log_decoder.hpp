// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes a raw log into samples, offline; a log of a CAN bus frame by frame. Values are in the
// sensor frames, before zero, calibration of the clinic and mounting. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/frame.hpp"
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
  /// Whether the frame is a command that is meant for all sensors, and belongs to none.
  [[nodiscard]] virtual bool for_all(const BusFrame&) const noexcept { return false; }
  /// The sample that this frame completes. Frames in the order of the log. @pre owns(frame)
  [[nodiscard]] virtual std::optional<DecodedSample> push(const BusFrame& frame,
                                                          Timestamp stamp) = 0;
  /// Nothing more will come: half a sample is torn.
  virtual void finish() noexcept = 0;
  [[nodiscard]] virtual DecodedCounts counts(std::size_t finger) const noexcept = 0;
  /// A decoder that uses the scales found by this one from the beginning of the log; nullptr: a log
  /// of this protocol has nothing to learn from, one reading is enough.
  [[nodiscard]] virtual std::unique_ptr<LogDecoder> second_reading() const { return nullptr; }
};

/// What a log held, by sensor and besides.
struct LogReport {
  std::array<DecodedCounts, kFingerCount> sensors{};
  std::uint64_t commands = 0;  ///< that are meant for all sensors
  std::uint64_t foreign = 0;   ///< frames that none of the sensors sends or hears
};

/// `time_text`: the log's own characters of the frame that completed the sample.
using TakeSample = std::function<void(const std::string& time_text, Timestamp wall_time,
                                      const DecodedSample& sample)>;

/// `example`: a line that such a log could have.
[[nodiscard]] Error empty_log(const std::string& path, const char* example);

}  // namespace isograsp
