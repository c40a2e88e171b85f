// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_sight.hpp"

#include "device/markers/marker_reader.hpp"
#include "kinematics/postures.hpp"

namespace isograsp::session {

Result<ArmSight> ArmSight::compile(const ArmRig& rig, std::span<const std::string> labels) {
  ArmSight sight;
  auto frames = ArmFrames::compile(rig.rig, labels);
  if (!frames) return frames.error();
  sight.frames_ = *std::move(frames);
  auto recorded = recorded_markers(rig.rig, labels);
  if (!recorded) return recorded.error();
  sight.recorded_ = *std::move(recorded);
  sight.reflected_ = rig.hand == Hand::left;
  sight.frame_of_ = rig.frame_of;
  sight.links_ = rig.links;
  sight.p_W_.resize(labels.size());
  sight.poses_.resize(sight.frames_.frames());
  return sight;
}

void ArmSight::see(std::span<const Vec3> p_W, ArmSnapshot& now) noexcept {
  for (std::size_t i = 0; i < p_W_.size(); ++i)
    p_W_[i] = p_W.empty() ? unseen_marker() : reflected_ ? mirrored(p_W[i]) : p_W[i];
  frames_.solve(p_W_, poses_);
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    now.segments[s] = frame_of_[s] ? poses_[*frame_of_[s]] : FramePose{};
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    const Pose& parent = now.segment(kArmChain[k]).X_W;
    const Pose& child = now.segment(kArmChain[k + 1]).X_W;
    now.link_angles[k] = is_missing(parent) || is_missing(child)
                             ? unseen_marker()
                             : link_angles(parent.q.conjugate() * child.q, links_[k]);
  }
  now.marker_count = recorded_.size();
  for (std::size_t m = 0; m < recorded_.size(); ++m)
    now.markers_W[m] = p_W.empty() ? unseen_marker() : p_W[recorded_[m].label];
}

}  // namespace isograsp::session
