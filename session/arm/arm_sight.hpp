// SPDX-License-Identifier: GPL-3.0-or-later
// What one picture of the cameras shows of an arm: markers -> frames of the rig -> segments and
// links. The same for a running session and for a recording that others made.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kinematics/arm_frames.hpp"
#include "session/arm/arm_rig.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::session {

class ArmSight {
 public:
  /// `labels` are those of the cameras. Errors: as ArmFrames::compile() and recorded_markers().
  [[nodiscard]] static Result<ArmSight> compile(const ArmRig& rig,
                                                std::span<const std::string> labels);

  [[nodiscard]] const std::vector<RecordedMarker>& recorded() const noexcept { return recorded_; }
  /// Segments, link angles and markers of `now`; `p_W` [m] in the frame of the cameras, one for
  /// each label, not seen NaN; empty: there is no picture, and nothing is seen. Rows in the order
  /// of time. Real-time safe.
  void see(std::span<const Vec3> p_W, ArmSnapshot& now) noexcept;

 private:
  ArmFrames frames_;
  std::vector<RecordedMarker> recorded_;
  bool reflected_ = false;
  std::array<std::optional<std::size_t>, kArmSegmentCount> frame_of_{};
  std::array<RigLink, kArmLinkCount> links_;
  std::vector<Vec3> p_W_;         ///< of all labels, reflected for a left arm
  std::vector<FramePose> poses_;  ///< of all frames of the rig
};

}  // namespace isograsp::session
