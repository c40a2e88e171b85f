// SPDX-License-Identifier: GPL-3.0-or-later
// A fault that the emulator plays, as `--fault` names it: NAME[=FINGER[:DETAIL…]][@SECONDSs]
// (docs/devices.md has the list).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/result.hpp"
#include "hand/finger.hpp"

namespace isograsp {

struct Fault {
  enum class Kind : std::uint8_t {
    // Of single samples, each with a probability.
    lose_first,   ///< lose=FINGER:tx1:P
    lose_second,  ///< lose=FINGER:tx2:P
    lose_across,  ///< lose=FINGER:across:P: the second frame of one sample, the first of the next
    lose_sample,  ///< lose=FINGER:all:P
    swap,         ///< swap=FINGER:P: the frames of a sample in the wrong order
    duplicate,    ///< duplicate=FINGER:P
    delay,        ///< delay=FINGER:P:20ms
    foreign,      ///< foreign=FINGER:P: the same number, but extended or remote
    length,       ///< length=FINGER:P: a frame that is too short
    answer,       ///< answer=FINGER:P: an answer that nobody asked for, after a sample
    // From an instant on, some for a while.
    silence,   ///< silence=FINGER[:2s]@5s
    restart,   ///< dip=FINGER@5s or reboot=FINGER@5s: power off and on
    freeze,    ///< freeze=FINGER:2s@10s: the last sample again and again
    burst,     ///< burst=FINGER:300@5s: so many copies of a frame at once
    drift,     ///< drift=FINGER:0.1[@0s]: newton per second along the sensor's z axis
    saturate,  ///< saturate=FINGER:2s@10s: pressed beyond the range
    // Of the sensor.
    wrong_serial,  ///< wrongserial=FINGER
    // Of the bus: only where the adapter is emulated too.
    warning,   ///< warning@5s
    passive,   ///< passive@5s
    bus_off,   ///< busoff@5s
    overflow,  ///< overflow@5s
    stall,     ///< stall:2s@5s: the adapter takes no frames
    unplug     ///< unplug:1s@5s
  };
  Kind kind = Kind::silence;
  std::array<bool, kFingerCount> fingers{};  ///< whose sensor
  double probability = 0.0;
  double at_s = 0.0;        ///< since the first sensor began to play
  double duration_s = 0.0;  ///< 0: for ever, or one instant
  double amount = 0.0;      ///< burst: frames; drift: N/s; delay: s

  [[nodiscard]] bool of_bus() const noexcept { return kind >= Kind::warning; }
  [[nodiscard]] bool acts_at(double t_s) const noexcept {
    return t_s >= at_s && (duration_s <= 0.0 || t_s < at_s + duration_s);
  }

  /// Errors name the faults that exist.
  [[nodiscard]] static Result<Fault> parse(std::string_view text);
};

}  // namespace isograsp
