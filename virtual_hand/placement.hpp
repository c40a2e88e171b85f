// SPDX-License-Identifier: GPL-3.0-or-later
// A placement: an object is brought to a target, held there for a second and let go (Delrieu et
// al., task and measures; thresholds and what counts as a drop: docs/virtual_hand.md). Pure. SI
// units.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/spatial.hpp"

namespace isograsp::virtual_hand {

/// A row in which the hand was seen. Others are none: while it is lost the clock of a placement
/// stands still, so that no loss is a drop and none is held against the person.
struct PlacementRow {
  double t_s = 0.0;
  bool held = false;       ///< a digit is tied to it, or two touch it
  bool supported = false;  ///< it is less than 5 mm above table or support
  Pose X_WO;               ///< of the object
  Pose X_WT;               ///< of the target
};

struct PlacementRule {
  double distance_m = 0.010;
  double angle_rad = 0.2617993877991494;  ///< 15 degrees, between the main axes
  double stays_within = 1.5;              ///< times both, once it is there
  double hold_s = 1.0;
  double dropped_s = 0.25;  ///< not held for so long, or fallen on something before: a drop
};

/// One placement row by row: the rule of a running session and of its score. Real-time safe.
class PlacementWatch {
 public:
  explicit PlacementWatch(const PlacementRule& rule = {}) noexcept : rule_(rule) {}

  /// The next row, in the order of time, until it is done(). True: the object was dropped now.
  bool add(const PlacementRow& row) noexcept;
  /// Since when it has been at the target; nothing: it is not there.
  [[nodiscard]] std::optional<double> there_since_s() const noexcept { return there_s_; }
  [[nodiscard]] bool done() const noexcept { return done_; }
  [[nodiscard]] int drops() const noexcept { return drops_; }
  /// 0 … 1, of the time that it is to be held there.
  [[nodiscard]] double hold_fraction(double t_s) const noexcept;

 private:
  [[nodiscard]] bool within(const PlacementRow& row, double times) const noexcept;
  bool watch_drop(const PlacementRow& row) noexcept;

  PlacementRule rule_;
  std::optional<double> there_s_;
  bool done_ = false;
  int drops_ = 0;
  bool was_held_ = false;
  std::optional<double> let_go_s_;
};

/// Frames of one placement, and how many of them were without the hand.
class LostShare {
 public:
  /// Of its frames: with more of them lost a placement is not scored, and repeated.
  static constexpr double kMost = 0.1;

  LostShare() = default;
  LostShare(std::int64_t frames, std::int64_t lost) noexcept : frames_(frames), lost_(lost) {}

  void begin() noexcept { frames_ = lost_ = 0; }
  void add(bool lost) noexcept {
    ++frames_;
    lost_ += lost ? 1 : 0;
  }
  /// 0 … 1; of no frame 1.
  [[nodiscard]] double share() const noexcept {
    return frames_ == 0 ? 1.0 : static_cast<double>(lost_) / static_cast<double>(frames_);
  }
  [[nodiscard]] bool can_be_scored() const noexcept { return share() <= kMost; }

 private:
  std::int64_t frames_ = 0;
  std::int64_t lost_ = 0;
};

/// Times from the first row; what an unfinished placement has not is nothing.
struct PlacementScore {
  bool completed = false;
  int fails = 0;                         ///< drops
  std::optional<double> manipulation_s;  ///< until the hold that was completed began
  std::optional<double> done_s;
  std::optional<double> hold_distance_m;  ///< means over that hold, weighted with time
  std::optional<double> hold_axis_angle_rad;
  std::optional<double> hold_geodesic_rad;
};

/// Angle between the main axes (z) of two attitudes; an axis has no direction [rad].
[[nodiscard]] double main_axis_angle(const Quat& a, const Quat& b) noexcept;

/// @pre rows in the order of time
[[nodiscard]] PlacementScore score_placement(std::span<const PlacementRow> rows,
                                             const PlacementRule& rule = {});

}  // namespace isograsp::virtual_hand
