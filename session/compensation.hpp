// SPDX-License-Identifier: GPL-3.0-or-later
// Watches for what makes a trial worthless while it runs: arm or trunk push the platform, fingers
// slide on their supports or on the virtual object. Reads snapshots, for display to the therapist;
// deterministic, no clock.
#pragma once

#include <array>
#include <optional>

#include "session/platform/snapshot.hpp"

namespace isograsp::session {

/// A finger that lies this far from where it was strapped has moved: it is to be seated anew.
inline constexpr double kRemarkablePadShift_m = 0.005;

class Compensation {
 public:
  /// The hand was strapped just now: where each finger presses from here on is its place.
  void strapped() noexcept;
  /// Takes a snapshot if it is a new frame.
  void add(const Snapshot& snapshot) noexcept;

  /// Net push in % of the grip, averaged over the last second or so; nothing: no grip.
  [[nodiscard]] std::optional<double> push_percent() const noexcept { return push_percent_; }
  /// How far the finger presses from where it first did, both averaged over half a second of
  /// pressing [m]; nothing: it has not pressed long enough since it was strapped.
  [[nodiscard]] std::optional<double> pad_shift_m(Finger finger) const noexcept;
  /// The finger slips on the virtual object, or did within the last two seconds.
  [[nodiscard]] bool slips(Finger finger) const noexcept {
    const auto& until_s = slip_seen_until_s_[index_of(finger)];
    return newest_s_ && until_s && *newest_s_ < *until_s;
  }

 private:
  struct Pad {
    double seen_s = 0.0;                              ///< of pressing
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< average of the first half second [m]
    Eigen::Vector2d now = Eigen::Vector2d::Zero();    ///< running average [m]
  };
  std::array<Pad, kFingerCount> pads_{};
  std::array<std::optional<double>, kFingerCount> slip_seen_until_s_{};  ///< session time
  std::optional<double> push_percent_;
  std::optional<double> newest_s_;  ///< session time of the newest snapshot; nothing: none yet
};

}  // namespace isograsp::session
