// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzing of decoders that learn the scales of a sensor from its log: every frame is in a sample or
// is counted, no scale is invented, and what was learned in a first pass serves a second.
#pragma once

#include <span>
#include <vector>

#include "tests/fuzz/frames.hpp"

namespace isograsp::fuzz {

struct Received {
  BusFrame frame;
  Timestamp stamp;
};

/// The whole input as a log; `next(in)` takes one frame from it.
template <class Next>
std::vector<Received> take_log(Numbers& in, Next next) {
  std::vector<Received> log;
  Timestamp now{0};
  while (!in.empty()) {
    now += take_pause(in);
    log.push_back({next(in), now});
  }
  return log;
}

/// Reads the log once; how many samples it holds. `look(frame)` sees every frame of the sensor,
/// `look_at(reading)` what a sample was made of.
template <class Decoder, class Look, class LookAt>
std::uint64_t decode(Decoder& decoder, std::span<const Received> log, Look look, LookAt look_at) {
  std::uint64_t frames = 0;
  std::uint64_t samples = 0;
  for (const auto& [frame, stamp] : log) {
    if (!decoder.owns(frame)) continue;
    ++frames;
    look(frame);
    const auto sample = decoder.push(frame, stamp);
    if (!sample) continue;
    ++samples;
    require(sample->stamp == stamp, "a sample has the time of its last frame");
    require(sample->wrench_S.force.allFinite() && sample->wrench_S.torque.allFinite(),
            "what is read with usable scales is newtons");
    look_at(sample->reading);
  }
  decoder.finish();
  require(frames == decoder.foreign() + decoder.requests() + decoder.answers() +
                        2 * (samples + decoder.uncalibrated()) + decoder.torn() +
                        decoder.duplicate(),
          "every frame is in a sample or is counted");
  return samples;
}

/// Reads the log twice, from a decoder that knows nothing.
template <class Decoder, class Look, class LookAt>
void require_second_pass_loses_nothing(Decoder first, std::span<const Received> log, Look look,
                                       LookAt look_at) {
  const std::uint64_t samples = decode(first, log, look, look_at);
  const auto learned = first.learned();
  if (!learned) return;
  require(learned->usable(), "what was learned can be used");
  Decoder second = first.again();
  require(decode(second, log, look, look_at) >= samples, "a second pass loses no sample");
}

}  // namespace isograsp::fuzz
