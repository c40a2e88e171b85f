// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/log_decoder.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "device/codec/rft_codec.hpp"
#include "device/protocol/ati_decoder.hpp"
#include "device/protocol/jr3_decoder.hpp"

namespace isograsp {

namespace {

constexpr std::array<std::string_view, 6> kAxes{"fx", "fy", "fz", "tx", "ty", "tz"};

void add_word(std::string& words, std::string_view word) {
  if (!words.empty()) words += '+';
  words += word;
}

/// Bit 5 is Fx, bit 0 is Tz.
std::string overload_words(std::uint8_t overload) {
  std::string words;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis)
    if ((overload & (0x20U >> axis)) != 0) add_word(words, "overload_" + std::string(kAxes[axis]));
  return words;
}

class RftLogDecoder final : public LogDecoder {
 public:
  explicit RftLogDecoder(const DeviceConfig& config) {
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      sensors_.push_back(std::get<RftSensor>(config.sensors[f].way));
      pairings_.emplace_back(sensors_[f].ids);
    }
  }
  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override {
    return !frame.error && finger_of(frame).has_value();
  }
  [[nodiscard]] std::optional<DecodedSample> push(const BusFrame& frame, Timestamp stamp) override {
    const std::size_t f = *finger_of(frame);
    if (frame.id == sensors_[f].ids.command) {
      ++(frame.is_standard() ? counts_[f].commands : counts_[f].foreign);
      return std::nullopt;
    }
    const auto packet = pairings_[f].push(frame, stamp);
    if (!packet) return std::nullopt;
    if (!packet->is_data()) {
      ++counts_[f].answers;
      return std::nullopt;
    }
    ++counts_[f].samples;
    const RftCounts counts = decode_counts(*packet);
    DecodedSample sample{f, wrench_of(counts, sensors_[f].divisors), true,
                         overload_words(counts.overload)};
    sample.raw_counts = counts.raw;
    sample.overload = counts.overload != 0;
    return sample;
  }
  void finish() noexcept override {
    for (auto& pairing : pairings_) pairing.finish();
  }
  [[nodiscard]] DecodedCounts counts(std::size_t f) const noexcept override {
    DecodedCounts counts = counts_[f];
    counts.torn = pairings_[f].torn();
    counts.duplicate = pairings_[f].duplicate();
    counts.foreign += pairings_[f].foreign();
    return counts;
  }

 private:
  [[nodiscard]] std::optional<std::size_t> finger_of(const BusFrame& frame) const noexcept {
    for (std::size_t f = 0; f < sensors_.size(); ++f) {
      const RftIds& ids = sensors_[f].ids;
      if (frame.id == ids.command || frame.id == ids.first || frame.id == ids.second) return f;
    }
    return std::nullopt;
  }

  std::vector<RftSensor> sensors_;
  std::vector<RftPairing> pairings_;
  std::array<DecodedCounts, kFingerCount> counts_{};
};

std::string flags_of(const AtiSample& sample) {
  return ati_flags(sample.reading);
}
std::string flags_of(const Jr3Sample& sample) {
  return sample.valid ? "" : "saturated";
}

RawCounts raw_of(const AtiSample& sample) {
  return sample.reading.gages;
}
RawCounts raw_of(const Jr3Sample& sample) {
  return sample.reading.raw;
}

/// Sensors whose decoders learn their scale from the log.
template <class Sensor>
class LearningLogDecoder final : public LogDecoder {
 public:
  explicit LearningLogDecoder(std::vector<Sensor> sensors) : sensors_(std::move(sensors)) {}

  [[nodiscard]] bool owns(const BusFrame& frame) const noexcept override {
    return std::any_of(sensors_.begin(), sensors_.end(),
                       [&](const Sensor& s) { return s.owns(frame); });
  }
  [[nodiscard]] std::optional<DecodedSample> push(const BusFrame& frame, Timestamp stamp) override {
    for (std::size_t f = 0; f < sensors_.size(); ++f) {
      if (!sensors_[f].owns(frame)) continue;
      const auto sample = sensors_[f].push(frame, stamp);
      if (!sample) return std::nullopt;
      ++samples_[f];
      DecodedSample decoded{f, sample->wrench_S, sample->valid, flags_of(*sample)};
      decoded.raw_counts = raw_of(*sample);
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

}  // namespace

std::unique_ptr<LogDecoder> make_log_decoder(const DeviceConfig& config) {
  if (config.protocol == Protocol::ati_netcanoem) {
    std::vector<AtiDecoder> sensors;
    for (const auto& sensor : config.sensors)
      sensors.emplace_back(std::get<AtiSensor>(sensor.way).base);
    return std::make_unique<LearningLogDecoder<AtiDecoder>>(std::move(sensors));
  }
  if (config.protocol == Protocol::jr3_can) {
    std::vector<Jr3Decoder> sensors;
    for (const auto& sensor : config.sensors)
      sensors.emplace_back(std::get<Jr3Sensor>(sensor.way).node);
    return std::make_unique<LearningLogDecoder<Jr3Decoder>>(std::move(sensors));
  }
  return std::make_unique<RftLogDecoder>(config);
}

}  // namespace isograsp
