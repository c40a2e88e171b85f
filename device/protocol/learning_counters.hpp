// SPDX-License-Identifier: GPL-3.0-or-later
// Counters of a decoder that learns the scales of its sensor from the log itself. Every frame
// belongs to a sample, or is counted here, or is counted by the pairing as torn or duplicate.
#pragma once

#include <cstdint>

namespace isograsp {

class LearningCounters {
 public:
  /// Frames with the sensor's identifiers that are no words of the protocol.
  [[nodiscard]] std::uint64_t foreign() const noexcept { return foreign_; }
  /// Complete readings whose scales were not known.
  [[nodiscard]] std::uint64_t uncalibrated() const noexcept { return uncalibrated_; }
  [[nodiscard]] std::uint64_t requests() const noexcept { return requests_; }
  /// Frames of the sensor that hold no values.
  [[nodiscard]] std::uint64_t answers() const noexcept { return answers_; }

 protected:
  std::uint64_t foreign_ = 0;
  std::uint64_t uncalibrated_ = 0;
  std::uint64_t requests_ = 0;
  std::uint64_t answers_ = 0;
};

}  // namespace isograsp
