// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/pose_task.hpp"

#include <gtest/gtest.h>

#include "kinematics/tables/pose_csv.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::pose_task_test {
namespace {

using namespace isograsp::test;

constexpr double kStep_s = 0.01;
constexpr double kTime_s = 1e-9;  // sums of steps

/// One target at the origin, reached within 10 mm and 8 degrees.
PoseTask one_target(double hold_s, std::size_t targets = 1) {
  PoseTask task;
  task.references = {{"here", Pose()}};
  task.targets.assign(targets, 0);
  task.position_tolerance_m = 0.01;
  task.angle_tolerance_rad = 0.14;
  task.hold_s = hold_s;
  task.display_s = 2.0;
  task.time_limit_s = 6.0;
  return task;
}
const Pose kInside;
const Pose kOutside{Vec3(0.5, 0, 0), Quat::Identity()};

/// Rows from..to of a record at 100 Hz.
struct Part {
  Pose X_WO;
  double length_s;
};
std::vector<PoseEvent> run(const PoseTask& task, const std::vector<Part>& parts) {
  std::vector<double> t_s;
  std::vector<Pose> poses;
  for (const Part& part : parts)
    for (int k = 0; k < static_cast<int>(std::lround(part.length_s / kStep_s)); ++k) {
      t_s.push_back(static_cast<double>(t_s.size()) * kStep_s);
      poses.push_back(part.X_WO);
    }
  return run_pose_task(task, t_s, poses);
}

TEST(PoseTask, AgreesWithAnIndependentRunWithGapsAndATimeOut) {
  const auto task =
      must(parse_pose_task(must(read_text(golden("task_plain_task.toml"))), "task_plain.toml"));
  const auto series = must(read_poses(golden("task_plain_poses.csv")));
  const auto events =
      run_pose_task(task, series.t_s, series.X_W[must(frame_of(series, task.frame))]);
  const auto expected = golden_table(golden("task_plain_events_expected.csv"));
  ASSERT_EQ(events.size(), expected.size());
  constexpr double kEvent = 1e-7;
  for (std::size_t e = 0; e < events.size(); ++e) {
    EXPECT_EQ(task.references[events[e].reference].name, expected[e].at("posture"));
    const auto same = [&](const std::optional<double>& value, const char* column) {
      const double reference = number_in(expected[e], column);
      ASSERT_EQ(value.has_value(), !std::isnan(reference)) << column << " of " << e;
      if (value) {
        EXPECT_WITHIN(*value, reference, kEvent) << column << " of " << e;
      }
    };
    same(events[e].cue_s, "cue_s");
    same(events[e].enter_s, "enter_s");
    same(events[e].done_s, "done_s");
    same(events[e].time_s, "time_s");
    same(events[e].position_error_m, "position_error_m");
    same(events[e].angle_error_rad, "angle_error_rad");
  }
}

TEST(PoseTask, AStayShorterThanTheHoldDoesNotCount) {
  const auto events =
      run(one_target(0.3), {{kOutside, 1.0}, {kInside, 0.25}, {kOutside, 0.5}, {kInside, 3.0}});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_WITHIN(*events[0].enter_s, 1.75, kTime_s);
  EXPECT_WITHIN(events[0].done_s, 2.05, kTime_s);
  EXPECT_WITHIN(*events[0].time_s, 1.75, kTime_s);
}

TEST(PoseTask, AShortGapIsHeldAndALongOneBreaksTheStayAndStopsTheClock) {
  // 40 ms: the last pose stands in and the stay goes on.
  const auto held = run(one_target(0.3),
                        {{kOutside, 1.0}, {kInside, 0.2}, {missing_pose(), 0.04}, {kInside, 3.0}});
  ASSERT_EQ(held.size(), 1U);
  EXPECT_WITHIN(*held[0].enter_s, 1.0, kTime_s);
  EXPECT_WITHIN(held[0].done_s, 1.3, kTime_s);
  // 800 ms within the hold: it begins anew, and what is above 50 ms does not count as time.
  const auto broken = run(one_target(0.3),
                          {{kOutside, 1.0}, {kInside, 0.2}, {missing_pose(), 0.8}, {kInside, 3.0}});
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_WITHIN(*broken[0].enter_s, 2.0, kTime_s);
  const double last_valid_s = 1.19;
  EXPECT_WITHIN(*broken[0].time_s, 2.0 - (2.0 - last_valid_s - 0.05), kTime_s);
}

TEST(PoseTask, RowsThatDoNotComeAreTheSameAsRowsWithoutAPose) {
  const PoseTask task = one_target(0.3);
  PoseTaskRun with(task), without(task);
  std::vector<PoseEvent> one, other;
  for (int k = 0; k < 800; ++k) {
    const double t_s = k * kStep_s;
    const bool gap = k >= 120 && k < 200;
    const Pose& X_WO = k < 100 ? kOutside : kInside;
    if (const auto event = with.step(t_s, gap ? missing_pose() : X_WO)) one.push_back(*event);
    if (gap) continue;
    if (const auto event = without.step(t_s, X_WO)) other.push_back(*event);
  }
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(other.size(), 1U);
  EXPECT_EQ(one[0].enter_s, other[0].enter_s);
  EXPECT_EQ(one[0].time_s, other[0].time_s);
  EXPECT_EQ(one[0].done_s, other[0].done_s);
}

TEST(PoseTask, ATargetThatIsNotReachedIsGivenUpAndTheNextOneCuedAtOnce) {
  const auto events = run(one_target(0.0, 2), {{kOutside, 7.0}, {kInside, 3.0}});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_FALSE(events[0].enter_s);
  EXPECT_FALSE(events[0].time_s);
  EXPECT_WITHIN(events[0].done_s, 6.0, kTime_s);
  EXPECT_WITHIN(events[1].cue_s, 6.0, kTime_s);
  EXPECT_WITHIN(*events[1].time_s, 1.0, kTime_s);
}

TEST(PoseTask, TolerancesAreInclusiveAndExact) {
  const PoseTask task = one_target(0.0);
  for (const auto& [x_m, reached] : {std::pair(0.01, true), {std::nextafter(0.01, 1.0), false}}) {
    PoseTaskRun run(task);
    static_cast<void>(run.step(0.0, {Vec3(x_m, 0, 0), Quat::Identity()}));
    EXPECT_EQ(run.matched(), reached) << x_m;
  }
}

TEST(PoseTask, ARecordThatEndsWritesWhatWasReachedAndForgetsWhatWasSought) {
  EXPECT_EQ(run(one_target(0.0), {{kOutside, 1.0}, {kInside, 0.1}}).size(), 1U);
  EXPECT_TRUE(run(one_target(0.0), {{kOutside, 1.0}}).empty());
  EXPECT_TRUE(run(one_target(0.0), {{missing_pose(), 1.0}}).empty());
}

TEST(PoseTask, AStepAllocatesNothing) {
  const PoseTask task = one_target(0.3, 3);
  PoseTaskRun run(task);
  int ended = 0;
  const auto before = allocations();
  for (int k = 0; k < 2000; ++k)
    ended += run.step(k * kStep_s, k % 300 < 100 ? kOutside : kInside).has_value() ? 1 : 0;
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(ended, 3);
}

TEST(PoseTask, IsWrittenAsItWasRead) {
  const auto task =
      must(parse_pose_task(must(read_text(golden("task_plain_task.toml"))), "t.toml"));
  const std::string text = pose_task_text(task);
  const auto again = must(parse_pose_task(text, "again.toml"));
  EXPECT_EQ(pose_task_text(must(parse_pose_task(pose_task_text(again), "third.toml"))),
            pose_task_text(again));
  EXPECT_EQ(again.targets, task.targets);
  EXPECT_EQ(again.references[1].X_WR.p, task.references[1].X_WR.p);
  EXPECT_EQ(again.references[1].X_WR.q.coeffs(), task.references[1].X_WR.q.coeffs());
}

TEST(PoseTask, ItsClockBeginsWithTheFirstCueAndStandsStillInAGap) {
  PoseTask task;
  task.references = {{"far", {Vec3::UnitX(), Quat::Identity()}}};
  task.targets = {0};
  task.position_tolerance_m = task.angle_tolerance_rad = 0.1;
  task.time_limit_s = 100.0;
  PoseTaskRun run(task);
  const Pose here{Vec3::Zero(), Quat::Identity()};
  constexpr double kRounding_s = 1e-12;
  EXPECT_EQ(run.clock_s(3.0), 0.0);
  static_cast<void>(run.step(2.0, missing_pose()));
  EXPECT_FALSE(run.started());
  static_cast<void>(run.step(3.0, here));
  static_cast<void>(run.step(4.0, here));
  EXPECT_WITHIN(run.clock_s(4.0), 0.05, kRounding_s) << "a second passed, 50 ms of it counted";
  EXPECT_WITHIN(run.sought_s(4.0), 0.05, kRounding_s);
}

TEST(PoseTask, AFileThatIsWrongIsRefusedWithItsLine) {
  const std::string good = must(read_text(golden("task_plain_task.toml")));
  const auto with = [&good](const std::string& part, const std::string& instead) {
    std::string text = good;
    text.replace(text.find(part), part.size(), instead);
    return parse_pose_task(text, "t.toml");
  };
  for (const auto& [part, instead, what] :
       {std::tuple("repeats = 1", "repeats = 0", "repeats"),
        {"position_tolerance_m = 0.01", "position_tolerance_m = 0", "position_tolerance_m"},
        {"time_limit_s = 6.0", "time_limit_s = -1", "time_limit_s"},
        {"\"initial\", \"screw\"", "\"initial\", \"push\"", "'push' is no reference"},
        {"hold_s = 0.0", "hold_s = -1", "hold_s"}}) {
    const auto task = with(part, instead);
    ASSERT_FALSE(task) << part;
    EXPECT_NE(task.error().message().find(what), std::string::npos) << task.error().message();
  }
}

}  // namespace
}  // namespace isograsp::pose_task_test
