// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/jr3_decoder.hpp"

namespace isograsp {

std::optional<Jr3Sample> Jr3Decoder::push(const BusFrame& frame, Timestamp stamp) noexcept {
  const Jr3Opcode opcode = jr3_opcode(frame);
  switch (jr3_word(frame)) {
    case Jr3Word::foreign: ++foreign_; return std::nullopt;
    case Jr3Word::request:
      ++requests_;
      sees_requests_ = true;
      due_.reset();
      if (opcode == Jr3Opcode::force_scales || opcode == Jr3Opcode::moment_scales) due_ = opcode;
      return std::nullopt;
    case Jr3Word::answer: break;
  }
  if (opcode != Jr3Opcode::force && opcode != Jr3Opcode::moment) {
    ++answers_;
    if (opcode == Jr3Opcode::boot_up) pairing_.forget();
    if (opcode == Jr3Opcode::acknowledge)
      if (const auto scales = jr3_acknowledge_of(frame).scales) hear_scales(*scales);
    return std::nullopt;
  }
  const auto paired = pairing_.push(frame, stamp);
  if (!paired) return std::nullopt;
  const Jr3Calibration calibration{force_N_.value_or(Jr3Scales{}),
                                   moment_dNm_.value_or(Jr3Scales{})};
  if (!calibration.usable()) {
    ++uncalibrated_;
    return std::nullopt;
  }
  return Jr3Sample{paired->stamp, paired->reading, wrench_of(paired->reading, calibration),
                   !paired->reading.saturated()};
}

void Jr3Decoder::hear_scales(const Jr3Scales& scales) noexcept {
  // An answer does not say whose scales it holds. Without requests in the log they come in turn,
  // force first.
  if (!sees_requests_ && !due_) due_ = Jr3Opcode::force_scales;
  if (!due_) return;
  const bool force = *due_ == Jr3Opcode::force_scales;
  (force ? force_N_ : moment_dNm_) = scales;
  auto& first = force ? first_force_N_ : first_moment_dNm_;
  if (!first) first = scales;
  due_.reset();
  if (!sees_requests_ && force) due_ = Jr3Opcode::moment_scales;
}

std::optional<Jr3Calibration> Jr3Decoder::learned() const noexcept {
  if (!first_force_N_ || !first_moment_dNm_) return std::nullopt;
  const Jr3Calibration learned{*first_force_N_, *first_moment_dNm_};
  if (!learned.usable()) return std::nullopt;
  return learned;
}

}  // namespace isograsp
