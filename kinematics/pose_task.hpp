// SPDX-License-Identifier: GPL-3.0-or-later
// A pose task: bring an object to one reference pose after the other (Kurillo et al., isotonic
// part; isograsp-pose-task-1). Poses in the world W of the cameras, times in s, angles in rad.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp {

struct PoseReference {
  std::string name;
  Pose X_WR;
};

struct PoseTask {
  std::string name;
  std::string frame;  ///< which frame is brought to the references
  std::vector<PoseReference> references;
  std::vector<std::size_t> targets;  ///< indices of references, the sequence repeated
  double position_tolerance_m = 0.0;
  double angle_tolerance_rad = 0.0;
  double hold_s = 0.0;     ///< how long inside counts as reached
  double display_s = 2.0;  ///< from reached to the next cue
  double time_limit_s = 0.0;
  /// Of the file of postures that the references were adapted from; empty: not told.
  std::string postures_hash;
};

[[nodiscard]] Result<PoseTask> parse_pose_task(std::string_view text, const std::string& file);

/// As a file that parse_pose_task() reads to the same task.
[[nodiscard]] std::string pose_task_text(const PoseTask& task);

/// One target as it ended. Times are those of the rows; what a target did not come to is missing.
struct PoseEvent {
  std::size_t reference = 0;
  double cue_s = 0.0;             ///< it appeared
  std::optional<double> enter_s;  ///< first row of the stay that reached it
  double done_s = 0.0;            ///< reached, or given up
  std::optional<double> time_s;   ///< cue to enter on the task's clock, which stands still in gaps
  std::optional<double> position_error_m;  ///< mean from reached to the next cue
  std::optional<double> angle_error_rad;
};

/// The automaton. Real-time: step() allocates nothing. Task clock c = t - pauses. A missing pose is
/// replaced by the last one for 50 ms; then everything stands still. When the next pose comes, the
/// part of the gap above 50 ms is added to the pauses, and a stay begins anew.
class PoseTaskRun {
 public:
  explicit PoseTaskRun(const PoseTask& task) noexcept : task_(task) {}

  /// One row, in order of time; a missing pose is missing_pose(). Gives the target that ended in
  /// this row, if one did.
  std::optional<PoseEvent> step(double t_s, const Pose& X_WO) noexcept;
  /// The record ends: a target that was reached ends with it, one not yet reached does not count.
  [[nodiscard]] std::optional<PoseEvent> finish() noexcept;

  [[nodiscard]] bool finished() const noexcept { return target_ >= task_.targets.size(); }
  /// Which target is shown; targets.size() at the end.
  [[nodiscard]] std::size_t target() const noexcept { return target_; }
  [[nodiscard]] bool matched() const noexcept { return matched_; }
  /// The first pose was seen.
  [[nodiscard]] bool started() const noexcept { return started_; }
  /// The stay that may reach the target has begun.
  [[nodiscard]] bool inside() const noexcept { return enter_s_.has_value(); }
  /// The task's clock since the first cue [s].
  [[nodiscard]] double clock_s(double t_s) const noexcept;
  /// How much of the stay that reaches the target is over, 0 … 1.
  [[nodiscard]] double hold_fraction(double t_s) const noexcept;
  /// How long the running target has been sought on the task's clock [s].
  [[nodiscard]] double sought_s(double t_s) const noexcept { return c(t_s) - cue_c_; }

 private:
  /// The task's clock; it stands still 50 ms after the last pose.
  [[nodiscard]] double c(double t_s) const noexcept;
  void cue(double t_s) noexcept;
  [[nodiscard]] PoseEvent ended() const noexcept;
  std::optional<PoseEvent> seek(double t_s, const Pose& X_WO) noexcept;

  const PoseTask& task_;
  std::size_t target_ = 0;
  bool started_ = false;
  bool matched_ = false;
  double first_c_ = 0.0;  ///< the first cue, on the task's clock
  double pauses_s_ = 0.0;
  double last_valid_s_ = 0.0;
  Pose last_ = missing_pose();
  double cue_s_ = 0.0, cue_c_ = 0.0;  ///< record time, task clock
  std::optional<double> enter_s_;
  double enter_c_ = 0.0;
  double done_s_ = 0.0, done_c_ = 0.0;
  double position_sum_m_ = 0.0, angle_sum_rad_ = 0.0;
  int rows_ = 0;
};

/// A whole record.
[[nodiscard]] std::vector<PoseEvent> run_pose_task(const PoseTask& task,
                                                   const std::vector<double>& t_s,
                                                   const std::vector<Pose>& X_WO);

}  // namespace isograsp
