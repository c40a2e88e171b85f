// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/cameras/ only. From the cameras' own numbers and stamps to places in a strict grid
// and times of our clock.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/time.hpp"

namespace isograsp {

/// Where a picture belongs.
struct PlacedPicture {
  std::int64_t number = 0;  ///< increases strictly
  Timestamp stamp{0};       ///< increases strictly
  std::uint64_t lost = 0;   ///< places before it that stay empty
};

/// Numbers go on as the cameras count: rate and gaps are exact whatever the network does. Where
/// their count cannot be believed - they began anew, or another measurement - it is the time that
/// has passed. Real-time safe.
class PictureGrid {
 public:
  void begin(double period_s) noexcept;
  /// Nothing: the picture is one that was there already, or comes behind a later one.
  /// `camera_s`: when the cameras say that it was taken, on their own clock.
  [[nodiscard]] std::optional<PlacedPicture> place(std::int64_t frame, double camera_s,
                                                   Timestamp arrival) noexcept;
  /// From stamp to arrival, beyond the smallest so far [s]; nothing before the first picture.
  [[nodiscard]] std::optional<double> jitter_s() const noexcept { return jitter_s_; }

 private:
  [[nodiscard]] Timestamp taken(double camera_s, Timestamp arrival, bool other_clock) noexcept;

  double period_s_ = 0.01;
  bool first_ = true;
  std::int64_t frame_ = 0;  ///< the last one
  std::int64_t number_ = 0;
  Timestamp arrival_{0};
  Timestamp stamp_{0};
  double camera_s_ = 0.0;
  double way_s_ = 0.0;  ///< smallest arrival - camera_s, from the first arrival on
  double late_s_ = 0.0;
  Timestamp origin_{0};
  std::optional<double> jitter_s_;
};

/// The period of cameras that do not tell their rate, from frames that were seen: (last stamp -
/// first stamp) / (last number - first number), a whole number of pictures a second where that is
/// within a thousandth. Nothing: there are fewer than two, or they do not increase.
class PeriodEstimate {
 public:
  void add(std::int64_t frame, double camera_s);
  [[nodiscard]] std::int64_t frames() const noexcept { return last_frame_ - first_frame_; }
  [[nodiscard]] std::optional<double> period_s() const;

 private:
  bool any_ = false;
  std::int64_t first_frame_ = 0, last_frame_ = 0;
  double first_s_ = 0.0, last_s_ = 0.0;
};

}  // namespace isograsp
