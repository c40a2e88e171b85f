// SPDX-License-Identifier: GPL-3.0-or-later
// A fault that an emulated tracker of hands plays, as `--fault` names it: NAME[=DETAIL][@SECONDSs]
// (docs/devices.md has the list).
#pragma once

#include <cstdint>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

struct EmulatedHandFault {
  enum class Kind : std::uint8_t {
    drop,       ///< drop=P: a message is lost with this probability
    malformed,  ///< malformed=P: a message breaks off in its middle with this probability
    silence,    ///< silence[=2s]@5s: nothing is sent
    freeze,     ///< freeze[=2s]@5s: the tracker repeats its last picture
    lose,       ///< lose[=2s]@5s: no hand is seen
    flip,       ///< flip[=2s]@5s: left and right have each other's label
    nan,        ///< nan[=2s]@5s: the tip of the index is no number
    clock,      ///< clock=-3s@5s: the tracker's clock jumps
    // Of a connection over TCP.
    close,  ///< close@5s: all connections are closed
    split   ///< split: every message comes in fragments
  };
  Kind kind = Kind::silence;
  double probability = 0.0;  ///< drop, malformed
  double step_s = 0.0;       ///< clock
  double at_s = 0.0;         ///< since the first client asked for frames
  double duration_s = 0.0;   ///< 0: for ever, or one instant

  [[nodiscard]] bool of_connection() const noexcept { return kind >= Kind::close; }
  [[nodiscard]] bool acts_at(double t_s) const noexcept {
    return t_s >= at_s && (duration_s <= 0.0 || t_s < at_s + duration_s);
  }

  /// Errors name the faults that exist.
  [[nodiscard]] static Result<EmulatedHandFault> parse(std::string_view text);
};

}  // namespace isograsp
