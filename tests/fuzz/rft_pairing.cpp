// SPDX-License-Identifier: GPL-3.0-or-later
// RFT frames in any order and at any time: every frame is in a packet or is counted, and the counts
// of a packet are what its frames say.
#include "device/codec/rft_codec.hpp"
#include "tests/fuzz/frames.hpp"

using namespace isograsp;

namespace {

void require_round_trip(const RftPacket& packet, const RftIds& ids) {
  const RftCounts counts = decode_counts(packet);
  RftPairing pairing(ids);
  const auto frames = encode_counts(ids, counts, static_cast<RftCommand>(packet.command));
  (void)pairing.push(frames[0], packet.stamp);
  const auto again = pairing.push(frames[1], packet.stamp);
  fuzz::require(again && decode_counts(*again) == counts, "counts come back");
  const Wrench wrench = wrench_of(counts, {});
  fuzz::require(wrench.force.allFinite() && wrench.torque.allFinite(), "counts are newtons");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const RftIds ids = kRftIds[in.byte() % kFingerCount];
  RftPairing pairing(ids);
  Timestamp now{0};
  std::uint64_t frames = 0;
  std::uint64_t packets = 0;
  BusFrame last;
  while (!in.empty()) {
    now += fuzz::take_pause(in);
    const std::uint8_t which = in.byte();
    const std::uint32_t id = which >= 0xFC ? in.byte() : which % 2 == 0 ? ids.first : ids.second;
    const BusFrame frame = fuzz::take_frame(in, id, 8);
    ++frames;
    const std::uint64_t dropped = pairing.foreign() + pairing.duplicate();
    if (const auto packet = pairing.push(frame, now)) {
      ++packets;
      fuzz::require(packet->stamp == now, "a packet has the time of its last frame");
      const auto made = encode_packet(ids, packet->command, packet->content);
      fuzz::require(made[0] == last && made[1] == frame, "a packet is its two frames");
      if (packet->is_data()) require_round_trip(*packet, ids);
    }
    if (pairing.foreign() + pairing.duplicate() == dropped) last = frame;
  }
  pairing.finish();
  fuzz::require(frames == 2 * packets + pairing.torn() + pairing.duplicate() + pairing.foreign(),
                "every frame is in a packet or is counted");
  return 0;
}
