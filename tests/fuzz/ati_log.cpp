// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of an ATI sensor in any order: every frame is in a sample or is counted, no calibration is
// invented, and what was learned in a first pass serves a second.
#include "device/protocol/ati_decoder.hpp"
#include "tests/fuzz/learning_log.hpp"

using namespace isograsp;

namespace {

constexpr std::uint8_t kBase = kAtiBases[0];
/// Usual lengths by opcode; the request's for odd bytes of the input.
constexpr std::array<std::uint8_t, 16> kAnswer{8, 6, 8, 8, 8, 8, 1, 8, 2, 2, 0, 0, 0, 0, 0, 4};
constexpr std::array<std::uint8_t, 16> kRequest{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0};

BusFrame take_frame(fuzz::Numbers& in) {
  const std::uint8_t opcode = in.byte();
  const auto& lengths = opcode < 0x80 ? kAnswer : kRequest;
  const std::uint32_t id = kBase << 4 | (opcode & 0xF);
  return fuzz::take_frame(in, id, lengths[opcode & 0xF]);
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Numbers in(data, size);
  const auto log = fuzz::take_log(in, take_frame);
  fuzz::require_second_pass_loses_nothing(
      AtiDecoder(kBase), log, [](const BusFrame&) {}, require_round_trip);
  return 0;
}
