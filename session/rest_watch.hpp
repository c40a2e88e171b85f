// SPDX-License-Identifier: GPL-3.0-or-later
// After a fault of the device a trial goes on only from rest: the hand lets go, and the forces look
// as they did at rest before. A sensor whose zero has moved in the fault never does; then the trial
// is repeated after a new zero. Deterministic, no clock.
#pragma once

#include <optional>

#include "session/platform/snapshot.hpp"

namespace isograsp::session {

/// Largest force that counts as rest, from what the finger pressed at rest [N]: the same as the
/// largest contact threshold.
inline constexpr double kRestBand_N = 0.8;

class RestWatch {
 public:
  /// What the fingers pressed at rest in this session; nothing: they are compared with zero.
  void begin(const std::optional<FingerWrenches>& resting_C) noexcept;
  /// Takes a snapshot if it is a new frame.
  void add(const Snapshot& snapshot) noexcept;
  /// The same of one of two platforms.
  void add(double session_time_s, const FingerFrame& forces) noexcept;
  /// For half a second no finger was out of the band or without a value, and snapshots came at
  /// least every 0.1 s.
  [[nodiscard]] bool at_rest() const noexcept;

 private:
  FingerWrenches rest_C_{};
  double last_s_ = -1.0;           ///< session time of the newest snapshot
  std::optional<double> since_s_;  ///< at rest since
};

}  // namespace isograsp::session
