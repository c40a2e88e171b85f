// SPDX-License-Identifier: GPL-3.0-or-later
// State machines with scripted inputs.
#include "tasks/task.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/object/observe.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::task_test {
namespace {

using test::spec_of;

constexpr double kPeriod_s = 0.01;

std::unique_ptr<Task> made(TaskSpec spec, double maximum_force_N = 0.0) {
  TaskContext context;
  context.period_s = kPeriod_s;
  if (maximum_force_N > 0.0) context.references.maximum_N[{}] = maximum_force_N;
  auto task = make_task(spec, context);
  EXPECT_TRUE(task);
  return std::move(*task);
}
ObjectInput pressing(double thumb_N, double index_N, double middle_N) {
  ObjectInput input;
  input.wrench_C[0].force.z() = thumb_N;
  input.wrench_C[1].force.z() = index_N;
  input.wrench_C[2].force.z() = middle_N;
  return input;
}

ObjectState object_at(double x_m, double y_m, double angle_rad) {
  ObjectState state;
  state.X_WO.p = {x_m, y_m, 0.0};
  state.X_WO.q = Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()));
  state.angle_rad = angle_rad;
  return state;
}

/// Two targets at the left: level on entering, then turned by 90 degrees for 0.1 s.
PoseTargetsSpec two_poses() {
  PoseTargetsSpec spec;
  spec.scene = "planar_block";
  spec.position_tolerance_m = 0.02;
  spec.angle_tolerance_rad = 0.26;
  spec.time_limit_s = 0.5;
  spec.targets = {{Vec3(-0.08, -0.06, 0.0), 0.0, 0.0, true},
                  {Vec3(-0.08, -0.06, 0.0), std::numbers::pi / 2, 0.1, false}};
  return spec;
}

TEST(Rest, IsActiveForItsDurationAndThenStaysDone) {
  const auto task = made(spec_of(RestSpec{0.3}));
  for (int frame = 0; frame < 30; ++frame) {
    const TaskView view = task->step(pressing(1, 1, 1));
    EXPECT_EQ(view.phase, Phase::active);
    EXPECT_EQ(view.cue, Cue::relax);
    EXPECT_DOUBLE_EQ(view.task_time_s, frame * kPeriod_s);
  }
  for (int frame = 0; frame < 3; ++frame) EXPECT_EQ(task->step({}).phase, Phase::done);
}

TEST(Maximum, RelaxesThenSqueezesThenIsDone) {
  const auto task = made(spec_of(MaximumSpec{}));
  int relaxed = 0;
  int squeezed = 0;
  TaskView view = task->step(pressing(8, 3, 3));
  for (; view.phase != Phase::done; view = task->step(pressing(8, 3, 3))) {
    EXPECT_EQ(view.cue, view.phase == Phase::active ? Cue::squeeze : Cue::relax);
    EXPECT_EQ(view.force().actual_force_N, 6.0);
    EXPECT_EQ(view.duration_s, 4.0);
    (view.phase == Phase::active ? squeezed : relaxed)++;
  }
  EXPECT_EQ(relaxed, 100);
  EXPECT_EQ(squeezed, 300);
}

TEST(ForceTracking, TheTargetIsTheSineOfItsSpecificationWithoutAJump) {
  const ForceTrackingSpec sine;  // 0.2 Hz, 10 to 30 %, 2 s and 30 s
  const auto task = made(spec_of(sine), 50.0);
  double previous_N = 5.0;
  double least_N = 1e9;
  double most_N = -1e9;
  for (int frame = 0;; ++frame) {
    const TaskView view = task->step({});
    if (view.phase == Phase::done) {
      EXPECT_EQ(frame, 3200);
      break;
    }
    const double s = std::max(0.0, frame * kPeriod_s - 2.0);
    const double closed = 10.0 - 5.0 * std::cos(2.0 * std::numbers::pi * 0.2 * s);
    constexpr double kRounding_N = 1e-12;
    ASSERT_WITHIN(view.force().target_force_N, closed, kRounding_N);
    const double fastest_N = 5.0 * 2.0 * std::numbers::pi * 0.2 * kPeriod_s;
    ASSERT_LE(std::abs(view.force().target_force_N - previous_N), fastest_N);
    ASSERT_EQ(view.phase, frame < 200 ? Phase::lead_in : Phase::active);
    ASSERT_TRUE(view.force().force_target_shown);
    previous_N = view.force().target_force_N;
    least_N = std::min(least_N, view.force().target_force_N);
    most_N = std::max(most_N, view.force().target_force_N);
  }
  EXPECT_DOUBLE_EQ(least_N, 5.0);
  EXPECT_DOUBLE_EQ(most_N, 15.0);
}

TEST(ForceTracking, WithoutAMaximumIsRefusedWithARemedy) {
  TaskSpec spec = spec_of(ForceTrackingSpec{});
  spec.file = "grip_sine.toml";
  const auto task = make_task(spec, TaskContext{});
  ASSERT_FALSE(task);
  EXPECT_EQ(task.error().message(),
            "grip_sine.toml: scale: the target is a share of the maximum force of 'grip', and no "
            "trial of "
            "this session measured one; run the resting-force task and a maximum task of it first");
}

TEST(PoseTargets, AreReachedOnEnteringOrAfterAnUninterruptedHold) {
  const auto task = made(spec_of(two_poses()));
  const ObjectState away = object_at(0, 0, 0);
  const ObjectState level = object_at(-0.08, -0.05, 0.1);
  const ObjectState turned = object_at(-0.075, -0.06, 1.5);
  const auto step = [&](const ObjectState& object) {
    ObjectInput input;
    input.object = &object;
    return task->step(input);
  };
  TaskView view = step(away);
  EXPECT_EQ(view.phase, Phase::transport);
  EXPECT_EQ(view.target_index, 0);
  EXPECT_EQ(view.cue, Cue::move);
  EXPECT_TRUE(view.object().pose_target_shown);
  view = step(level);
  EXPECT_EQ(view.phase, Phase::hold);
  EXPECT_EQ(view.targets_reached, 1);
  EXPECT_EQ(view.hold_fraction, 1.0);
  for (int frame = 0; frame <= 5; ++frame) {
    view = step(turned);
    EXPECT_EQ(view.target_index, 1);
    EXPECT_DOUBLE_EQ(view.hold_fraction, frame / 10.0);
  }
  view = step(level);  // left the tolerance: the hold starts anew
  EXPECT_EQ(view.phase, Phase::transport);
  EXPECT_EQ(view.hold_fraction, 0.0);
  for (int frame = 0; frame < 10; ++frame) EXPECT_EQ(step(turned).targets_reached, 1);
  view = step(turned);  // 11 samples span 0.1 s
  EXPECT_EQ(view.targets_reached, 2);
  EXPECT_EQ(view.hold_fraction, 1.0);
  view = step(turned);
  EXPECT_EQ(view.phase, Phase::done);
  EXPECT_EQ(view.targets_reached, 2);
  EXPECT_FALSE(view.object().pose_target_shown);
}

TEST(PoseTargets, BothPositionAndAngleMustBeInside) {
  for (const ObjectState& outside :
       {object_at(-0.08, -0.039, 0.0), object_at(-0.08, -0.06, 0.27)}) {
    const auto task = made(spec_of(two_poses()));
    ObjectInput input;
    input.object = &outside;
    EXPECT_EQ(task->step(input).phase, Phase::transport);
  }
}

TEST(PoseTargets, ATargetBeyondItsTimeLimitIsLeftUnreached) {
  const auto task = made(spec_of(two_poses()));
  const ObjectState away = object_at(0, 0, 0);
  ObjectInput input;
  input.object = &away;
  int frames = 0;
  for (TaskView view = task->step(input); view.phase != Phase::done; view = task->step(input)) {
    EXPECT_EQ(view.target_index, frames / 50);
    EXPECT_EQ(view.targets_reached, 0);
    ++frames;
  }
  EXPECT_EQ(frames, 100);
}

TEST(PoseTargets, TimeWithoutStepsNeverCountsAgainstThePatient) {
  // During a device fault the session does not call step(): however long that lasts, the next step
  // finds the task as it was.
  const auto task = made(spec_of(two_poses()));
  const ObjectState away = object_at(0, 0, 0);
  const ObjectState level = object_at(-0.08, -0.06, 0.0);
  ObjectInput input;
  input.object = &away;
  for (int frame = 0; frame < 49; ++frame) EXPECT_EQ(task->step(input).target_index, 0);
  input.object = &level;
  const TaskView view = task->step(input);
  EXPECT_EQ(view.targets_reached, 1);
  EXPECT_DOUBLE_EQ(view.task_time_s, 0.49);
}

TEST(Observe, ShowsNoTargetAndEndsAfterItsTime) {
  const auto task = made(spec_of(ObserveSpec{"planar_block", 0.2}));
  for (int frame = 0; frame < 20; ++frame) {
    const TaskView view = task->step(pressing(2, 1, 1));
    EXPECT_EQ(view.phase, Phase::active);
    EXPECT_FALSE(view.object().pose_target_shown);
    EXPECT_EQ(view.force().actual_force_N, 2.0);
  }
  EXPECT_EQ(task->step({}).phase, Phase::done);
}

TEST(Task, StepAllocatesNothingFromFirstToLastFrame) {
  PoseTargetsSpec poses = two_poses();
  for (const TaskSpec& spec :
       {spec_of(RestSpec{1.0}), spec_of(MaximumSpec{}), spec_of(ForceTrackingSpec{}),
        spec_of(poses), spec_of(ObserveSpec{"planar_block", 1.0})}) {
    const auto task = made(spec, 20.0);
    const ObjectState object = object_at(-0.08, -0.06, 0.0);
    ObjectInput input = pressing(1, 1, 1);
    input.object = &object;
    const auto before = test::allocations();
    while (task->step(input).phase != Phase::done) {
    }
    EXPECT_EQ(test::allocations(), before);
  }
}

TEST(Task, TheFrameRateChangesNeitherTargetNorDuration) {
  TaskContext fast;
  fast.period_s = 0.002;
  fast.references.maximum_N[{}] = 50.0;
  const TaskSpec spec = spec_of(ForceTrackingSpec{});
  const auto fine = std::move(*make_task(spec, fast));
  const auto coarse = made(spec, 50.0);
  constexpr double kRounding = 1e-12;
  for (int frame = 0; frame < 3200; ++frame) {
    const TaskView slow_view = coarse->step({});
    const TaskView fast_view = fine->step({});
    for (int skipped = 0; skipped < 4; ++skipped) static_cast<void>(fine->step({}));
    ASSERT_WITHIN(slow_view.force().target_force_N, fast_view.force().target_force_N, kRounding);
    ASSERT_WITHIN(slow_view.task_time_s, fast_view.task_time_s, kRounding);
  }
  EXPECT_EQ(coarse->step({}).phase, Phase::done);
  EXPECT_EQ(fine->step({}).phase, Phase::done);
}

}  // namespace
}  // namespace isograsp::tasks::task_test
