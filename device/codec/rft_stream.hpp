// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of Robotous RFT sensors as bytes of a serial line or as datagrams: 55, the same field as
// on CAN (8 bytes of a command, 16 of an answer), the low byte of the field's sum, AA. Pure, no
// allocation. Source: RFT Series Manual 1.82, section 3.5.2.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "device/codec/rft_codec.hpp"

namespace isograsp {

inline constexpr std::size_t kRftStreamCommand = 11;  ///< bytes of a command
inline constexpr std::size_t kRftStreamPacket = 19;   ///< bytes of an answer or of data

/// 11 bytes to sensor number `peer`. At most 7 parameters.
[[nodiscard]] BusFrame encode_stream_command(
    std::uint32_t peer, RftCommand command,
    std::initializer_list<std::uint8_t> parameters = {}) noexcept;
/// 19 bytes from sensor number `peer`. At most 15 bytes of content.
[[nodiscard]] BusFrame encode_stream_packet(std::uint32_t peer, std::uint8_t command,
                                            std::span<const std::uint8_t> content) noexcept;
/// @pre the counts fit 16 bits
[[nodiscard]] BusFrame encode_stream_counts(std::uint32_t peer, const RftCounts& counts,
                                            RftCommand command = RftCommand::start) noexcept;
/// The 8 bytes of the field of a command; nullopt: no command.
[[nodiscard]] std::optional<std::array<std::uint8_t, 8>> decode_stream_command(
    std::span<const std::uint8_t> bytes) noexcept;

/// Finds the packets of one sensor in its bytes. The bytes may come in pieces of any size up to a
/// packet. A packet begins at the first 55 that has the AA and the sum in their places; bytes
/// before it are skipped one by one, since data may contain 55 and AA. A packet is found with its
/// last byte, whatever stands before it.
class RftStream {
 public:
  /// The packet that these bytes complete. At most one: fewer than 19 bytes wait, and a piece
  /// longer than 19 is no piece of this protocol and is dropped whole.
  [[nodiscard]] std::optional<RftPacket> push(std::span<const std::uint8_t> bytes,
                                              Timestamp stamp) noexcept;
  /// Nothing more will come: bytes that still wait are torn.
  void finish() noexcept;

  /// Runs of bytes that belong to no packet: one lost or damaged packet makes one.
  [[nodiscard]] std::uint64_t torn() const noexcept { return torn_; }
  /// Whole packets whose D1 is no command of the manual, and pieces longer than a packet.
  [[nodiscard]] std::uint64_t foreign() const noexcept { return foreign_; }

 private:
  [[nodiscard]] bool may_be_packet() const noexcept;
  void skip_byte() noexcept;

  std::array<std::uint8_t, kRftStreamPacket> waiting_{};
  std::size_t count_ = 0;
  bool skipping_ = false;  ///< the bytes before the waiting ones belong to no packet
  std::uint64_t torn_ = 0;
  std::uint64_t foreign_ = 0;
};

}  // namespace isograsp
