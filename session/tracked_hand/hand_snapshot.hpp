// SPDX-License-Identifier: GPL-3.0-or-later
// What both screens show of a session with a tracked hand, copied out of the acquisition thread. SI
// units; the world of the tracker, which is that of the screen: x right, y up, z to the viewer.
#pragma once

#include <array>
#include <optional>

#include "device/hand/hand_device.hpp"
#include "hand/stimulus.hpp"
#include "hand_world/assisted_grasp.hpp"
#include "hand_world/ground.hpp"
#include "session/acquisition/moment.hpp"
#include "session/tracked_hand/hand_entry.hpp"
#include "session/tracked_hand/hand_reader.hpp"
#include "tasks/task_view.hpp"
#include "virtual_hand/hand_frame.hpp"
#include "virtual_hand/hand_pose.hpp"

namespace isograsp::session {

/// What an entry test asks for, while it runs.
struct EntryShown {
  HandEntry::Stage stage = HandEntry::Stage::rest;
  bool open = true;  ///< else the hand is to close
  int openings = 0;  ///< so far
};

/// Radii of the capsules around the links of a hand [m].
using LinkRadii = std::array<std::array<double, virtual_hand::kLinkCount>, kDigitCount>;

/// Copying it takes no memory from the heap. Published once per frame.
struct HandSnapshot : Moment {
  HandHealth health;
  /// A camera looks at the person: from the start of a live tracker to its end.
  bool camera_on = false;
  ShownHand hand;
  double thumb_index_gap_m = tasks::kNotMeasured;
  std::optional<virtual_hand::FittedPose> pose;        ///< of the hand as it was seen last
  std::optional<virtual_hand::HandInSpace> seen_hand;  ///< every link of it
  LinkRadii link_radii_m{};                            ///< of both hands
  double opening_m = 0.0;                              ///< of the entry test; 0: none was passed
  std::optional<EntryShown> entry;
  tasks::SpecialView special;    ///< of the running trial's task, beside its progress
  hand_world::GraspState grasp;  ///< of a task with an object; else blank
  /// Pull above which a tie of this placement lets go; no ties: not measured [N].
  double release_N = tasks::kNotMeasured;
  std::optional<virtual_hand::HandInSpace> grasping_hand;  ///< every link of its virtual hand
  std::optional<hand_world::Ground> ground;                ///< on which its object stands at first
};

/// What is on the patient's screen at this frame, decided here alone. Real-time safe.
[[nodiscard]] Stimulus screen_of(const HandSnapshot& now) noexcept;

}  // namespace isograsp::session
