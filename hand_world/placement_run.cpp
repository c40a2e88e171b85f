// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/placement_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "grasp_model/rotation.hpp"

namespace isograsp::hand_world {

namespace {

using namespace virtual_hand;

Pose target_pose(const StudyTarget& target, const Quat& q_WO) noexcept {
  // About its main axis the target is as the object is at first.
  const Vec3 main_W = q_WO * Vec3::UnitZ();
  const Vec3 axis_W = main_W.dot(target.axis_W) < 0.0 ? Vec3(-target.axis_W) : target.axis_W;
  return {target.p_W, (so3::shortest(main_W, axis_W) * q_WO).normalized()};
}

bool strayed(const Vec3& p_W, const Vec3& start_W) noexcept {
  return std::hypot(p_W.x() - start_W.x(), p_W.z() - start_W.z()) > PlacementRun::kOutOfReach_m;
}

ShownObject shown(const StudyObject& object) noexcept {
  ShownObject shows;
  shows.shape = object.shape.kind == ObjectShape::Kind::box ? ShownObject::Shape::box
                                                            : ShownObject::Shape::cylinder;
  shows.size_m = 2.0 * object.shape.half_m;
  return shows;
}

}  // namespace

PlacementRun::PlacementRun(const HandModel& hand, HandSource& person)
    : person_(person), grasp_(hand, kFrame_s) {}

void PlacementRun::frame(const Stimulus& picture) {
  person_.see(picture);
  const HandFrame hand = person_.at(static_cast<double>(frame_) * kFrame_s);
  ++frame_;
  held_ = !hand.tracked;
  if (!held_) hand_ = hand;
  const auto begin = std::chrono::steady_clock::now();
  grasp_.frame(hand, held_);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (!held_) step_times_s_.push_back(took.count() * AssistedGrasp::kStep_s / kFrame_s);
}

double PlacementRun::tracked_gap_m() const noexcept {
  const HandModel& hand = grasp_.model();
  const Vec3 way = hand_.joints[joint_of(Digit::index, kLinkCount)] -
                   hand_.joints[joint_of(Digit::thumb, kLinkCount)];
  return way.norm() - hand.digit(Digit::index).radii_m.back() -
         hand.digit(Digit::thumb).radii_m.back();
}

PlacementResult PlacementRun::place(const StudyObject& object, const StudyTarget& target,
                                    AssistanceLevel level) {
  const StartPlace start = start_place(object, 0.0, 0.0, 0.0);
  const Pose X_WT = target_pose(target, start.X_WO.q);
  grasp_.place(grasp_object(object), start, level);
  Stimulus picture;
  picture.cue = Cue::move;
  picture.object_shown = true;
  picture.pose_target_shown = true;
  picture.virtual_object = shown(object);
  picture.X_WT = X_WT;

  PlacementResult result;
  std::vector<PlacementRow> rows;
  PlacementWatch watch;
  std::size_t lost = 0;
  std::optional<double> purple_s;
  double open_held_s = 0.0;
  std::size_t seen = 0;
  for (;;) {
    const GraspState& state = grasp_.state();
    picture.X_WO = state.object.X_WO;
    picture.v_WO_W = state.object.v_WO_W;
    picture.w_WO_W = state.object.w_WO_W();
    frame(picture);
    result.residual_m_s = std::max(result.residual_m_s, state.solver.residual_m_s);
    if (held_) {  // the clock of a placement stands still
      lost += purple_s ? 0 : 1;
      continue;
    }
    const double t_s = static_cast<double>(seen++) * kFrame_s;
    if (!purple_s) {
      rows.push_back({t_s, state.held, state.supported, state.object.X_WO, X_WT});
      const bool dropped = watch.add(rows.back());
      if (watch.done()) {
        purple_s = t_s;
        grasp_.release();
        picture.virtual_object->let_go = true;
        picture.pose_matched = true;
      } else if (dropped) {
        grasp_.reset();
      } else if (!state.held && strayed(state.object.X_WO.p, start.X_WO.p)) {
        ++result.strays;
        grasp_.reset();
      } else if (t_s >= kLongest_s) {
        break;
      }
      continue;
    }
    const bool open = tracked_gap_m() >= 2.0 * object.shape.half_m.x() + kOpen_m;
    open_held_s = open && state.held ? open_held_s + kFrame_s : 0.0;
    result.held_open_s = std::max(result.held_open_s, open_held_s);
    if (!state.held) {
      result.release_s = t_s - *purple_s;
      break;
    }
    if (t_s - *purple_s >= kLongestRelease_s) {
      grasp_.let_go();
      result.helped = true;
    }
  }
  result.score = score_placement(rows);
  result.lost_share = static_cast<double>(lost) / static_cast<double>(lost + rows.size());
  grasp_.clear();
  Stimulus nothing;
  nothing.cue = Cue::relax;
  for (double paused_s = 0.0; paused_s < kPause_s; paused_s += kFrame_s) frame(nothing);
  return result;
}

}  // namespace isograsp::hand_world
