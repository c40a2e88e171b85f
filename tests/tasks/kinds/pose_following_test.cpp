// SPDX-License-Identifier: GPL-3.0-or-later
// A moving reference, and what is measured of an object that follows it.
#include "tasks/kinds/arm/pose_following.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "hand/arm_columns.hpp"
#include "tasks/score.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/reference_subject.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::pose_following_test {
namespace {

constexpr double kPeriod_s = 0.01;

PoseFollowingSpec turns() {
  PoseFollowingSpec spec;
  spec.postures = "screw";
  spec.sequence = {"initial", "screw", "initial", "unscrew"};
  spec.leg_s = 2.0;
  spec.rounds = 2;
  spec.lead_in_s = 1.0;
  return spec;
}

/// The reference at a time of the task's clock.
using Reference = std::function<Pose(double c_s)>;
Reference reference_of(const PoseFollowingSpec& spec) {
  TaskContext context;
  context.arm = test::reference_subject(test::spec_of(spec));
  std::vector<Pose> poses;
  auto task = test::must(make_task(test::spec_of(spec), context));
  for (int k = 0;; ++k) {
    const TaskView view = task->step(ArmInput{k * kPeriod_s, test::initial_pose(*context.arm)});
    if (view.phase == Phase::done) break;
    poses.push_back(view.arm().X_WR);
  }
  return [poses](double c_s) {
    const auto last = static_cast<double>(poses.size() - 1);
    return poses[static_cast<std::size_t>(std::clamp(std::round(c_s / kPeriod_s), 0.0, last))];
  };
}

/// A trial: the object is where `object` says at a time of the record; missing_pose(): not seen.
struct Trial {
  std::vector<TaskView> views;
  Signals signals{std::vector<std::string>{}};
  std::vector<Measure> measures;
  [[nodiscard]] const Measure& measure(std::string_view name, std::string_view channel) const {
    for (const Measure& one : measures)
      if (one.name == name && one.channel == channel) return one;
    throw std::runtime_error("no measure " + std::string(name));
  }
};
Trial trial(const PoseFollowingSpec& spec, const std::function<Pose(double t_s)>& object) {
  const TaskSpec task_spec = test::spec_of(spec);
  TaskContext context;
  context.period_s = kPeriod_s;
  context.arm = test::reference_subject(task_spec);
  const columns::OfSegment& segment = columns::segment_pose[index_of(ArmSegment::object)];
  std::vector<std::string> names{columns::t_s, columns::phase, columns::sample_flags};
  for (const auto& axes : {segment.position, columns::reference_position})
    for (const Column& column : axes) names.emplace_back(column);
  for (const auto& parts : {segment.attitude, columns::reference_attitude})
    for (const Column& column : parts) names.emplace_back(column);
  Trial made;
  made.signals = Signals(names);
  auto task = test::must(make_task(task_spec, context));
  double unseen_s = 0.0;
  for (int k = 0; k < 100000; ++k) {
    const double t_s = k * kPeriod_s;
    const Pose X_WO = object(t_s);
    const TaskView view = task->step(ArmInput{t_s, X_WO});
    made.views.push_back(view);
    unseen_s = is_missing(X_WO) ? unseen_s + kPeriod_s : 0.0;
    // As the session has it: the trial is paused while the object is out of sight.
    constexpr double kSlack_s = 1e-9;
    const bool paused = unseen_s > kLongestStandIn_s + kSlack_s;
    const Pose X_WR = view.arm().reference_shown ? view.arm().X_WR : missing_pose();
    std::vector<double> row{t_s, static_cast<double>(paused ? Phase::paused : view.phase),
                            unseen_s > 0.0 ? 1.0 : 0.0};
    for (const Pose* pose : {&X_WO, &X_WR})
      row.insert(row.end(), {pose->p.x(), pose->p.y(), pose->p.z()});
    for (const Pose* pose : {&X_WO, &X_WR})
      row.insert(row.end(), {pose->q.w(), pose->q.x(), pose->q.y(), pose->q.z()});
    made.signals.append_row(row);
    if (view.phase == Phase::done) {
      made.measures = score(task_spec, made.signals);
      return made;
    }
  }
  throw std::runtime_error("the task does not end");
}

constexpr double kExact = 1e-9;  // of the rounding of sums and of attitudes near each other

TEST(PoseFollowing, WhoIsOnTheReferenceHasNoErrorAndNoLag) {
  const Trial whole = trial(turns(), reference_of(turns()));
  EXPECT_WITHIN(whole.measure("rmse", "position").value.value(), 0.0, kExact);
  EXPECT_WITHIN(whole.measure("rmse", "attitude").value.value(), 0.0, 1e-7);
  EXPECT_WITHIN(whole.measure("lag", "position").value.value(), 0.0, kExact);
  EXPECT_WITHIN(whole.measure("lag", "attitude").value.value(), 0.0, kExact);
  EXPECT_EQ(whole.measure("seen", "object").value, 100.0);
  EXPECT_EQ(whole.measure("rmse", "position").samples, 1600) << "the lead-in is not scored";
}

TEST(PoseFollowing, TheLagIsPositiveForWhoComesLaterAndNegativeForWhoComesEarlier) {
  const Reference reference = reference_of(turns());
  for (const double late_s : {-0.3, -0.1, 0.1, 0.2, 0.4}) {
    const Trial late = trial(turns(), [&](double t_s) { return reference(t_s - late_s); });
    // A parabola through three samples of a correlation that is cut off at both ends.
    constexpr double kParabola_s = 0.002;
    EXPECT_WITHIN(late.measure("lag", "attitude").value.value(), late_s, kParabola_s);
    EXPECT_WITHIN(late.measure("lag", "position").value.value(), late_s, kParabola_s);
  }
}

TEST(PoseFollowing, AConstantErrorIsItsRmseAndNoLag) {
  const Reference reference = reference_of(turns());
  const Vec3 aside(0.003, -0.004, 0.012);
  const Quat turned(Eigen::AngleAxisd(0.1, Vec3::UnitY()));
  const Trial off = trial(turns(), [&](double t_s) {
    const Pose X_WR = reference(t_s);
    return Pose{X_WR.p + aside, X_WR.q * turned};
  });
  EXPECT_WITHIN(off.measure("rmse", "position").value.value(), 0.013, kExact);
  EXPECT_WITHIN(off.measure("rmse", "attitude").value.value(), 0.1, kExact);
  EXPECT_WITHIN(off.measure("lag", "position").value.value(), 0.0, kExact);
  EXPECT_LT(std::abs(off.measure("lag", "attitude").value.value()), 0.01);
}

TEST(PoseFollowing, OutOfSightTheReferenceStandsStillAndGoesOnWhereItStood) {
  const Reference reference = reference_of(turns());
  constexpr double kHiddenAt_s = 4.0;
  constexpr double kHidden_s = 1.0;
  double clock_s = 0.0;
  const Trial hidden = trial(turns(), [&](double t_s) {
    constexpr double kHalf_s = 0.5 * kPeriod_s;
    if (t_s > kHiddenAt_s - kHalf_s && t_s < kHiddenAt_s + kHidden_s - kHalf_s)
      return missing_pose();
    clock_s = t_s < kHiddenAt_s ? t_s : t_s - kHidden_s - kPeriod_s + kLongestStandIn_s;
    return reference(clock_s);
  });
  const Trial seen = trial(turns(), reference);
  const auto at = [](const Trial& of, double t_s) {
    return of.views[static_cast<std::size_t>(std::lround(t_s / kPeriod_s))];
  };
  EXPECT_WITHIN(at(hidden, 4.5).task_time_s, 4.04, kExact) << "50 ms after the last pose";
  EXPECT_EQ(at(hidden, 4.5).arm().X_WR.p, at(hidden, 4.9).arm().X_WR.p);
  // The gap is a second and the step to the next pose, of which 50 ms count.
  EXPECT_EQ(hidden.views.size(), seen.views.size() + 96);
  EXPECT_WITHIN(hidden.measure("rmse", "position").value.value(), 0.0, kExact);
  EXPECT_LT(hidden.measure("seen", "object").value.value(), 95.0);
}

TEST(PoseFollowing, WhoseObjectIsHardlySeenHasNoValueAndAReason) {
  const Reference reference = reference_of(turns());
  int row = 0;
  const Trial hardly =
      trial(turns(), [&](double) { return row++ % 4 == 0 ? reference(0.0) : missing_pose(); });
  EXPECT_LT(hardly.measure("seen", "object").value.value(), 50.0);
  for (const auto& [name, channel] : {std::pair{"rmse", "position"},
                                      {"rmse", "attitude"},
                                      {"lag", "position"},
                                      {"lag", "attitude"}}) {
    EXPECT_FALSE(hardly.measure(name, channel).value) << name << channel;
    EXPECT_EQ(hardly.measure(name, channel).reason,
              "the object was seen for less than half of the time");
  }
}

TEST(PoseFollowing, AReferenceThatHardlyMovesHasNoLag) {
  PoseFollowingSpec still = turns();
  still.sequence = {"initial", "initial"};
  const Trial whole = trial(still, reference_of(still));
  EXPECT_EQ(whole.measure("lag", "position").reason, "too short a way");
  EXPECT_EQ(whole.measure("lag", "attitude").reason, "too little rotation");
  EXPECT_TRUE(whole.measure("rmse", "attitude").value);
}

TEST(PoseFollowing, APartOfTheWayIsAPartOfTheTurn) {
  const auto turn_rad = [](double way) {
    PoseFollowingSpec spec = turns();
    spec.way = way;
    const Reference reference = reference_of(spec);
    return angle_between(reference(1.0).q, reference(1.0 + spec.leg_s).q);
  };
  EXPECT_GT(turn_rad(1.0), 0.5);
  // Three links turn about axes that are not the same.
  EXPECT_WITHIN(turn_rad(0.5) / turn_rad(1.0), 0.5, 0.02);
}

TEST(PoseFollowing, BeginsWhenTheObjectIsSeenAndAllocatesNothing) {
  const TaskSpec spec = test::spec_of(turns());
  TaskContext context;
  context.arm = test::reference_subject(spec);
  auto task = test::must(make_task(spec, context));
  const Pose here = test::initial_pose(*context.arm);
  constexpr int kUnseen = 50;
  std::vector<TaskView> views(250);
  const auto before = test::allocations();
  for (int k = 0; k < static_cast<int>(views.size()); ++k)
    views[static_cast<std::size_t>(k)] =
        task->step(ArmInput{k * kPeriod_s, k < kUnseen ? missing_pose() : here});
  EXPECT_EQ(test::allocations(), before);
  for (int k = 0; k < static_cast<int>(views.size()); ++k) {
    const TaskView& view = views[static_cast<std::size_t>(k)];
    EXPECT_EQ(view.arm().reference_shown, k >= kUnseen) << k;
    EXPECT_WITHIN(view.task_time_s, std::max(0, k - kUnseen) * kPeriod_s, kExact);
    EXPECT_EQ(view.phase, k < kUnseen + 100 ? Phase::lead_in : Phase::active) << k;
  }
}

TEST(PoseFollowing, WhatIsWrongIsSaidWithItsField) {
  const std::string head =
      "format = \"isograsp-task-1\"\nname = \"F\"\ninstruction = \"F.\"\nkind = "
      "\"pose_following\"\npostures = \"screw\"\n";
  const auto alone = parse_task(head + "sequence = [\"screw\"]\n", "f.toml");
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().field, "sequence");
  const auto fast =
      parse_task(head + "sequence = [\"screw\", \"initial\"]\nleg_s = 0.1\n", "f.toml");
  ASSERT_FALSE(fast);
  EXPECT_EQ(fast.error().field, "leg_s");
  PoseFollowingSpec unknown = turns();
  unknown.sequence = {"initial", "nowhere"};
  TaskContext context;
  EXPECT_EQ(make_task(test::spec_of(unknown), context).error().field, "start_posture");
  context.arm = test::reference_subject(test::spec_of(unknown));
  EXPECT_EQ(make_task(test::spec_of(unknown), context).error().field, "sequence");
}

}  // namespace
}  // namespace isograsp::tasks::pose_following_test
