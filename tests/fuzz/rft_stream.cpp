// SPDX-License-Identifier: GPL-3.0-or-later
// RFT packets in a stream of bytes, cut anywhere, against a second reader that has all bytes at
// once.
#include "device/codec/rft_stream.hpp"

#include <vector>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

/// What stands in the whole: a packet at the first byte that can begin one, and so on behind it.
struct Whole {
  std::vector<RftPacket> packets;
  std::uint64_t foreign = 0;
  std::uint64_t torn = 0;  ///< runs of bytes that belong to no packet
};

bool is_packet(std::span<const std::uint8_t> bytes) {
  std::uint8_t sum = 0;
  for (std::size_t i = 1; i < 17; ++i) sum = static_cast<std::uint8_t>(sum + bytes[i]);
  return bytes[0] == 0x55 && bytes[17] == sum && bytes[18] == 0xAA;
}

Whole read_whole(std::span<const std::uint8_t> bytes) {
  Whole whole;
  for (bool in_run = false; !bytes.empty();) {
    const bool packet = bytes.size() >= kRftStreamPacket && is_packet(bytes);
    if (!packet && !in_run) ++whole.torn;
    in_run = !packet;
    if (packet && is_rft_command(bytes[1])) {
      RftPacket& found = whole.packets.emplace_back();
      found.command = bytes[1];
      std::copy_n(bytes.begin() + 2, found.content.size(), found.content.begin());
    } else if (packet) {
      ++whole.foreign;
    }
    bytes = bytes.subspan(packet ? kRftStreamPacket : 1);
  }
  return whole;
}

/// Half of the input is packets made of it, so that sums are right now and then.
std::vector<std::uint8_t> take_bytes(fuzz::Numbers& in) {
  std::vector<std::uint8_t> bytes;
  while (!in.empty()) {
    const std::uint8_t what = in.byte();
    if (what % 2 == 0) {
      const auto raw = in.bytes(what / 8U);
      bytes.insert(bytes.end(), raw.begin(), raw.end());
      continue;
    }
    const BusFrame packet = encode_stream_packet(0, in.byte(), in.bytes(15));
    const auto whole = packet.bytes();
    fuzz::require(whole.size() == kRftStreamPacket && is_packet(whole), "a packet has its sum");
    const bool cut = what >= 0xF0;
    bytes.insert(bytes.end(), whole.begin() + (cut ? what % 16 : 0), whole.end());
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const std::size_t piece = 1 + in.byte() % kRftStreamPacket;
  const auto bytes = take_bytes(in);
  const Whole whole = read_whole(bytes);
  RftStream stream;
  std::size_t packets = 0;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    const auto part = std::span(bytes).subspan(at, std::min(piece, bytes.size() - at));
    const auto packet = stream.push(part, Timestamp(at));
    if (!packet) continue;
    fuzz::require(packets < whole.packets.size() &&
                      packet->command == whole.packets[packets].command &&
                      packet->content == whole.packets[packets].content,
                  "the packets are those of the whole");
    fuzz::require(packet->stamp == Timestamp(at), "a packet has the time of its last piece");
    ++packets;
  }
  stream.finish();
  fuzz::require(packets == whole.packets.size(), "no packet is left out");
  fuzz::require(stream.foreign() == whole.foreign, "foreign packets are counted");
  fuzz::require(stream.torn() == whole.torn, "runs of lost bytes are counted");
  return 0;
}
