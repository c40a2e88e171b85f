// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual arm before cameras and a screen, without a session: 100 pictures a second in virtual
// time. Frames by the rig, task and measures by kinematics.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "kinematics/arm_frames.hpp"
#include "kinematics/movement.hpp"
#include "kinematics/pose_task.hpp"
#include "kinematics/postures.hpp"
#include "tests/support/must.hpp"
#include "virtual_patient/arm/virtual_arm.hpp"

namespace isograsp::test {

inline constexpr double kPicture_s = 0.01;

inline std::string source_text(const std::string& path) {
  return must(read_text(std::string(ISOGRASP_SOURCE_DIR) + "/" + path));
}
inline Rig shipped_rig(const std::string& name) {
  return must(parse_rig(source_text("library/rigs/" + name + ".toml"), name));
}
inline Postures shipped_postures(const std::string& name) {
  return must(parse_postures(source_text("library/postures/" + name + ".toml"), name));
}
inline Postures golden_postures() {
  return must(parse_postures(source_text("tests/data/isotonic/postures.toml"), "postures"));
}
/// Nothing that cameras and skin add, nothing out of sight.
inline virtual_patient::ArmTraits exact(virtual_patient::ArmTraits traits) {
  traits.skin_m = traits.camera_m = traits.loss_per_s = 0.0;
  traits.view_rad = std::numbers::pi;
  return traits;
}

/// Cameras, rig and screen around one arm.
struct PlayedArm {
  PlayedArm(const virtual_patient::ArmTraits& traits, std::uint64_t seed, Hand whose = Hand::right)
      : arm(traits, seed, whose),
        hand(whose),
        rig(whose == Hand::left ? mirrored(shipped_rig("kurillo15_trunk"))
                                : shipped_rig("kurillo15_trunk")),
        frames(must(ArmFrames::compile(rig, arm.labels()))),
        p_W(arm.labels().size()),
        poses(frames.frames()) {
    for (const RigFrame& frame : rig.frames) series.frames.push_back(frame.name);
    series.X_W.resize(rig.frames.size());
    object = *rig.frame("object");
  }

  /// The next picture of the cameras, and what the house makes of it.
  void look() {
    t_s = kPicture_s * taken++;
    arm.markers(t_s, p_W);
    if (hand == Hand::left)
      for (Vec3& p : p_W) p = mirrored(p);
    frames.solve(p_W, poses);
    series.t_s.push_back(t_s);
    for (std::size_t f = 0; f < poses.size(); ++f) series.X_W[f].push_back(poses[f].X_W);
  }
  /// What the house saw last of the object.
  [[nodiscard]] const Pose& X_WO() const { return poses[object].X_W; }

  /// Shows a picture with the object, as it was seen last, for a while.
  void show(Stimulus screen, double duration_s) {
    const int pictures = static_cast<int>(std::lround(duration_s / kPicture_s));
    for (int k = 0; k < pictures; ++k) {
      look();
      screen.object_shown = screen.cue == Cue::move && !is_missing(X_WO());
      if (screen.object_shown) screen.X_WO = X_WO();
      screen.t_s = t_s;
      arm.see(screen);
    }
  }
  void show(Cue cue, double duration_s) {
    Stimulus screen;
    screen.cue = cue;
    show(screen, duration_s);
  }
  /// Aims at one target for a while.
  void aim(const Pose& X_WT, double duration_s) {
    Stimulus screen;
    screen.cue = Cue::move;
    screen.pose_target_shown = true;
    screen.X_WT = X_WT;
    show(screen, duration_s);
  }

  virtual_patient::VirtualArm arm;
  Hand hand;
  Rig rig;  ///< of the world in which all is a right arm
  ArmFrames frames;
  std::size_t object = 0;
  int taken = 0;
  double t_s = 0.0;
  std::vector<Vec3> p_W;  ///< as read: of a left arm reflected
  std::vector<FramePose> poses;
  PoseSeries series;
};

/// What came of a sequence of postures.
struct ArmOutcome {
  std::vector<PoseEvent> events;
  std::vector<PoseTarget> targets;
  PoseSeries series;
  Rig rig;
  double elbow_m = 0.0;  ///< largest way of the elbow in the brace
  [[nodiscard]] int reached() const {
    int count = 0;
    for (const PoseEvent& event : events) count += event.enter_s ? 1 : 0;
    return count;
  }
  /// Mean time of targets; those not reached count with the limit.
  [[nodiscard]] double mean_time_s(double limit_s) const {
    double sum_s = 0.0;
    for (const PoseEvent& event : events) sum_s += event.time_s.value_or(limit_s);
    return sum_s / static_cast<double>(events.size());
  }
};

inline constexpr double kTimeLimit_s = 15.0;

/// 15 mm, 10 degrees, held for 0.3 s: the middle level of the assessment.
inline PoseTask pose_task(const Postures& library, const StartPosture& start,
                          const std::vector<std::size_t>& sequence) {
  PoseTask task;
  task.frame = library.chain.back();
  for (std::size_t j = 0; j < library.postures.size(); ++j)
    task.references.push_back(
        {library.postures[j].name, adapted(library, j, start, SizeScale::none)});
  task.targets = sequence;
  task.position_tolerance_m = 0.015;
  task.angle_tolerance_rad = 10.0 * std::numbers::pi / 180.0;
  task.hold_s = 0.3;
  task.display_s = 1.0;
  task.time_limit_s = kTimeLimit_s;
  return task;
}

/// The start posture of a second, then one posture after the other.
inline ArmOutcome play(const virtual_patient::ArmTraits& traits, std::uint64_t seed,
                       const Postures& library, const std::vector<std::size_t>& sequence,
                       Hand hand = Hand::right) {
  PlayedArm played(traits, seed, hand);
  played.show(Cue::relax, 1.0);
  const StartPosture start = must(start_posture(played.series, library.chain));
  const PoseTask task = pose_task(library, start, sequence);
  PoseTaskRun run(task);
  ArmOutcome outcome;
  const double end_s =
      played.t_s + static_cast<double>(sequence.size()) * (kTimeLimit_s + task.display_s) + 60.0;
  const std::size_t brace = *played.rig.frame("brace");
  const std::size_t elbow = *played.rig.frame("elbow");
  Stimulus screen;
  screen.cue = Cue::move;
  std::optional<Vec3> elbow_B;
  while (!run.finished() && played.t_s < end_s) {
    played.look();
    if (const auto event = run.step(played.t_s, played.X_WO())) outcome.events.push_back(*event);
    if (run.finished()) break;
    screen.object_shown = !is_missing(played.X_WO());
    if (screen.object_shown) screen.X_WO = played.X_WO();
    screen.pose_target_shown = true;
    screen.X_WT = task.references[task.targets[run.target()]].X_WR;
    screen.progress.holding = run.matched();
    screen.t_s = played.t_s;
    played.arm.see(screen);
    if (!has_pose(played.poses[brace].state) || !has_pose(played.poses[elbow].state)) continue;
    const Vec3 now_B = compose(inverse(played.poses[brace].X_W), played.poses[elbow].X_W).p;
    if (!elbow_B) elbow_B = now_B;
    outcome.elbow_m = std::max(outcome.elbow_m, (now_B - *elbow_B).norm());
  }
  for (const PoseEvent& event : outcome.events)
    outcome.targets.push_back({task.references[event.reference].name, event.cue_s, event.enter_s,
                               task.references[event.reference].X_WR});
  outcome.series = std::move(played.series);
  outcome.rig = played.rig;
  return outcome;
}

}  // namespace isograsp::test
