// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient's screen shows, decided without a window: one instruction, one picture.
// Never a name or a code. Frames: W world, O object, C contact. SI units.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "grasp_model/scene.hpp"
#include "gui/target_preview.hpp"
#include "session/snapshot.hpp"

namespace isograsp {

/// What the picture depends on. Pointers may be null: nothing of that kind.
struct PatientFacts {
  bool session_open = false;
  bool simulated = false;
  bool device_fault = false;  ///< also while no trial runs
  Snapshot snapshot;
  std::shared_ptr<const TaskSpec> task;  ///< the running one
  std::shared_ptr<const Scene> scene;    ///< of that task, turned for the hand
  std::shared_ptr<const TargetPreview> preview;
  double maximum_force_N = 0.0;
  bool just_completed = false;  ///< the last trial ended well and nothing began since
};

/// A virtual finger: a cone that approaches along its axis while force builds up and touches when
/// the contact is on.
struct FingerPicture {
  bool shown = false;
  Vec3 tip_W = Vec3::Zero();    ///< where its tip is [m]
  Vec3 axis_W = Vec3::UnitX();  ///< unit vector in which it presses
  bool touching = false;
  double effort = 0.0;  ///< 0 … 1
};

struct PatientPicture {
  enum class Page : std::uint8_t { message, effort, tracking, object };
  enum class Sign : std::uint8_t { wait, hand_out, rest, squeeze, good };
  enum class Notice : std::uint8_t { none, pause, fault };

  Page page = Page::message;
  Sign sign = Sign::wait;
  Notice notice = Notice::none;  ///< over the page, which then stands still
  std::string headline;          ///< the instruction, large
  std::string detail;            ///< one more sentence, or nothing
  std::string notice_words;
  bool simulated = false;
  bool progress_shown = false;
  double progress = 0.0;  ///< of the trial, 0 … 1

  double force_N = 0.0;  ///< grip
  double target_N = 0.0;
  double task_time_s = 0.0;
  double top_N = 1.0;  ///< upper end of the force scale
  std::shared_ptr<const TargetPreview> preview;

  std::shared_ptr<const Scene> scene;
  Pose object;
  bool target_shown = false;
  Pose target;
  double hold_fraction = 0.0;
  int targets_reached = 0;
  int target_count = 0;
  std::array<FingerPicture, kFingerCount> fingers{};
};

[[nodiscard]] PatientPicture picture_for(const PatientFacts& facts);

}  // namespace isograsp
