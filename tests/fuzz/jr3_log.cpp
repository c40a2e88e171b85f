// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a JR3 adaptor in any order: every frame is in a sample or is counted, no full scale is
// invented, and what was learned in a first pass serves a second.
#include <vector>

#include "device/protocol/jr3_decoder.hpp"
#include "tests/fuzz/frames.hpp"

using namespace isograsp;

namespace {

constexpr std::uint8_t kNode = kJr3Nodes[1];
/// Usual lengths by opcode / 0x80.
constexpr std::array<std::uint8_t, 16> kLength{0, 0, 7, 2, 6, 0, 0, 2, 0, 0, 0, 0, 8, 8, 0, 4};

struct Received {
  BusFrame frame;
  Timestamp stamp;
};

std::vector<Received> take_log(fuzz::Numbers& in) {
  std::vector<Received> log;
  Timestamp now{0};
  while (!in.empty()) {
    now += fuzz::take_pause(in);
    const std::uint8_t opcode = in.byte() & 0xF;
    const std::uint32_t id = static_cast<std::uint32_t>(opcode) << 7 | kNode;
    log.push_back({fuzz::take_frame(in, id, kLength[opcode]), now});
  }
  return log;
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

std::uint64_t decode(Jr3Decoder& decoder, std::span<const Received> log) {
  std::uint64_t frames = 0;
  std::uint64_t samples = 0;
  for (const auto& [frame, stamp] : log) {
    if (!decoder.owns(frame)) continue;
    ++frames;
    require_acknowledge_round_trip(frame);
    const auto sample = decoder.push(frame, stamp);
    if (!sample) continue;
    ++samples;
    fuzz::require(sample->stamp == stamp, "a sample has the time of its last frame");
    fuzz::require(sample->wrench_S.force.allFinite() && sample->wrench_S.torque.allFinite(),
                  "counts with full scales are newtons");
    require_round_trip(sample->reading);
  }
  decoder.finish();
  fuzz::require(frames == decoder.foreign() + decoder.requests() + decoder.answers() +
                              2 * (samples + decoder.uncalibrated()) + decoder.torn() +
                              decoder.duplicate(),
                "every frame is in a sample or is counted");
  return samples;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const auto log = take_log(in);
  Jr3Decoder first(kNode);
  const std::uint64_t samples = decode(first, log);
  const auto learned = first.learned();
  if (!learned) return 0;
  fuzz::require(learned->usable(), "what was learned can be used");
  Jr3Decoder second(kNode, learned);
  fuzz::require(decode(second, log) >= samples, "a second pass loses no sample");
  return 0;
}
