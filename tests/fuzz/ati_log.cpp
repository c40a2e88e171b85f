// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of an ATI sensor in any order: every frame is in a sample or is counted, no calibration is
// invented, and what was learned in a first pass serves a second.
#include <vector>

#include "device/protocol/ati_decoder.hpp"
#include "tests/fuzz/frames.hpp"

using namespace isograsp;

namespace {

constexpr std::uint8_t kBase = kAtiBases[0];
/// Usual lengths by opcode; the request's for odd bytes of the input.
constexpr std::array<std::uint8_t, 16> kAnswer{8, 6, 8, 8, 8, 8, 1, 8, 2, 2, 0, 0, 0, 0, 0, 4};
constexpr std::array<std::uint8_t, 16> kRequest{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0};

struct Received {
  BusFrame frame;
  Timestamp stamp;
};

std::vector<Received> take_log(fuzz::Numbers& in) {
  std::vector<Received> log;
  Timestamp now{0};
  while (!in.empty()) {
    now += fuzz::take_pause(in);
    const std::uint8_t opcode = in.byte();
    const auto& lengths = opcode < 0x80 ? kAnswer : kRequest;
    const std::uint32_t id = kBase << 4 | (opcode & 0xF);
    log.push_back({fuzz::take_frame(in, id, lengths[opcode & 0xF]), now});
  }
  return log;
}

void require_round_trip(const AtiReading& reading) {
  AtiPairing pairing;
  const auto frames = ati_reading_frames(kBase, reading);
  (void)pairing.push(frames[0], Timestamp(0));
  const auto again = pairing.push(frames[1], Timestamp(0));
  fuzz::require(again && again->reading == reading, "a reading comes back");
  fuzz::require(ati_flags(reading).empty() == (reading.status == 0 && !reading.saturated()) ||
                    (reading.status & 0x2600) != 0,
                "flags are named");
}

std::uint64_t decode(AtiDecoder& decoder, std::span<const Received> log) {
  std::uint64_t frames = 0;
  std::uint64_t samples = 0;
  for (const auto& [frame, stamp] : log) {
    if (!decoder.owns(frame)) continue;
    ++frames;
    const auto sample = decoder.push(frame, stamp);
    if (!sample) continue;
    ++samples;
    fuzz::require(sample->stamp == stamp, "a sample has the time of its last frame");
    fuzz::require(sample->wrench_S.force.allFinite() && sample->wrench_S.torque.allFinite(),
                  "gages with a usable calibration are newtons");
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
  AtiDecoder first(kBase);
  const std::uint64_t samples = decode(first, log);
  const auto learned = first.learned();
  if (!learned) return 0;
  fuzz::require(learned->usable(), "what was learned can be used");
  AtiDecoder second(kBase, learned);
  fuzz::require(decode(second, log) >= samples, "a second pass loses no sample");
  return 0;
}
