// SPDX-License-Identifier: GPL-3.0-or-later
// What goes into a task every frame and what comes out of it: its progress, and what is special
// about tasks of force, tasks with an object, …. Copying takes no memory from the heap.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <variant>

#include "grasp_model/plan.hpp"
#include "hand/arm_links.hpp"
#include "hand/finger.hpp"
#include "hand/force_channel.hpp"
#include "hand/stimulus.hpp"
#include "kinematics/attitude.hpp"
#include "tasks/references.hpp"
#include "tasks/task_progress.hpp"

namespace isograsp::tasks {

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Of a task on a platform of force sensors: the force that it is about.
struct ForceInput {
  FingerWrenches wrench_C;  ///< zeroed, contact frames
};
/// … which also move an object.
struct ObjectInput {
  FingerWrenches wrench_C;
  const ObjectState* object = nullptr;       ///< null: nothing is known of it
  std::array<bool, kFingerCount> contact{};  ///< fingers that touch the object
};
/// Of a task of an arm that moves a real object.
struct ArmInput {
  double t_s = 0.0;            ///< of the row: runs on while the object is out of sight
  Pose X_WO = missing_pose();  ///< of the object; missing_pose(): not seen in this row
};
/// std::monostate: of an apparatus whose tasks need to know nothing but the time.
using TaskInput = std::variant<std::monostate, ForceInput, ObjectInput, ArmInput>;

struct ForceView {
  ForceChannel channel;     ///< the force that the task is about
  bool force_shown = true;  ///< the patient sees the own force
  bool has_force_target = false;
  bool force_target_shown = false;  ///< … and the patient sees it
  double target_force_N = 0.0;
  double actual_force_N = 0.0;  ///< of the channel
  DigitTargets digit_targets;
  // Of the channel; nothing: not measured.
  std::optional<double> resting_force_N;
  std::optional<double> maximum_force_N;
  std::optional<double> noise_sd_N;
};
struct ObjectView {
  ForceView grip;  ///< of the hand that holds the object
  bool pose_target_shown = false;
  Pose X_WT;
  int drops = 0;
  bool object_placed = false;  ///< the object appears anew, at rest, after this frame, at
  Pose placed_X_WO;
};

struct ArmView {
  bool reference_shown = false;
  Pose X_WR;
  bool matched = false;  ///< reached; it stays in view for a moment
  /// What is to be turned to and fro, as far as it goes.
  std::optional<LinkAngle> turn;
};

/// What is special about a task of one sort.
struct SpecialView {
  std::variant<std::monostate, ForceView, ObjectView, ArmView> special;

  /// Of a force task, or of the hand that holds an object; blank: of neither.
  [[nodiscard]] const ForceView& force() const noexcept;
  /// Blank: of a task without object.
  [[nodiscard]] const ObjectView& object() const noexcept;
  /// Blank: of a task that is not about an arm.
  [[nodiscard]] const ArmView& arm() const noexcept;
};

/// What the screen shows and the record keeps after a step.
struct TaskView : TaskProgress, SpecialView {};

/// What is known of a force before the first step: its references.
[[nodiscard]] ForceView blank_force(const ForceReferences& references, ForceChannel channel);
/// The same with the force of `input`; of one without forces: 0.
[[nodiscard]] ForceView with_force(ForceView blank, const TaskInput& input) noexcept;
/// Blank: of a task without object.
[[nodiscard]] const ObjectInput& object_of(const TaskInput& input) noexcept;

}  // namespace isograsp::tasks
