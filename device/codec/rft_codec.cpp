// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/rft_codec.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp {

namespace {

constexpr Timestamp kLongestRftPair = std::chrono::milliseconds(2);

// Index is the code.
constexpr std::array<double, 9> kRftRates_Hz{200, 10, 20, 50, 100, 200, 333, 500, 1000};
constexpr std::array<double, 15> kRftFilters_Hz{0,  500, 300, 200, 150, 100, 50, 40,
                                                30, 20,  10,  5,   3,   2,   1};

std::uint8_t high_byte(std::int32_t value) noexcept {
  return static_cast<std::uint8_t>((static_cast<std::uint32_t>(value) >> 8) & 0xFF);
}
std::uint8_t low_byte(std::int32_t value) noexcept {
  return static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) & 0xFF);
}

BusFrame frame_of(std::uint8_t id) noexcept {
  BusFrame frame;
  frame.id = id;
  frame.length = 8;
  return frame;
}

}  // namespace

bool is_rft_command(std::uint8_t number) noexcept {
  return number >= 0x01 && number <= 0x12 && number != 0x0D && number != 0x0E;
}

bool RftPacket::is_data() const noexcept {
  return command == static_cast<std::uint8_t>(RftCommand::start) ||
         command == static_cast<std::uint8_t>(RftCommand::read_once);
}

BusFrame encode_command(const RftIds& ids, RftCommand command,
                        std::initializer_list<std::uint8_t> parameters) noexcept {
  assert(parameters.size() <= 7);
  BusFrame frame = frame_of(ids.command);
  frame.data[0] = static_cast<std::uint8_t>(command);
  std::copy(parameters.begin(), parameters.end(), frame.data.begin() + 1);
  return frame;
}

std::array<BusFrame, 2> encode_packet(const RftIds& ids, std::uint8_t command,
                                      std::span<const std::uint8_t> content) noexcept {
  assert(content.size() <= 15);
  std::array<BusFrame, 2> frames{frame_of(ids.first), frame_of(ids.second)};
  frames[0].data[0] = command;
  for (std::size_t i = 0; i < content.size(); ++i)
    frames[(i + 1) / 8].data[(i + 1) % 8] = content[i];
  return frames;
}

std::array<std::uint8_t, 13> content_of(const RftCounts& counts) noexcept {
  std::array<std::uint8_t, 13> content{};
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const std::int32_t value = counts.raw[axis];
    assert(value >= INT16_MIN && value <= INT16_MAX);
    content[2 * axis] = high_byte(value);
    content[2 * axis + 1] = low_byte(value);
  }
  content[12] = counts.overload;
  return content;
}

std::array<BusFrame, 2> encode_counts(const RftIds& ids, const RftCounts& counts,
                                      RftCommand command) noexcept {
  return encode_packet(ids, static_cast<std::uint8_t>(command), content_of(counts));
}

RftCounts decode_counts(const RftPacket& packet) noexcept {
  assert(packet.is_data());
  RftCounts counts;
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const auto word =
        static_cast<std::uint16_t>(packet.content[2 * axis] << 8 | packet.content[2 * axis + 1]);
    counts.raw[axis] = static_cast<std::int16_t>(word);
  }
  constexpr std::uint8_t kOverloadBits = 0x3F;
  counts.overload = packet.content[12] & kOverloadBits;
  return counts;
}

Wrench wrench_of(const RftCounts& counts, const RftDivisors& divisors) noexcept {
  Wrench wrench;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    wrench.force[axis] = counts.raw[i] / divisors.force_per_N;
    wrench.torque[axis] = counts.raw[i + 3] / divisors.torque_per_Nm;
  }
  return wrench;
}

bool at_end_of_numbers(const RftCounts& counts) noexcept {
  return std::any_of(counts.raw.begin(), counts.raw.end(),
                     [](std::int32_t v) { return v <= INT16_MIN || v >= INT16_MAX; });
}

std::optional<std::uint8_t> rft_rate_code(double rate_Hz) noexcept {
  // Code 0 also means 200 Hz; the explicit code comes first.
  const auto found = std::find(kRftRates_Hz.begin() + 1, kRftRates_Hz.end(), rate_Hz);
  if (found == kRftRates_Hz.end()) return std::nullopt;
  return static_cast<std::uint8_t>(found - kRftRates_Hz.begin());
}

double rft_rate_Hz(std::uint8_t code) noexcept {
  return code < kRftRates_Hz.size() ? kRftRates_Hz[code] : 0.0;
}

std::optional<std::uint8_t> rft_filter_code(double cutoff_Hz, RftFilterTable table) noexcept {
  const auto found = std::find(kRftFilters_Hz.begin(), kRftFilters_Hz.end(), cutoff_Hz);
  if (found == kRftFilters_Hz.end()) return std::nullopt;
  const auto code = static_cast<std::uint8_t>(found - kRftFilters_Hz.begin());
  if (table == RftFilterTable::manual || code == 0) return code;
  return static_cast<std::uint8_t>(kRftFilters_Hz.size() - code);
}

double rft_filter_Hz(std::uint8_t code) noexcept {
  return code < kRftFilters_Hz.size() ? kRftFilters_Hz[code] : 0.0;
}

bool RftPairing::repeats(const BusFrame& frame, Timestamp stamp) const noexcept {
  return has_last_ && frame == last_ && stamp - last_stamp_ <= kLongestRftPair;
}

std::optional<RftPacket> RftPairing::push(const BusFrame& frame, Timestamp stamp) noexcept {
  const bool first = frame.id == ids_.first;
  if ((!first && frame.id != ids_.second) || frame.length != 8 || frame.extended || frame.remote ||
      frame.error || (first && !is_rft_command(frame.data[0]))) {
    ++foreign_;
    return std::nullopt;
  }
  if (repeats(frame, stamp)) {
    ++duplicate_;
    return std::nullopt;
  }
  const BusFrame before = last_;
  const bool in_time = stamp >= last_stamp_ && stamp - last_stamp_ <= kLongestRftPair;
  const bool was_waiting = waiting_;
  last_ = frame;
  last_stamp_ = stamp;
  has_last_ = true;
  waiting_ = first;
  if (first || !was_waiting || !in_time) {
    if (was_waiting) ++torn_;  // the first frame before
    if (!first) ++torn_;       // this second frame
    return std::nullopt;
  }
  RftPacket packet;
  packet.command = before.data[0];
  packet.stamp = stamp;
  std::copy_n(before.data.begin() + 1, 7, packet.content.begin());
  std::copy_n(frame.data.begin(), 8, packet.content.begin() + 7);
  return packet;
}

void RftPairing::finish() noexcept {
  if (waiting_) ++torn_;
  waiting_ = false;
}

}  // namespace isograsp
