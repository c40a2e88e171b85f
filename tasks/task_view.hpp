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
#include "hand/hands.hpp"
#include "hand/stimulus.hpp"
#include "kinematics/attitude.hpp"
#include "tasks/object_targets.hpp"
#include "tasks/references.hpp"
#include "tasks/task_progress.hpp"
#include "virtual_hand/assistance_level.hpp"

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
/// Of a task of a tracked hand, and of the object on the screen that it may hold.
struct HandInput {
  bool seen = false;  ///< in this frame; else hand and object are as they were last
  double thumb_index_gap_m = kNotMeasured;
  bool held = false;       ///< a digit is tied to the object, or two touch it
  bool touched = false;    ///< a digit touches it, or is tied to it
  bool supported = false;  ///< it is less than 5 mm above table or block
  Pose X_WO = missing_pose();
  /// Frames of the trial so far, and those of them without the hand (virtual_hand::LostShare):
  /// pauses in which it was out of sight count, others do not.
  std::int64_t frames = 0;
  std::int64_t lost = 0;
  /// The therapist lets the object go for the person: until the next one is placed.
  bool let_go = false;
};
/// Of a task of two hands, each on a platform of its own.
struct TwoHandsInput {
  OfHands<FingerWrenches> wrench_C;     ///< zeroed, contact frames
  const ObjectState* object = nullptr;  ///< that both move; null: there is none
  OfHands<bool> touches{};              ///< it is in this hand; carried: in both or in none
  OfHands<bool> slips{};                ///< … at the limit of friction
};
/// std::monostate: of an apparatus whose tasks need to know nothing but the time.
using TaskInput =
    std::variant<std::monostate, ForceInput, ObjectInput, ArmInput, HandInput, TwoHandsInput>;

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

/// What is done with the virtual object after this frame, before the next one.
enum class ObjectOrder : std::uint8_t {
  none,
  place,    ///< it appears, at its start
  reset,    ///< it was dropped and is at its start again
  release,  ///< it was placed: nothing new is tied to it
  let_go,   ///< it is let go for the person
  remove
};
/// Of a task of a tracked hand. Without an object all but the first is blank.
struct HandView {
  bool about_object = false;
  ObjectOrder order = ObjectOrder::none;
  int object = -1;     ///< of virtual_hand::study_objects(); -1: there is none
  int placement = -1;  ///< from 0; one that is repeated has its own number
  virtual_hand::AssistanceLevel assistance = virtual_hand::AssistanceLevel::off;
  bool eased = false;  ///< easier than the task says, after fails
  int fails = 0;       ///< drops in this placement
  bool target_shown = false;
  Pose X_WT = missing_pose();
  bool at_target = false;
  bool let_go_asked = false;  ///< it was placed, and the hand is to open
  bool helped = false;        ///< it was let go for the person
};

/// What is asked of one of two hands, and its grip force.
struct HandAsked {
  Cue cue = Cue::relax;
  double force_N = 0.0;
  bool force_shown = false;                       ///< the patient sees it
  std::optional<double> target_N = std::nullopt;  ///< nothing: none of its own
};
/// Of an object that two hands move together. A turn is about world z, above 0 where the right end
/// is higher.
struct MovedView {
  bool target_shown = false;
  Pose X_WT;
  PoseTolerance band;  ///< lifted: in height and in turn
  int drops = 0;
  bool on_rest = true;  ///< the hands do nothing to it: from this frame it stays, at rest, at
  Pose rest_X_WO;
  bool fetched = false;  ///< it was dropped and is brought back
  bool home = false;     ///< hands that are points begin anew, too
};
/// Of a task of two hands.
struct TwoHandsView {
  OfHands<HandAsked> of;
  bool sum_shown = false;                         ///< the patient sees the force of both together
  std::optional<double> target_sum_N;             ///< asked of both together; nothing: nothing is
  std::optional<MovedView> moved = std::nullopt;  ///< nothing: there is no object
  TwoHandsReferences references;
};

/// What is special about a task of one sort.
struct SpecialView {
  std::variant<std::monostate, ForceView, ObjectView, ArmView, HandView, TwoHandsView> special;

  /// Of a force task, or of the hand that holds an object; blank: of neither.
  [[nodiscard]] const ForceView& force() const noexcept;
  /// Blank: of a task without object.
  [[nodiscard]] const ObjectView& object() const noexcept;
  /// Blank: of a task that is not about an arm.
  [[nodiscard]] const ArmView& arm() const noexcept;
  /// Blank: of a task that is not about a tracked hand.
  [[nodiscard]] const HandView& hand() const noexcept;
  /// Blank: of a task that is not about two hands.
  [[nodiscard]] const TwoHandsView& two_hands() const noexcept;
};

/// What the screen shows and the record keeps after a step.
struct TaskView : TaskProgress, SpecialView {};

/// What is known of a force before the first step: its references.
[[nodiscard]] ForceView blank_force(const ForceReferences& references, ForceChannel channel);
/// The same with the force of `input`; of one without forces: 0.
[[nodiscard]] ForceView with_force(ForceView blank, const TaskInput& input) noexcept;
/// Blank: of a task without object.
[[nodiscard]] const ObjectInput& object_of(const TaskInput& input) noexcept;
/// Blank: of a task that is not about a tracked hand.
[[nodiscard]] const HandInput& hand_of(const TaskInput& input) noexcept;

}  // namespace isograsp::tasks
