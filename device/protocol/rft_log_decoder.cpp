// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/rft_log_decoder.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "device/codec/rft_codec.hpp"
#include "device/config/rft_sensor.hpp"

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
      sensors_.push_back(config.sensors[f].as<RftSensor>());
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

}  // namespace

std::unique_ptr<LogDecoder> make_rft_log_decoder(const DeviceConfig& config) {
  return std::make_unique<RftLogDecoder>(config);
}

}  // namespace isograsp
