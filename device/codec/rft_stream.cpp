// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/rft_stream.hpp"

#include <algorithm>
#include <cassert>

namespace isograsp {

namespace {

constexpr std::uint8_t kFirstByte = 0x55;
constexpr std::uint8_t kLastByte = 0xAA;
constexpr std::size_t kAround = 3;  // begin, sum, end
constexpr RftIds kNoIds{};          // the field is the same on CAN, whatever the identifiers

std::uint8_t sum_of(std::span<const std::uint8_t> field) noexcept {
  unsigned sum = 0;
  for (const auto byte : field) sum += byte;
  return static_cast<std::uint8_t>(sum & 0xFF);
}

bool is_wrapped(std::span<const std::uint8_t> bytes) noexcept {
  const auto field = bytes.subspan(1, bytes.size() - kAround);
  return bytes.front() == kFirstByte && bytes.back() == kLastByte &&
         bytes[bytes.size() - 2] == sum_of(field);
}

/// The fields of `frames` one after the other, between begin, sum and end.
BusFrame wrap(std::uint32_t peer, std::span<const BusFrame> frames) noexcept {
  BusFrame out;
  out.id = peer;
  std::size_t length = 0;
  out.data[length++] = kFirstByte;
  for (const auto& frame : frames)
    for (const auto byte : frame.bytes()) out.data[length++] = byte;
  out.data[length] = sum_of(std::span(out.data).subspan(1, length - 1));
  out.data[length + 1] = kLastByte;
  out.length = static_cast<std::uint8_t>(length + 2);
  return out;
}

}  // namespace

BusFrame encode_stream_command(std::uint32_t peer, RftCommand command,
                               std::initializer_list<std::uint8_t> parameters) noexcept {
  const BusFrame frame = encode_command(kNoIds, command, parameters);
  return wrap(peer, {&frame, 1});
}

BusFrame encode_stream_packet(std::uint32_t peer, std::uint8_t command,
                              std::span<const std::uint8_t> content) noexcept {
  return wrap(peer, encode_packet(kNoIds, command, content));
}

BusFrame encode_stream_counts(std::uint32_t peer, const RftCounts& counts,
                              RftCommand command) noexcept {
  return wrap(peer, encode_counts(kNoIds, counts, command));
}

std::optional<std::array<std::uint8_t, 8>> decode_stream_command(
    std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != kRftStreamCommand || !is_wrapped(bytes)) return std::nullopt;
  std::array<std::uint8_t, 8> field{};
  std::copy_n(bytes.begin() + 1, field.size(), field.begin());
  return field;
}

bool RftStream::may_be_packet() const noexcept {
  return waiting_[0] == kFirstByte && (count_ < waiting_.size() || is_wrapped(waiting_));
}

void RftStream::skip_byte() noexcept {
  std::copy(waiting_.begin() + 1, waiting_.begin() + static_cast<std::ptrdiff_t>(count_),
            waiting_.begin());
  --count_;
  if (!skipping_) ++torn_;
  skipping_ = true;
}

std::optional<RftPacket> RftStream::push(std::span<const std::uint8_t> bytes,
                                         Timestamp stamp) noexcept {
  if (bytes.size() > kRftStreamPacket) {
    finish();
    ++foreign_;
    return std::nullopt;
  }
  std::optional<RftPacket> packet;
  for (const auto byte : bytes) {
    waiting_[count_++] = byte;
    while (count_ > 0 && !may_be_packet()) skip_byte();
    if (count_ < waiting_.size()) continue;
    count_ = 0;
    skipping_ = false;
    if (!is_rft_command(waiting_[1])) {
      ++foreign_;
      continue;
    }
    assert(!packet);
    packet.emplace();
    packet->command = waiting_[1];
    packet->stamp = stamp;
    std::copy_n(waiting_.begin() + 2, packet->content.size(), packet->content.begin());
  }
  return packet;
}

void RftStream::finish() noexcept {
  if (count_ > 0 && !skipping_) ++torn_;
  count_ = 0;
  skipping_ = false;
}

}  // namespace isograsp
