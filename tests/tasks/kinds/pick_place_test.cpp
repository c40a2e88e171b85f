// SPDX-License-Identifier: GPL-3.0-or-later
// Pick, place and release: what counts as placed, what as a drop.
#include "tasks/kinds/object/pick_place.hpp"

#include <gtest/gtest.h>

#include "tasks/task.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::pick_place_test {
namespace {

constexpr double kPeriod_s = 0.01;
const Vec3 kStart_m(-0.05, 0.0, 0.0);
const Vec3 kGoal_m(0.05, 0.02, 0.0);
const Vec3 kHalfway_m(0.0, 0.0, 0.0);

/// One second of holding; two objects unless told otherwise.
PickPlaceSpec spec_of(std::size_t count = 2) {
  PickPlaceSpec spec;
  spec.scene = "planar_block_rate";
  spec.hold_s = 1.0;
  spec.time_limit_s = 5.0;
  spec.items.assign(count, {kStart_m, kGoal_m, 0.0});
  return spec;
}

/// A hand and an object that stays where it is put.
class Play {
 public:
  explicit Play(const PickPlaceSpec& spec) {
    TaskSpec task;
    task.kind = spec;
    TaskContext context;
    context.period_s = kPeriod_s;
    auto result = make_task(task, context);
    EXPECT_TRUE(result);
    task_ = std::move(*result);
  }

  /// Some frames with the object there; where the task puts it, it is.
  TaskView at(const Vec3& p_WO, bool touched, int frames = 1) {
    for (int frame = 0; frame < frames; ++frame) {
      object_.X_WO.p = p_WO;
      view_ = step(touched);
    }
    return view_;
  }
  /// Some frames in which the hand moves nothing.
  TaskView wait(int frames, bool touched = false) {
    for (int frame = 0; frame < frames; ++frame) view_ = step(touched);
    return view_;
  }
  /// The object appears, is picked up and carried to the goal.
  void carry() {
    wait(1);
    wait(10, true);
    at(kHalfway_m, true, 10);
  }
  [[nodiscard]] const ObjectState& object() const { return object_; }
  [[nodiscard]] int placements() const { return placements_; }

 private:
  TaskView step(bool touched) {
    ObjectInput input;
    input.object = &object_;
    input.contact = {touched, touched, false};
    const TaskView view = task_->step(input);
    if (view.object().object_placed) {
      object_ = {};
      object_.X_WO = view.object().placed_X_WO;
      ++placements_;
    }
    return view;
  }

  std::unique_ptr<Task> task_;
  ObjectState object_;
  TaskView view_;
  int placements_ = 0;
};

TEST(PickPlace, TheObjectAppearsAtItsPlaceAndItsTargetIsShown) {
  Play play(spec_of());
  const TaskView view = play.wait(1);
  EXPECT_TRUE(view.object().object_placed);
  EXPECT_EQ(play.object().X_WO.p, kStart_m);
  EXPECT_EQ(view.object().X_WT.p, kGoal_m);
  EXPECT_TRUE(view.object().pose_target_shown);
  EXPECT_EQ(view.target_index, 0);
  EXPECT_EQ(view.target_count, 2);
  EXPECT_EQ(view.cue, Cue::move);
}

TEST(PickPlace, HeldForItsTimeAndThenLetGoCountsAsPlaced) {
  Play play(spec_of());
  play.carry();
  TaskView view = play.at(kGoal_m, true, 100);  // 101 samples span a second
  EXPECT_EQ(view.phase, Phase::hold);
  EXPECT_EQ(view.cue, Cue::move);
  EXPECT_WITHIN(view.hold_fraction, 0.99, 1e-12);
  view = play.at(kGoal_m, true);
  EXPECT_EQ(view.cue, Cue::let_go);
  EXPECT_EQ(view.hold_fraction, 1.0);
  EXPECT_EQ(view.targets_reached, 0) << "not before it is let go";
  view = play.at(kGoal_m, true, 30);
  EXPECT_EQ(view.cue, Cue::let_go);
  view = play.at(kGoal_m, false);
  EXPECT_EQ(view.targets_reached, 1);
  EXPECT_EQ(view.object().drops, 0);
  view = play.wait(1);
  EXPECT_EQ(view.target_index, 1);
  EXPECT_TRUE(view.object().object_placed);
}

TEST(PickPlace, LettingGoTooEarlyIsNotPlacedAndTheHoldBeginsAnew) {
  Play play(spec_of());
  play.carry();
  play.at(kGoal_m, true, 100);
  TaskView view = play.at(kGoal_m, false, 5);
  EXPECT_EQ(view.targets_reached, 0);
  EXPECT_EQ(view.hold_fraction, 0.0);
  EXPECT_EQ(view.object().drops, 0) << "it lies at its target";
  view = play.at(kGoal_m, true, 100);
  EXPECT_EQ(view.cue, Cue::move);
  view = play.at(kGoal_m, true);
  EXPECT_EQ(view.cue, Cue::let_go);
  EXPECT_EQ(play.at(kGoal_m, false).targets_reached, 1);
}

TEST(PickPlace, LetGoTooEarlyAndGoneFromTheTargetIsADrop) {
  Play play(spec_of());
  play.carry();
  play.at(kGoal_m, true, 50);
  EXPECT_EQ(play.at(kGoal_m, false, 3).object().drops, 0);
  EXPECT_EQ(play.at(kHalfway_m, false).object().drops, 1) << "springs pulled it away";
}

TEST(PickPlace, ADropOnTheWayPutsTheObjectBackAndIsCountedOnce) {
  Play play(spec_of());
  play.carry();
  TaskView view = play.at(kHalfway_m, false);
  EXPECT_EQ(view.object().drops, 1);
  EXPECT_TRUE(view.object().object_placed);
  EXPECT_EQ(play.object().X_WO.p, kStart_m);
  EXPECT_EQ(view.target_index, 0) << "the same object again";
  view = play.wait(50);
  EXPECT_EQ(view.object().drops, 1);
  EXPECT_FALSE(view.object().object_placed);
  EXPECT_EQ(play.placements(), 2);
  play.wait(5, true);
  play.at(kHalfway_m, true, 5);
  EXPECT_EQ(play.at(kHalfway_m, false).object().drops, 2) << "a second drop counts again";
}

TEST(PickPlace, ATouchThatEndsNearTheStartIsNoDropUntilTheObjectGoesAway) {
  Play play(spec_of());
  play.wait(1);
  const Vec3 near_m = kStart_m + Vec3(0.015, 0.0, 0.0);
  play.at(near_m, true, 5);
  EXPECT_EQ(play.at(near_m, false, 20).object().drops, 0);
  EXPECT_EQ(play.at(kHalfway_m, false).object().drops, 1) << "it slid away by itself";
}

TEST(PickPlace, AnObjectThatNobodyTouchedIsNotDropped) {
  Play play(spec_of());
  play.wait(1);
  EXPECT_EQ(play.at(kHalfway_m, false, 20).object().drops, 0);
}

TEST(PickPlace, CarriedAwayAfterTheHoldAndLetGoThereIsADropNotPlaced) {
  Play play(spec_of());
  play.carry();
  EXPECT_EQ(play.at(kGoal_m, true, 101).cue, Cue::let_go);
  TaskView view = play.at(kHalfway_m, true);
  EXPECT_EQ(view.cue, Cue::move);
  EXPECT_EQ(view.hold_fraction, 0.0);
  view = play.at(kHalfway_m, false);
  EXPECT_EQ(view.targets_reached, 0);
  EXPECT_EQ(view.object().drops, 1);
}

TEST(PickPlace, TheTimeLimitOfEachObjectMovesToTheNextAndEndsTheTask) {
  Play play(spec_of());
  TaskView view = play.wait(500);
  EXPECT_EQ(view.target_index, 0);
  view = play.wait(1);
  EXPECT_EQ(view.target_index, 1);
  EXPECT_TRUE(view.object().object_placed);
  view = play.wait(499);
  EXPECT_EQ(view.phase, Phase::transport);
  view = play.wait(1);
  EXPECT_EQ(view.phase, Phase::done);
  EXPECT_EQ(view.cue, Cue::relax);
  EXPECT_EQ(view.targets_reached, 0);
  EXPECT_FALSE(view.object().object_placed);
  EXPECT_EQ(play.wait(10).phase, Phase::done);
}

TEST(PickPlace, TheTimeLimitRunsOnAfterADrop) {
  Play play(spec_of(1));
  play.carry();
  play.at(kHalfway_m, false);
  EXPECT_NE(play.wait(500 - 22).phase, Phase::done);
  EXPECT_EQ(play.wait(1).phase, Phase::done);
}

TEST(PickPlace, TheTargetsAngleCountsToo) {
  PickPlaceSpec spec = spec_of(1);
  spec.items[0].angle_rad = 2.0 * spec.angle_tolerance_rad;
  Play play(spec);
  play.carry();
  const TaskView view = play.at(kGoal_m, true, 200);
  EXPECT_EQ(view.phase, Phase::transport);
  EXPECT_EQ(view.cue, Cue::move);
}

TEST(PickPlace, WithoutAHoldItMayBeLetGoAtOnce) {
  PickPlaceSpec spec = spec_of(1);
  spec.hold_s = 0.0;
  Play play(spec);
  play.carry();
  EXPECT_EQ(play.at(kGoal_m, true).cue, Cue::let_go);
  EXPECT_EQ(play.at(kGoal_m, false).targets_reached, 1);
}

TEST(PickPlace, PlacingIsTheSameAtEveryFrameRate) {
  for (const double rate_Hz : {60.0, 100.0, 500.0}) {
    TaskSpec task;
    task.kind = spec_of(1);
    TaskContext context;
    context.period_s = 1.0 / rate_Hz;
    const auto made = make_task(task, context);
    ASSERT_TRUE(made);
    ObjectState object;
    object.X_WO.p = kGoal_m;
    double let_go_s = -1.0;
    for (int frame = 0; let_go_s < 0.0 && frame < 5.0 * rate_Hz; ++frame) {
      ObjectInput input;
      input.object = &object;
      input.contact = {frame > 0, false, false};
      const TaskView view = (*made)->step(input);
      if (view.cue == Cue::let_go) let_go_s = view.task_time_s;
    }
    EXPECT_WITHIN(let_go_s, 1.0 + 1.0 / rate_Hz, 1e-12)
        << "one frame to appear, one second to hold";
  }
}

TEST(PickPlace, NeverAllocates) {
  Play play(spec_of());
  const std::uint64_t before = test::allocations();
  play.carry();
  play.at(kHalfway_m, false);
  play.carry();
  play.at(kGoal_m, true, 101);
  play.at(kGoal_m, false);
  play.wait(600);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::tasks::pick_place_test
