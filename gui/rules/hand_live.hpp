// SPDX-License-Identifier: GPL-3.0-or-later
// What a therapist reads of a tracked hand while it works: how well it is seen, why the help holds
// and when it lets go. To look at: what is scored comes from the stored rows. Pure but for what was
// seen last. SI units.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "hand/tracked_hand.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "virtual_hand/assistance.hpp"
#include "virtual_hand/assistance_level.hpp"

namespace isograsp::gui {

/// One digit, and the tie that holds it.
struct DigitLive {
  virtual_hand::DigitState state = virtual_hand::DigitState::free;
  double pull_N = 0.0;
  std::optional<double> share;  ///< of the pull above which it lets go, 0 … 1; nothing: not tied
};

/// A number of the best set of digits beside the limit that it must exceed.
struct CriterionLive {
  double value = 0.0;
  double limit = 0.0;
  [[nodiscard]] bool met() const noexcept { return value > limit; }
};

struct GraspLive {
  std::array<DigitLive, kDigitCount> digits;
  std::optional<double> release_N;  ///< nothing: this placement has no ties
  /// G_min, H_min, H_det; nothing: fewer than two digits touch, or it does not count for this set.
  std::array<std::optional<CriterionLive>, 3> criteria;
  bool feasible = false;
  double tracked_gap_m = 0.0;  ///< from the virtual hand to the tracked one
  virtual_hand::AssistanceLevel level = virtual_hand::AssistanceLevel::off;
  int placement = 0;  ///< from 0
  int fails = 0;      ///< drops in it
  bool eased = false;
  bool let_go_asked = false;
  bool helped = false;
};
/// Nothing: no object is there.
[[nodiscard]] std::optional<GraspLive> grasp_live(const session::HandSnapshot& now) noexcept;

/// How the tracker has sent and seen the hand in the last seconds, from what it counts.
class TrackerWatch {
 public:
  static constexpr double kLength_s = 10.0;

  /// Takes the snapshot if it is a new frame; forgets what is older than the length.
  void add(const session::HandSnapshot& now);
  /// Rows of this hand a second; nothing: not known yet.
  [[nodiscard]] std::optional<double> rate_Hz() const;
  /// Of the rows and of those that did not come: without the hand, in percent; nothing: as above.
  [[nodiscard]] std::optional<double> lost_percent() const;
  /// Times that the hand was lost since the session began.
  [[nodiscard]] int gaps() const noexcept { return gaps_; }

 private:
  struct Row {
    double t_s = 0.0;
    HandCounters count;
  };
  std::deque<Row> rows_;
  bool seen_ = false;
  int gaps_ = 0;
};

}  // namespace isograsp::gui
