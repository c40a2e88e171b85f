// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/arm_live.hpp"

#include "kinematics/attitude.hpp"

namespace isograsp::gui {

std::optional<ReferenceError> error_of(const session::ArmSnapshot& now, const ArmSpace& space) {
  const tasks::ArmView& task = now.special.arm();
  const FramePose& object = now.segment(ArmSegment::object);
  const bool in_trial = now.stage == session::Stage::trial || now.stage == session::Stage::paused;
  if (!in_trial || !task.reference_shown || !has_pose(object.state)) return std::nullopt;
  ReferenceError error;
  const Vec3 way_S = space.place(object.X_W.p, task.X_WR.p);
  error.distance_m = way_S.norm();
  error.depth_m = way_S.z();
  error.angle_rad = rotation_vector(task.X_WR.q.conjugate() * object.X_W.q).norm();
  return error;
}

void LinkTurns::add(const session::ArmSnapshot& now) {
  if (now.trial_number != trial_ || now.task.target_index != target_) {
    trial_ = now.trial_number;
    target_ = now.task.target_index;
    first_ = {};
  }
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    const FramePose& parent = now.segment(session::kArmChain[k]);
    const FramePose& child = now.segment(session::kArmChain[k + 1]);
    now_[k].reset();
    if (!has_pose(parent.state) || !has_pose(child.state)) continue;
    now_[k] = parent.X_W.q.conjugate() * child.X_W.q;
    if (!first_[k]) first_[k] = now_[k];
  }
}

std::array<LinkTurns::Turn, kArmLinkCount> LinkTurns::turns() const {
  std::array<Turn, kArmLinkCount> turns;
  double all_rad = 0.0;
  bool whole = true;
  for (std::size_t k = 0; k < kArmLinkCount; ++k) {
    if (first_[k] && now_[k])
      turns[k].angle_rad = rotation_vector(first_[k]->conjugate() * *now_[k]).norm();
    whole = whole && turns[k].angle_rad;
    all_rad += turns[k].angle_rad.value_or(0.0);
  }
  if (!whole || all_rad < kLeastTurn_rad) return turns;
  constexpr double kPercent = 100.0;
  for (Turn& turn : turns) turn.share_percent = kPercent * *turn.angle_rad / all_rad;
  return turns;
}

}  // namespace isograsp::gui
