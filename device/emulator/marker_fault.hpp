// SPDX-License-Identifier: GPL-3.0-or-later
// A fault that emulated cameras play, as `--fault` names it: NAME[=DETAIL…][@SECONDSs]
// (docs/devices.md has the list).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.hpp"

namespace isograsp {

struct EmulatedMarkerFault {
  enum class Kind : std::uint8_t {
    drop,     ///< drop=P: a picture is lost with this probability
    swap,     ///< swap=A:B[:2s]@5s: two markers have each other's label
    freeze,   ///< freeze=A:2s@5s: a marker repeats its last position
    phantom,  ///< phantom=A:2s@5s: a reflection beside a marker is taken for it
    hide,     ///< hide=A:2s@5s: a marker is not seen
    rename,   ///< rename=A:B@5s: the cameras call A B when they are asked again
    silence,  ///< silence[=2s]@5s: nothing is sent, and the cameras count on
    restart,  ///< restart@5s: numbers and times begin anew
    // Of a connection over TCP.
    close,  ///< close@5s: all connections are closed
    split,  ///< split: every byte is sent alone
    merge   ///< merge=N: N pictures are sent at once
  };
  Kind kind = Kind::silence;
  std::string marker;        ///< whose
  std::string other;         ///< swap: with whom; rename: its new name
  double probability = 0.0;  ///< drop
  int count = 1;             ///< merge
  double at_s = 0.0;         ///< since the first client asked for pictures
  double duration_s = 0.0;   ///< 0: for ever, or one instant

  [[nodiscard]] bool of_connection() const noexcept { return kind >= Kind::close; }
  [[nodiscard]] bool acts_at(double t_s) const noexcept {
    return t_s >= at_s && (duration_s <= 0.0 || t_s < at_s + duration_s);
  }

  /// Errors name the faults that exist.
  [[nodiscard]] static Result<EmulatedMarkerFault> parse(std::string_view text);
};

}  // namespace isograsp
