// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. From the tracker's own clock to ours, and to places in its grid.
#pragma once

#include <cstdint>
#include <optional>

#include "core/time.hpp"

namespace isograsp {

struct PlacedHand {
  double t_s = 0.0;         ///< since the first frame; increases strictly from frame to frame
  Timestamp stamp{0};       ///< on our clock; increases strictly from frame to frame
  std::int64_t number = 0;  ///< the same for all messages of one time
  std::uint64_t lost = 0;   ///< frames that are missing before it
  bool stepped = false;     ///< the tracker's clock has jumped
};

/// Times are differences on the tracker's clock as long as it can be believed: it may not run ahead
/// of ours by more than a second, nor back by more than a quarter of one (that is a message which
/// comes late). Else the time that has passed here counts. Real-time safe.
class HandTimes {
 public:
  /// A message further behind than this is of a clock that began anew [s].
  static constexpr double kOverlap_s = 0.25;

  /// Nothing is lost as long as it is not known (0).
  void set_period(double period_s) noexcept { period_s_ = period_s; }
  /// Nothing: the message comes behind a later one.
  [[nodiscard]] std::optional<PlacedHand> place(double tracker_s, Timestamp arrival) noexcept;
  /// From stamp to arrival, beyond the smallest so far [s]; nothing before the first frame.
  [[nodiscard]] std::optional<double> jitter_s() const noexcept { return jitter_s_; }

 private:
  [[nodiscard]] Timestamp seen(double tracker_s, Timestamp arrival, bool other_clock) noexcept;

  double period_s_ = 0.0;
  bool first_ = true;
  PlacedHand last_;
  double tracker_s_ = 0.0;  ///< of the last frame
  double zero_s_ = 0.0;     ///< where the tracker's clock has t_s = 0
  double way_s_ = 0.0;      ///< smallest arrival - tracker_s, from the first arrival on
  double late_s_ = 0.0;
  Timestamp arrival_{0};
  Timestamp origin_{0};
  std::optional<double> jitter_s_;
};

}  // namespace isograsp
