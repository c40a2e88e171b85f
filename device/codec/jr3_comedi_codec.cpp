// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/jr3_comedi_codec.hpp"

#include <algorithm>
#include <bit>

namespace isograsp {

namespace {

constexpr std::array<double, 7> kCardFilters_Hz{0.0,    500.0,    125.0,     31.25,
                                                7.8125, 1.953125, 0.48828125};
constexpr std::int32_t kZero = 0x4000;
constexpr double kCardFullScale = 16384.0;  // counts

// The first byte of a frame, and its length.
constexpr std::uint8_t kSamples = 0;
constexpr std::uint8_t kIdentity = 1;
constexpr std::uint8_t kQuestionLength = 3;
constexpr std::uint8_t kSamplesLength = 1 + 6 * 2;
constexpr std::uint8_t kIdentityLength = 1 + 4 + 6 * 8;

void put_card_bytes(BusFrame& frame, std::size_t at, std::uint64_t value,
                    std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; ++i)
    frame.data[at + i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFF);
}

std::uint64_t get_card_bytes(const BusFrame& frame, std::size_t at, std::size_t bytes) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    value |= static_cast<std::uint64_t>(frame.data[at + i]) << (8 * i);
  return value;
}

BusFrame frame_of(std::uint32_t sensor, std::uint8_t kind, std::uint8_t length) noexcept {
  BusFrame frame;
  frame.id = sensor;
  frame.length = length;
  frame.data[0] = kind;
  return frame;
}

}  // namespace

std::optional<std::uint8_t> jr3_comedi_filter(double cutoff_Hz) noexcept {
  const auto found = std::find(kCardFilters_Hz.begin(), kCardFilters_Hz.end(), cutoff_Hz);
  if (found == kCardFilters_Hz.end()) return std::nullopt;
  return static_cast<std::uint8_t>(found - kCardFilters_Hz.begin());
}

RawCounts jr3_comedi_counts(const Jr3ComediSamples& samples) noexcept {
  RawCounts counts;
  for (std::size_t axis = 0; axis < samples.size(); ++axis) counts[axis] = samples[axis] - kZero;
  return counts;
}

bool jr3_comedi_saturated(const Jr3ComediSamples& samples) noexcept {
  return std::any_of(samples.begin(), samples.end(), [](std::uint16_t sample) {
    return sample == 0 || sample >= kJr3HighestSample;
  });
}

Wrench wrench_of(const Jr3ComediSamples& samples, const Vec6& full_scale) noexcept {
  const RawCounts counts = jr3_comedi_counts(samples);
  Wrench wrench;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    wrench.force[axis] = counts[i] * full_scale[axis] / kCardFullScale;
    wrench.torque[axis] = counts[i + 3] * full_scale[axis + 3] / kCardFullScale;
  }
  return wrench;
}

BusFrame jr3_comedi_frame(std::uint32_t sensor, const Jr3ComediQuestion& question) noexcept {
  const bool samples = question.kind == Jr3ComediQuestion::Kind::samples;
  BusFrame frame = frame_of(sensor, samples ? kSamples : kIdentity, kQuestionLength);
  frame.data[1] = question.subdevice;
  frame.data[2] = question.filter;
  return frame;
}

std::optional<Jr3ComediQuestion> jr3_comedi_question(const BusFrame& frame) noexcept {
  if (frame.length != kQuestionLength || frame.data[0] > kIdentity) return std::nullopt;
  return Jr3ComediQuestion{frame.data[0] == kSamples ? Jr3ComediQuestion::Kind::samples
                                                     : Jr3ComediQuestion::Kind::identity,
                           frame.data[1], frame.data[2]};
}

BusFrame jr3_comedi_frame(std::uint32_t sensor, const Jr3ComediSamples& samples) noexcept {
  BusFrame frame = frame_of(sensor, kSamples, kSamplesLength);
  for (std::size_t i = 0; i < samples.size(); ++i) put_card_bytes(frame, 1 + 2 * i, samples[i], 2);
  return frame;
}

std::optional<Jr3ComediSamples> jr3_comedi_samples(const BusFrame& frame) noexcept {
  if (frame.length != kSamplesLength || frame.data[0] != kSamples) return std::nullopt;
  Jr3ComediSamples samples;
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::uint16_t>(get_card_bytes(frame, 1 + 2 * i, 2));
  return samples;
}

BusFrame jr3_comedi_frame(std::uint32_t sensor, const Jr3ComediIdentity& identity) noexcept {
  BusFrame frame = frame_of(sensor, kIdentity, kIdentityLength);
  put_card_bytes(frame, 1, identity.serial_number, 4);
  for (std::size_t i = 0; i < 6; ++i)
    put_card_bytes(frame, 5 + 8 * i,
                   std::bit_cast<std::uint64_t>(identity.full_scale[static_cast<Eigen::Index>(i)]),
                   8);
  return frame;
}

std::optional<Jr3ComediIdentity> jr3_comedi_identity(const BusFrame& frame) noexcept {
  if (frame.length != kIdentityLength || frame.data[0] != kIdentity) return std::nullopt;
  Jr3ComediIdentity identity;
  identity.serial_number = static_cast<std::uint32_t>(get_card_bytes(frame, 1, 4));
  for (std::size_t i = 0; i < 6; ++i)
    identity.full_scale[static_cast<Eigen::Index>(i)] =
        std::bit_cast<double>(get_card_bytes(frame, 5 + 8 * i, 8));
  return identity;
}

}  // namespace isograsp
