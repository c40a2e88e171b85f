// SPDX-License-Identifier: GPL-3.0-or-later
// What is on the patient's screen is decided in one place: real and simulated people get the same.
// What a task hides is not in it.

#include <gtest/gtest.h>

#include "session/demonstration.hpp"
#include "session/library/library.hpp"
#include "tests/support/every.hpp"
#include "tests/support/platform_tasks.hpp"

namespace isograsp::session::screen_test {
namespace {

const std::string kLibrary = std::string(ISOGRASP_SOURCE_DIR) + "/library";

Snapshot in_trial() {
  Snapshot now;
  now.frames = 1;
  now.stage = Stage::trial;
  now.zeroed = true;
  return now;
}

/// Force targets, forces and poses that are hidden are as if there were none.
void expect_hidden(const Snapshot& now, const std::string& of) {
  const tasks::ForceView& force = now.special.force();
  const Stimulus screen = screen_of(now);
  EXPECT_EQ(screen.force_shown, force.force_shown) << of;
  EXPECT_EQ(screen.shown_force_N, force.force_shown ? force.actual_force_N : 0.0) << of;
  EXPECT_EQ(screen.force_target_shown, force.force_target_shown) << of;
  EXPECT_EQ(screen.target_force_N, force.force_target_shown ? force.target_force_N : 0.0) << of;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (!force.force_shown || !force.digit_targets.shown[f]) {
      EXPECT_EQ(screen.digit_force_C[f], Vec3::Zero()) << of;
    }
    if (!now.has_object) {
      EXPECT_EQ(screen.press_N[f], 0.0) << of;
    }
  }
  EXPECT_EQ(screen.object_shown, now.has_object) << of;
  EXPECT_EQ(screen.pose_target_shown, now.special.object().pose_target_shown) << of;
  if (!screen.pose_target_shown) {
    EXPECT_EQ(screen.X_WT.p, screen.X_WO.p) << of;
  }
}

TEST(Screen, HasNothingThatTheTaskHidesWhateverTaskOfTheLibraryIsDone) {
  test::AtLeast without_force(100);   // frames
  test::AtLeast without_target(100);  // that the task has
  for (const tasks::TaskSpec& spec : test::every(test::platform_tasks(kLibrary))) {
    const auto shown = demonstrate(spec, {}, kLibrary).value();
    for (const Snapshot& now : test::every(shown.frames)) {
      expect_hidden(now, spec.name);
      if (::testing::Test::HasFailure()) return;
      const tasks::ForceView& force = now.special.force();
      if (!force.force_shown) ++without_force;
      if (force.has_force_target && !force.force_target_shown) ++without_target;
    }
  }
}

TEST(Screen, AFingerThatPullsDoesNotPress) {
  Snapshot now = in_trial();
  now.has_object = true;
  now.forces.wrench_C[0].force.z() = -5.0;
  now.forces.wrench_C[1].force.z() = 2.0;
  EXPECT_EQ(screen_of(now).press_N, (std::array{0.0, 2.0, 0.0}));
}

TEST(Screen, APauseAsksToRelaxAndLeavesThePageOfTheTask) {
  Snapshot now = in_trial();
  now.task.cue = Cue::squeeze;
  EXPECT_EQ(screen_of(now).cue, Cue::squeeze);
  now.stage = Stage::paused;
  EXPECT_EQ(screen_of(now).cue, Cue::relax);
  EXPECT_EQ(screen_of(now).page_cue, Cue::squeeze);
}

TEST(Screen, BetweenTrialsNothingIsLeftOfTheLastOne) {
  Snapshot now = in_trial();
  now.task.cue = Cue::squeeze;
  now.task.target_count = 5;
  now.has_object = true;
  auto& force = now.special.special.emplace<tasks::ObjectView>().grip;
  force.force_target_shown = true;
  force.target_force_N = 7.0;
  EXPECT_EQ(screen_of(now).target_force_N, 7.0);
  now.stage = Stage::idle;
  const Stimulus screen = screen_of(now);
  EXPECT_EQ(screen.cue, Cue::relax);
  EXPECT_EQ(screen.target_force_N, 0.0);
  EXPECT_EQ(screen.progress.target_count, 0);
  EXPECT_FALSE(screen.object_shown);
  now.zeroed = false;
  EXPECT_EQ(screen_of(now).cue, Cue::hand_out);
  now.zeroed = true;
  now.stage = Stage::zeroing;
  EXPECT_EQ(screen_of(now).cue, Cue::hand_out);
}

}  // namespace
}  // namespace isograsp::session::screen_test
