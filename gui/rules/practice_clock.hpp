// SPDX-License-Identifier: GPL-3.0-or-later
// How long an arm has been made familiar with its tasks, and whether that is enough: 15 minutes on
// a first visit, in bouts of 3; later until two movements on end take nearly the same time, four at
// most. To look at: the therapist decides. Pure but for what was seen last.
#pragma once

#include <optional>

#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class PracticeClock {
 public:
  static constexpr double kBout_s = 3.0 * 60.0;
  static constexpr double kSameTime = 0.1;  ///< of the longer of two movements
  static constexpr int kMostMovements = 4;  ///< on later visits

  /// A frame; `practising`: of a trial that is practice. Pauses do not count.
  void add(const session::ArmSnapshot& now, bool practising);

  [[nodiscard]] bool begun() const noexcept { return past_s_ + trial_s_ > 0.0; }
  [[nodiscard]] double total_s() const noexcept { return past_s_ + trial_s_; }
  /// Of the bout that runs, and which one it is, from 1.
  [[nodiscard]] double bout_s() const noexcept;
  [[nodiscard]] int bout() const noexcept;
  [[nodiscard]] int movements() const noexcept { return movements_; }
  /// By how much the last two movements differ, as a share of the longer one; nothing: there were
  /// not two.
  [[nodiscard]] std::optional<double> difference() const noexcept;
  /// Two movements on end took nearly the same time, or there were as many as there may be.
  [[nodiscard]] bool enough_later() const noexcept;

 private:
  int trial_ = 0;
  int target_ = -1;
  double cue_s_ = 0.0;    ///< on the task's clock
  bool matched_ = false;  ///< the target that is shown was reached
  double past_s_ = 0.0;   ///< of the trials before
  double trial_s_ = 0.0;  ///< of the running one
  int movements_ = 0;
  std::optional<double> before_s_;
  std::optional<double> last_s_;
};

}  // namespace isograsp::gui
