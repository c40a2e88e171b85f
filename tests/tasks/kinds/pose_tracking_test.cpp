// SPDX-License-Identifier: GPL-3.0-or-later
// The moving target: it is its waveform, whatever the frame rate.
#include "tasks/kinds/object/pose_tracking.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tasks/task.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::pose_tracking_test {
namespace {

using Axis = PoseTrackingSpec::Axis;
constexpr double kTurn_rad = 2.0 * std::numbers::pi;

Waveform sine(double frequency_Hz) {
  Waveform waveform;
  waveform.frequency_Hz = frequency_Hz;
  return waveform;
}
Waveform shaped(Waveform::Shape shape) {
  Waveform waveform;
  waveform.shape = shape;
  return waveform;
}

PoseTrackingSpec tracking(std::vector<Axis> axes) {
  PoseTrackingSpec spec;
  spec.scene = "planar_block";
  spec.lead_in_s = 1.0;
  spec.duration_s = 10.0;
  spec.axes = std::move(axes);
  return spec;
}

std::unique_ptr<Task> made(const PoseTrackingSpec& spec, double rate_Hz, std::uint64_t seed = 7) {
  TaskSpec task;
  task.kind = spec;
  TaskContext context;
  context.period_s = 1.0 / rate_Hz;
  context.seed = seed;
  auto result = make_task(task, context);
  EXPECT_TRUE(result);
  return std::move(*result);
}

/// Every view until it is done.
std::vector<TaskView> played(const PoseTrackingSpec& spec, double rate_Hz, std::uint64_t seed = 7) {
  const auto task = made(spec, rate_Hz, seed);
  std::vector<TaskView> views;
  for (TaskView view = task->step({}); view.phase != Phase::done; view = task->step({}))
    views.push_back(view);
  return views;
}

double angle_about(const Quat& q, int axis) {
  return 2.0 * std::atan2(q.vec()[axis], q.w());
}

TEST(PoseTracking, TheTargetIsItsWaveformInEveryDegreeOfFreedomAtEveryRate) {
  const auto spec = tracking({{0, -0.05, 0.05, sine(0.2)},
                              {1, 0.0, 0.04, sine(0.5)},
                              {2, 0.03, 0.01, sine(0.3)},
                              {5, -1.0, 1.0, sine(0.1)}});
  const auto value = [](const Axis& axis, double t_s) {
    return std::lerp(axis.least, axis.most,
                     0.5 * (1.0 - std::cos(kTurn_rad * axis.waveform.frequency_Hz * t_s)));
  };
  constexpr double kRounding = 1e-13;
  for (const double rate_Hz : {60.0, 100.0, 500.0}) {
    const auto views = played(spec, rate_Hz);
    ASSERT_EQ(views.size(), static_cast<std::size_t>(11.0 * rate_Hz));
    for (std::size_t k = 0; k < views.size(); ++k) {
      const double t_s = std::max(0.0, static_cast<double>(k) / rate_Hz - spec.lead_in_s);
      for (int axis = 0; axis < 3; ++axis)
        ASSERT_WITHIN(views[k].object().X_WT.p[axis],
                      value(spec.axes[static_cast<std::size_t>(axis)], t_s), kRounding);
      ASSERT_WITHIN(angle_about(views[k].object().X_WT.q, 2), value(spec.axes[3], t_s), kRounding);
      ASSERT_TRUE(views[k].object().pose_target_shown);
      ASSERT_EQ(views[k].cue, Cue::move);
    }
  }
}

TEST(PoseTracking, EveryShapeHasTheSameValuesAtTheSameTimesAtEveryRate) {
  Waveform csv = shaped(Waveform::Shape::csv);
  csv.t_s = {0.0, 3.0, 7.0};
  csv.values = {0.0, 1.0, 0.5};
  for (const Waveform& waveform :
       {shaped(Waveform::Shape::constant), shaped(Waveform::Shape::ramp),
        shaped(Waveform::Shape::trapezoid), shaped(Waveform::Shape::triangle),
        shaped(Waveform::Shape::swept_sine), shaped(Waveform::Shape::rectangle), csv}) {
    const auto spec = tracking({{0, -0.05, 0.05, waveform}});
    const auto slow = played(spec, 100.0);
    const auto fast = played(spec, 500.0);
    constexpr double kRounding_m = 1e-14;
    for (std::size_t k = 0; k < slow.size(); ++k)
      ASSERT_WITHIN(slow[k].object().X_WT.p.x(), fast[5 * k].object().X_WT.p.x(), kRounding_m)
          << name_of(waveform.shape) << ' ' << k;
  }
}

TEST(PoseTracking, ASequenceHasTheSameMovementAtEveryRateUpToItsSampledExtremes) {
  for (const auto shape : {Waveform::Shape::random, Waveform::Shape::multi_sine}) {
    Waveform waveform = shaped(shape);
    waveform.frequencies = {0.1, 0.3, 0.5};
    const auto spec = tracking({{0, 0.0, 1.0, waveform}});
    const auto slow = played(spec, 100.0);
    const auto fast = played(spec, 500.0);
    // Between samples of the slow grid a sum of sines up to 0.5 Hz rises by less than this.
    constexpr double kExtremes = 1e-3;
    for (std::size_t k = 0; k < slow.size(); ++k)
      ASSERT_WITHIN(slow[k].object().X_WT.p.x(), fast[5 * k].object().X_WT.p.x(), kExtremes);
  }
}

TEST(PoseTracking, TheLeadInHoldsTheFirstValueAndTheTargetDoesNotJump) {
  const auto spec = tracking({{0, 0.02, 0.05, sine(0.2)}});
  const auto views = played(spec, 100.0);
  double before_m = 0.02;
  for (std::size_t k = 0; k < views.size(); ++k) {
    EXPECT_EQ(views[k].phase, k < 100 ? Phase::lead_in : Phase::active);
    if (k < 100) {
      EXPECT_EQ(views[k].object().X_WT.p.x(), 0.02);
    }
    const double fastest_m = 0.03 * std::numbers::pi * 0.2 * 0.01 * 1.001;
    EXPECT_LE(std::abs(views[k].object().X_WT.p.x() - before_m), fastest_m);
    before_m = views[k].object().X_WT.p.x();
  }
}

TEST(PoseTracking, DegreesOfFreedomThatAreNotAskedForStayAtTheOrigin) {
  for (const TaskView& view : test::every(played(tracking({{4, -0.5, 0.5, sine(0.2)}}), 100.0))) {
    ASSERT_EQ(view.object().X_WT.p, Vec3::Zero());
    ASSERT_EQ(view.object().X_WT.q.x(), 0.0);
    ASSERT_EQ(view.object().X_WT.q.z(), 0.0);
    ASSERT_WITHIN(view.object().X_WT.q.norm(), 1.0, 1e-15);
  }
}

TEST(PoseTracking, ATargetThatJumpsHasItsTwoEndsAndNothingBetween) {
  Waveform jumps = shaped(Waveform::Shape::rectangle);
  jumps.frequency_Hz = 0.25;
  int changes = 0;
  double before_m = -0.05;
  for (const TaskView& view : test::every(played(tracking({{0, -0.05, 0.05, jumps}}), 100.0))) {
    const double x_m = view.object().X_WT.p.x();
    ASSERT_TRUE(x_m == -0.05 || x_m == 0.05) << x_m;
    changes += x_m != before_m ? 1 : 0;
    before_m = x_m;
  }
  EXPECT_EQ(changes, 4) << "at 2, 4, 6 and 8 s of ten";
}

TEST(PoseTracking, FreshSequencesDifferBetweenTrialsAndAxesSeededOnesDoNot) {
  Waveform random = shaped(Waveform::Shape::random);
  auto spec = tracking({{0, -0.05, 0.05, random}, {1, -0.05, 0.05, random}});
  const auto differs = [&](const auto& a, const auto& b, int axis_a, int axis_b) {
    double most_m = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
      most_m =
          std::max(most_m, std::abs(a[k].object().X_WT.p[axis_a] - b[k].object().X_WT.p[axis_b]));
    return most_m > 0.01;
  };
  const auto first = played(spec, 100.0, 1);
  EXPECT_TRUE(differs(first, played(spec, 100.0, 2), 0, 0));
  EXPECT_TRUE(differs(first, first, 0, 1)) << "two axes do not move alike";
  EXPECT_FALSE(differs(first, played(spec, 100.0, 1), 0, 0));
  spec.axes[0].waveform.seed = 3;
  EXPECT_FALSE(differs(played(spec, 100.0, 1), played(spec, 100.0, 2), 0, 0));
}

TEST(PoseTracking, StaysDoneAndRelaxedAndNeverAllocates) {
  const auto task = made(tracking({{0, -0.05, 0.05, sine(0.2)}, {5, -1.0, 1.0, sine(0.1)}}), 100.0);
  const std::uint64_t before = test::allocations();
  TaskView view;
  for (int frame = 0; frame < 1200; ++frame) view = task->step({});
  EXPECT_EQ(test::allocations(), before);
  EXPECT_EQ(view.phase, Phase::done);
  EXPECT_EQ(view.cue, Cue::relax);
  EXPECT_FALSE(view.object().pose_target_shown);
  EXPECT_EQ(view.task_time_s, view.duration_s);
}

}  // namespace
}  // namespace isograsp::tasks::pose_tracking_test
