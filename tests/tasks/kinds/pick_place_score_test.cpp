// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of pick, place and release, on records played through the state machine.
#include <gtest/gtest.h>

#include "tasks/kinds/object/pick_place.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/kinds/object_play.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::pick_place_score_test {
namespace {

using test::edited;
using test::find;
using test::Handled;
using test::play_object;
using test::value_of;

TaskSpec placing(std::size_t count) {
  PickPlaceSpec spec;
  spec.scene = "planar_block_rate";
  spec.hold_s = 0.5;
  spec.time_limit_s = 5.0;
  spec.items.assign(count, {Vec3(-0.05, 0.0, 0.0), Vec3(0.05, 0.0, 0.0), 0.0});
  TaskSpec task;
  task.kind = spec;
  return task;
}

/// Carries every object straight to 6 mm beside its target in steps of 1 mm and lets go when asked.
struct Hand {
  int drop_frame = -1;   ///< lets go once in this frame
  int idle_from = 1000;  ///< does nothing from this item on
  int frame = 0;
  Handled operator()(const TaskView& view, const Pose& object) {
    Handled now;
    now.X_WO = object;
    const int k = frame++;
    now.contact = view.cue != Cue::let_go && k != drop_frame && view.target_index < idle_from;
    if (!now.contact || !view.object().pose_target_shown || view.object().object_placed) return now;
    const double left_m = 0.044 - object.p.x();
    if (left_m > 0.0) now.X_WO.p.x() += std::min(0.001, left_m);
    return now;
  }
};

TEST(ScorePickPlace, AStraightTrialHasTheMeasuresOfItsGeometry) {
  const TaskSpec spec = placing(2);
  const auto measures = score(spec, play_object(spec, Hand{}));
  EXPECT_EQ(value_of(measures, "targets_reached"), 2.0);
  EXPECT_EQ(find(measures, "targets_reached")->unit, "of 2");
  EXPECT_EQ(value_of(measures, "drops"), 0.0);
  EXPECT_WITHIN(value_of(measures, "path_efficiency"), 100.0, 1e-9);
  // 81 frames to 20 mm from the target, half a second held, on its way during that.
  EXPECT_WITHIN(value_of(measures, "completion_time", "target_1"), 1.33, 0.02);
  EXPECT_WITHIN(value_of(measures, "median_completion_time"),
                value_of(measures, "completion_time", "target_1"), 0.02);
  EXPECT_LE(value_of(measures, "restricted_mean_time"), 1.36);
  EXPECT_GT(value_of(measures, "hold_error_position"), 0.006);
  EXPECT_LT(value_of(measures, "hold_error_position"), 0.010);
  EXPECT_WITHIN(value_of(measures, "hold_error_angle"), 0.0, 1e-12);
  EXPECT_WITHIN(value_of(measures, "mean_grip"), 3.0, 1e-12);
}

TEST(ScorePickPlace, ADropIsCountedAndOnlyTheLastWayIsMeasured) {
  const TaskSpec spec = placing(1);
  Hand clumsy;
  clumsy.drop_frame = 50;
  const auto measures = score(spec, play_object(spec, clumsy));
  const auto clean = score(spec, play_object(spec, Hand{}));
  EXPECT_EQ(value_of(measures, "drops"), 1.0);
  EXPECT_EQ(value_of(measures, "targets_reached"), 1.0);
  EXPECT_WITHIN(value_of(measures, "path_efficiency"), 100.0, 1e-9)
      << "the jump back is no movement";
  EXPECT_WITHIN(value_of(measures, "completion_time", "target_1"),
                value_of(clean, "completion_time", "target_1") + 0.5, 0.03);
}

TEST(ScorePickPlace, WhatWasNotPlacedInTimeIsCensored) {
  const TaskSpec spec = placing(3);
  Hand stops;
  stops.idle_from = 1;
  const auto measures = score(spec, play_object(spec, stops));
  EXPECT_EQ(value_of(measures, "targets_reached"), 1.0);
  EXPECT_EQ(find(measures, "completion_time", "target_2")->reason, "not reached within 5 s");
  EXPECT_EQ(find(measures, "median_completion_time")->reason, "longer than the limit");
  const double first_s = value_of(measures, "completion_time", "target_1");
  EXPECT_WITHIN(value_of(measures, "restricted_mean_time"), (first_s + 2.0 * 5.0) / 3.0, 1e-9);
}

TEST(ScorePickPlace, WhenNothingWasPlacedEveryMeasureOfPlacingSaysSo) {
  const TaskSpec spec = placing(2);
  Hand idle;
  idle.idle_from = 0;
  const auto measures = score(spec, play_object(spec, idle));
  EXPECT_EQ(value_of(measures, "targets_reached"), 0.0);
  for (const char* name : {"path_efficiency", "hold_error_position", "hold_error_angle"})
    EXPECT_EQ(find(measures, name)->reason, "nothing was placed") << name;
  EXPECT_WITHIN(value_of(measures, "restricted_mean_time"), 5.0, 1e-9);
}

TEST(ScorePickPlace, AnAbortedTrialIsNotATimeOut) {
  const TaskSpec spec = placing(2);
  const Signals cut =
      edited(play_object(spec, Hand{}), [](std::size_t k, std::vector<double>& row) {
        if (k >= 50) row.clear();
      });
  const auto measures = score(spec, cut);
  EXPECT_EQ(find(measures, "completion_time", "target_1")->reason,
            "the trial ended before it was reached");
  EXPECT_EQ(find(measures, "completion_time", "target_2")->reason,
            "the trial ended before this target");
  EXPECT_FALSE(find(measures, "restricted_mean_time")->value);
}

TEST(ScorePickPlace, WithoutItsColumnsAMeasureSaysWhichIsMissing) {
  Signals signals({"t_s", "phase"});
  for (int k = 0; k < 100; ++k) {
    const double row[] = {0.01 * k, 2.0};
    signals.append_row(row);
  }
  for (const Measure& measure : test::every(score(placing(1), signals))) {
    EXPECT_FALSE(measure.value) << measure.name;
    EXPECT_NE(measure.reason.find("missing"), std::string::npos) << measure.name;
  }
}

TEST(ScorePickPlace, AnObjectThatLeansHasThatErrorOfItsAxisAndOneThatTurnsOnTheScreenHasNone) {
  const TaskSpec spec = placing(1);
  constexpr double kLean_rad = 0.1;
  for (const Vec3& about : {Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.0, 1.0)}) {
    Hand hand;
    const auto measures =
        score(spec, play_object(spec, [&](const TaskView& view, const Pose& object) {
                Handled now = hand(view, object);
                now.X_WO.q = Quat(Eigen::AngleAxisd(kLean_rad, about));
                return now;
              }));
    EXPECT_WITHIN(value_of(measures, "hold_error_angle"), kLean_rad, 1e-9);
    if (about.x() > 0.0)
      EXPECT_WITHIN(value_of(measures, "hold_error_axis"), kLean_rad, 1e-9);
    else
      EXPECT_EQ(find(measures, "hold_error_axis"), nullptr);
  }
}

}  // namespace
}  // namespace isograsp::tasks::pick_place_score_test
