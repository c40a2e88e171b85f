// SPDX-License-Identifier: GPL-3.0-or-later
// What both screens show of a session with an arm seen by markers, copied out of the acquisition
// thread. SI units; poses in the frame W of the cameras, of a left arm in its reflection.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "device/cameras/marker_device.hpp"
#include "hand/arm_columns.hpp"
#include "hand/stimulus.hpp"
#include "kinematics/arm_frames.hpp"
#include "session/acquisition/moment.hpp"
#include "session/arm/arm_rig.hpp"
#include "tasks/task_view.hpp"

namespace isograsp::session {

/// What is fixed of an arm while its session lasts, for whoever draws it. Of a left arm in its
/// reflection, as the poses are.
struct ArmSetup {
  std::string rig;                   ///< its name
  RigView view;                      ///< which axes of the cameras point right and up
  std::vector<std::string> markers;  ///< names, in the order of ArmSnapshot::markers_W
  std::array<bool, kArmSegmentCount> has_segment{};  ///< those that the rig makes
  std::vector<Vec3> object_m;  ///< where its markers are on the object; empty: the rig does not say
};

/// Of a session, or of one that is stored: `markers` are the names of those that are recorded.
[[nodiscard]] ArmSetup setup_of(const ArmRig& rig, std::vector<std::string> markers);

/// Copying it takes no memory from the heap. Published once per frame.
struct ArmSnapshot : Moment {
  MarkerHealth health;
  bool picture = false;  ///< the cameras gave one for this frame
  /// Of each segment; one that the rig has not is missing.
  std::array<FramePose, kArmSegmentCount> segments{};
  /// The angles of each link [rad]; missing where one of its segments is.
  std::array<Vec3, kArmLinkCount> link_angles{};
  std::size_t marker_count = 0;                      ///< those that are recorded
  std::array<Vec3, ArmRig::kMostMarkers> markers_W;  ///< as cameras see them [m]; not seen: NaN
  double unseen_s = 0.0;                             ///< how long the object has not been seen
  Pose last_X_WO = missing_pose();                   ///< of the object, where it was seen last
  /// Where the object was in the start posture; not finite: that has not been held yet.
  Vec3 start_p_WO = Vec3::Constant(kMissing);
  tasks::SpecialView special;  ///< of the running trial's task, beside its progress
  ShownAngle angle;            ///< that its task asks for, and how far it went

  [[nodiscard]] const FramePose& segment(ArmSegment which) const noexcept {
    return segments[index_of(which)];
  }
};

/// Too long for the last pose to stand in. Real-time safe.
[[nodiscard]] bool outlasts_a_stand_in(double unseen_s) noexcept;

/// What is on the patient's screen at this frame, decided here alone. Real-time safe.
[[nodiscard]] Stimulus screen_of(const ArmSnapshot& now) noexcept;

}  // namespace isograsp::session
