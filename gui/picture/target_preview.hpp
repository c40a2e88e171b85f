// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a force task before it begins, for the patient's screen: the range of its
// targets, what comes after each part, and as much of the target's future as may be seen. It comes
// from the timeline that the task itself plays, so picture and trial cannot differ.
#pragma once

#include <optional>
#include <vector>

#include "tasks/task.hpp"

namespace isograsp::gui {

/// The force axis of a picture: the targets of the whole trial and zero lie in its linear middle;
/// beyond it more force still moves the mark, ever less, and never off the screen. It stays as it
/// is for the trial.
struct ForceAxis {
  double least_N = 0.0;  ///< <= 0
  double most_N = 1.0;   ///< > least_N, >= 0
  /// Height of a force, 0 … 1 exclusive. Strictly increasing.
  [[nodiscard]] double share(double force_N) const noexcept;
  /// Slope of share() in the linear middle [1/N].
  [[nodiscard]] double share_per_N() const noexcept;
};

struct TargetPreview {
  /// One part of the task, as TaskView::segment counts them.
  struct Part {
    Cue cue = Cue::relax;
    ForceChannel channel;
    bool steady = false;  ///< a target that stays where it is
  };
  /// Of a task of both hands: what is asked at most of each and of both together [N]; 0: nothing
  /// is. What is asked most stays at its height for the trial.
  struct Hands {
    OfHands<double> most_N;
    double most_sum_N = 0.0;
    std::vector<OfHands<Cue>> cues;  ///< one for each part
  };
  double period_s = 0.0;
  /// Value k is the target at task time k * period_s; NaN: none on the screen then. Empty unless
  /// some future may be seen.
  std::vector<double> target_N;
  double ahead_s = 0.0;  ///< how much of the future may be on the screen
  ForceAxis axis;
  /// Visual gain that the task asks for [deg/N]; nothing: the screen fits the target.
  std::optional<double> gain_deg_per_N;
  double digits_N = 0.0;  ///< largest force asked of a single digit; 0: none is asked
  std::vector<Part> parts;
  Hands hands;

  [[nodiscard]] bool has_target() const noexcept { return axis.most_N > axis.least_N; }
  /// Linear between two values; nothing where no target may be seen: before the start, after the
  /// end, later than `ahead_s` after `now_s`, beside a part without one.
  [[nodiscard]] std::optional<double> at(double task_time_s, double now_s) const noexcept;
  /// The next part after `segment` that asks for something; null: rest until the end.
  [[nodiscard]] const Part* next_effort(int segment) const noexcept;
};

/// Without parts for tasks with an object. Tasks whose waits cannot be foreseen have no future to
/// be seen whatever their file says: the wait would show where it ends.
[[nodiscard]] TargetPreview preview_target(const tasks::TaskSpec& spec,
                                           const tasks::TaskContext& context);

}  // namespace isograsp::gui
