// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a JR3 adaptor in any order: every frame is in a sample or is counted, no full scale is
// invented, and what was learned in a first pass serves a second.
#include "device/protocol/jr3_decoder.hpp"
#include "tests/fuzz/learning_log.hpp"

using namespace isograsp;

namespace {

constexpr std::uint8_t kNode = kJr3Nodes[1];
/// Usual lengths by opcode / 0x80.
constexpr std::array<std::uint8_t, 16> kLength{0, 0, 7, 2, 6, 0, 0, 2, 0, 0, 0, 0, 8, 8, 0, 4};

BusFrame take_frame(fuzz::Numbers& in) {
  const std::uint8_t opcode = in.byte() & 0xF;
  const std::uint32_t id = static_cast<std::uint32_t>(opcode) << 7 | kNode;
  return fuzz::take_frame(in, id, kLength[opcode]);
}

void require_round_trip(const Jr3Reading& reading) {
  Jr3Pairing pairing;
  const auto frames = jr3_reading_frames(kNode, reading);
  (void)pairing.push(frames[1], Timestamp(0));
  const auto again = pairing.push(frames[0], Timestamp(0));
  fuzz::require(again && again->reading == reading, "a reading comes back");
}

void require_acknowledge_round_trip(const BusFrame& frame) {
  if (jr3_word(frame) != Jr3Word::answer || jr3_opcode(frame) != Jr3Opcode::acknowledge) return;
  const auto content = jr3_acknowledge_of(frame);
  const auto again = jr3_acknowledge_of(jr3_acknowledge(kNode, content));
  fuzz::require(again.ready == content.ready && again.scales == content.scales,
                "an answer comes back");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const auto log = fuzz::take_log(in, take_frame);
  fuzz::require_second_pass_loses_nothing(Jr3Decoder(kNode), log, require_acknowledge_round_trip,
                                          require_round_trip);
  return 0;
}
