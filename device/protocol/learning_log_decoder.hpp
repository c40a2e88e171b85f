// SPDX-License-Identifier: GPL-3.0-or-later
// Reads three sensors out of a log of a CAN bus by decoders that learn their scales from it
// (AtiDecoder, Jr3Decoder).
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "device/protocol/log_decoder.hpp"

namespace isograsp {

template <class Sensor>
class LearningLogDecoder final : public LogDecoder {
 public:
  /// Thumb, index, middle.
  explicit LearningLogDecoder(std::vector<Sensor> sensors) : sensors_(std::move(sensors)) {}

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override {
    return std::any_of(sensors_.begin(), sensors_.end(),
                       [&](const Sensor& s) { return s.owns(frame); });
  }
  [[nodiscard]] bool for_all(const BusFrame& frame) const noexcept override {
    return Sensor::for_all(frame);
  }
  [[nodiscard]] std::optional<DecodedSample> push(const BusFrame& frame, Timestamp stamp) override {
    for (std::size_t f = 0; f < sensors_.size(); ++f) {
      if (!sensors_[f].owns(frame)) continue;
      const auto sample = sensors_[f].push(frame, stamp);
      if (!sample) return std::nullopt;
      ++samples_[f];
      DecodedSample decoded{f, sample->wrench_S, sample->valid, sample->flags()};
      decoded.raw_counts = sample->raw();
      decoded.saturated = sample->reading.saturated();
      return decoded;
    }
    return std::nullopt;
  }
  void finish() noexcept override {
    for (auto& sensor : sensors_) sensor.finish();
  }
  [[nodiscard]] DecodedCounts counts(std::size_t f) const noexcept override {
    const Sensor& s = sensors_[f];
    return {samples_[f],      s.torn(),    s.duplicate(), s.foreign(),
            s.uncalibrated(), s.answers(), s.requests()};
  }
  [[nodiscard]] std::unique_ptr<LogDecoder> second_reading() const override {
    std::vector<Sensor> again;
    for (const Sensor& sensor : sensors_) again.push_back(sensor.again());
    return std::make_unique<LearningLogDecoder>(std::move(again));
  }

 private:
  std::vector<Sensor> sensors_;
  std::array<std::uint64_t, kFingerCount> samples_{};
};

}  // namespace isograsp
