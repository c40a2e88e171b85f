// SPDX-License-Identifier: GPL-3.0-or-later
// Force tasks as timelines: what is shown when, and what is refused before the trial.
#include "tasks/timeline.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "tasks/kinds/force/directional_maxima.hpp"
#include "tasks/kinds/force/fatigue.hpp"
#include "tasks/kinds/force/force_direction.hpp"
#include "tasks/kinds/force/force_sense.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/kinds/force/grip_release.hpp"
#include "tasks/kinds/force/individuation.hpp"
#include "tasks/kinds/force/maximum.hpp"
#include "tasks/kinds/force/rest.hpp"
#include "tasks/kinds/force/steadiness.hpp"
#include "tasks/kinds/force/step_response.hpp"
#include "tasks/waveform.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::timeline_test {
namespace {

using test::spec_of;

TaskContext context_of(double maximum_N = 40.0) {
  TaskContext context;
  context.seed = 5;
  for (int digits = 0; digits <= static_cast<int>(Digits::middle); ++digits)
    for (const Direction direction : {Direction::plus_z, Direction::minus_z})
      context.references.maximum_N[{static_cast<Digits>(digits), direction}] = maximum_N;
  return context;
}
std::vector<TaskSpec> every_force_task() {
  DirectionalMaximaSpec directions;
  directions.digits = {Finger::thumb, Finger::index};
  directions.directions = {Direction::plus_x, Direction::minus_z};
  ForceDirectionSpec force_direction;
  ForceDirectionTarget target;
  target.asked[0] = true;
  target.direction_C[0] = Vec3::UnitZ();
  force_direction.targets = {target};
  return {spec_of(RestSpec{}),          spec_of(MaximumSpec{}),    spec_of(directions),
          spec_of(ForceTrackingSpec{}), spec_of(SteadinessSpec{}), spec_of(StepResponseSpec{}),
          spec_of(GripReleaseSpec{}),   spec_of(ForceSenseSpec{}), spec_of(FatigueSpec{}),
          spec_of(IndividuationSpec{}), spec_of(force_direction)};
}

TEST(Timeline, EveryTaskLastsAsLongAsItsSegmentsAndAllocatesNothing) {
  const TaskContext context = context_of();
  for (const TaskSpec& spec : test::every(every_force_task())) {
    const auto timeline = timeline_of(spec, context);
    ASSERT_TRUE(timeline) << timeline.error().message();
    const auto task = play(*timeline, context);
    const auto before = test::allocations();
    std::int64_t frames = 0;
    int segment = 0;
    while (true) {
      const TaskView view = task->step({});
      if (view.phase == Phase::done) break;
      EXPECT_GE(view.segment, segment) << "segments follow each other";
      segment = view.segment;
      ++frames;
    }
    EXPECT_EQ(test::allocations(), before);
    EXPECT_EQ(frames, timeline->frames());
    const double duration_s = static_cast<double>(frames) * context.period_s;
    constexpr double kEstimate_s = 1.0;  // durations are estimated in steps of 0.1 s per segment
    EXPECT_LE(duration_s, spec.duration().worst_s + kEstimate_s);
    EXPECT_LE(spec.duration().nominal_s, spec.duration().worst_s);
  }
}

TEST(Timeline, TargetsScaleWithTheReferenceOfTheirChannel) {
  const TaskContext weak = context_of(20.0);
  const TaskContext strong = context_of(40.0);
  for (const TaskSpec& spec : test::every(every_force_task())) {
    const auto a = timeline_of(spec, weak).value();
    const auto b = timeline_of(spec, strong).value();
    ASSERT_EQ(a.segments.size(), b.segments.size());
    for (std::size_t i = 0; i < a.segments.size(); ++i) {
      ASSERT_EQ(a.segments[i].target_N.size(), b.segments[i].target_N.size());
      constexpr double kRounding_N = 1e-12;
      for (std::size_t k = 0; k < a.segments[i].target_N.size(); ++k)
        EXPECT_WITHIN(2.0 * a.segments[i].target_N[k], b.segments[i].target_N[k], kRounding_N);
    }
  }
}

TEST(Timeline, ForeperiodsDifferWithinTheirLimitsAndFollowTheSeed) {
  GripReleaseSpec spec;
  spec.repetitions = 20;
  const auto waits = [&](std::uint64_t seed) {
    TaskContext context = context_of();
    context.seed = seed;
    std::vector<std::int64_t> frames;
    for (const Segment& segment : timeline_of(spec_of(spec), context).value().segments)
      if (segment.phase == Phase::hold) frames.push_back(segment.frames);
    return frames;
  };
  const auto some = waits(1);
  EXPECT_EQ(some, waits(1));
  EXPECT_NE(some, waits(2));
  EXPECT_GT(std::set<std::int64_t>(some.begin(), some.end()).size(), 15u);
  for (const auto frames : test::every(some)) {
    EXPECT_GE(frames, 100);
    EXPECT_LE(frames, 301);
  }
}

TEST(Timeline, AForceMadeAgainIsNeitherShownNorItsTarget) {
  const auto timeline = timeline_of(spec_of(ForceSenseSpec{}), context_of()).value();
  int reproductions = 0;
  for (const Segment& segment : test::every(timeline.segments)) {
    if (segment.cue != Cue::reproduce) continue;
    ++reproductions;
    EXPECT_FALSE(segment.force_shown);
    EXPECT_FALSE(segment.target_shown);
    EXPECT_EQ(segment.target_N, std::vector<double>{8.0});
  }
  EXPECT_EQ(reproductions, 3);
}

TEST(Timeline, WhatTheHandMayNotBeAskedIsRefusedWithARemedy) {
  const TaskSpec sine = spec_of(ForceTrackingSpec{});  // up to 12 N of 40 N
  TaskContext context = context_of();
  context.references.ceiling_N = 11.0;
  EXPECT_NE(english(timeline_of(sine, context).error().what).find("ceiling"), std::string::npos);
  context.references.ceiling_N = 12.0;
  EXPECT_TRUE(timeline_of(sine, context));
  context.references.allowed = Effort::comfortable;
  EXPECT_TRUE(timeline_of(sine, context));
  EXPECT_FALSE(timeline_of(spec_of(MaximumSpec{}), context));
  EXPECT_FALSE(timeline_of(spec_of(FatigueSpec{}), context));
  MaximumSpec comfortable;
  comfortable.comfortable = true;
  EXPECT_TRUE(timeline_of(spec_of(comfortable), context));
  context.references.allowed = Effort::none;
  EXPECT_FALSE(timeline_of(sine, context));
  EXPECT_TRUE(timeline_of(spec_of(RestSpec{}), context)) << "resting is no effort";
}

TEST(Timeline, ATargetThatTheSensorsCannotResolveIsRefusedWithTheLeastLevel) {
  const TaskSpec sine = spec_of(ForceTrackingSpec{});  // band of 5 % of 30 %
  TaskContext context = context_of(40.0);
  context.references.resolution_N = 0.12;  // five steps: 0.6 N = 5 % of 12 N
  EXPECT_TRUE(timeline_of(sine, context));
  context.references.resolution_N = 0.13;
  const auto refused = timeline_of(sine, context);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().field, "band_fraction");
  EXPECT_NE(english(refused.error().remedy).find("13 N"), std::string::npos)
      << english(refused.error().remedy);
  context.references.resolution_N = 0.0;
  context.references.noise_sd_N.emplace();
  context.references.noise_sd_N->fill(Vec3::Constant(0.2 / std::sqrt(2.0)));
  EXPECT_TRUE(timeline_of(sine, context)) << "three times 0.2 N";
  context.references.noise_sd_N->fill(Vec3::Constant(0.21 / std::sqrt(2.0)));
  EXPECT_FALSE(timeline_of(sine, context));
}

TEST(Timeline, ATargetFromAFileThatWasNotLoadedIsRefused) {
  ForceTrackingSpec spec;
  spec.waveform.shape = Waveform::Shape::csv;
  spec.waveform.csv = "target.csv";
  EXPECT_EQ(timeline_of(spec_of(spec), context_of()).error().field, "csv");
  spec.waveform.t_s = {0.0, 10.0};
  spec.waveform.values = {0.0, 1.0};
  const auto timeline = timeline_of(spec_of(spec), context_of()).value();
  constexpr double kRounding_N = 1e-12;
  EXPECT_WITHIN(timeline.segments[1].target_N.at(500), 8.0, kRounding_N)
      << "half way from 4 to 12 N";
  EXPECT_WITHIN(timeline.segments[1].target_N.back(), 12.0, kRounding_N);
}

TEST(Timeline, AFixedLoadIsThatOfTheBaselineAndAtMostHalfOfToday) {
  ForceTrackingSpec spec;
  spec.aim.scale = Scale::of_baseline;
  TaskContext context = context_of(40.0);
  EXPECT_FALSE(timeline_of(spec_of(spec), context)) << "there is no baseline yet";
  context.references.baseline_N[{}] = 50.0;
  const auto timeline = timeline_of(spec_of(spec), context).value();
  EXPECT_DOUBLE_EQ(timeline.segments[0].target_N.front(), 5.0);
  context.references.maximum_N[{}] = 29.0;
  EXPECT_FALSE(timeline_of(spec_of(spec), context)) << "15 N is more than half of 29 N";
}

TEST(Waveform, EveryShapeStaysBetweenLeastAndMostAndBeginsWithoutAJump) {
  for (int shape = 0; shape < static_cast<int>(Waveform::Shape::csv); ++shape) {
    Waveform wave;
    wave.shape = static_cast<Waveform::Shape>(shape);
    wave.frequencies = {0.1, 0.3};
    constexpr double kPeriod_s = 0.01;
    const auto x = samples_of(wave, 30.0, kPeriod_s, 3);
    ASSERT_EQ(x.size(), 3000u);
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_GE(x[k], 0.0);
      EXPECT_LE(x[k], 1.0 + 1e-12);
      // Nothing but a rectangle moves faster than a 5 Hz sine of full range could.
      const bool jumps = wave.shape == Waveform::Shape::rectangle;
      if (k > 0 && !jumps) {
        EXPECT_LT(std::abs(x[k] - x[k - 1]), 16.0 * kPeriod_s) << name_of(wave.shape);
      }
    }
  }
}

TEST(Waveform, TheFrameRateDoesNotChangeTheTarget) {
  for (int shape = 0; shape < static_cast<int>(Waveform::Shape::multi_sine); ++shape) {
    Waveform wave;
    wave.shape = static_cast<Waveform::Shape>(shape);
    const auto slow = samples_of(wave, 20.0, 0.01, 3);
    const auto fast = samples_of(wave, 20.0, 0.002, 3);
    constexpr double kRounding = 1e-9;  // a rectangle may switch one fast frame apart
    for (std::size_t k = 0; k < slow.size(); ++k)
      if (wave.shape != Waveform::Shape::rectangle) {
        ASSERT_WITHIN(slow[k], fast[5 * k], kRounding) << name_of(wave.shape);
      }
  }
}

TEST(Waveform, ASeededSequenceRepeatsAndAFreshOneDoesNot) {
  Waveform repeated;
  repeated.shape = Waveform::Shape::random;
  repeated.seed = 9;
  Waveform fresh = repeated;
  fresh.seed.reset();
  EXPECT_EQ(samples_of(repeated, 20.0, 0.01, 1), samples_of(repeated, 20.0, 0.01, 2));
  EXPECT_NE(samples_of(fresh, 20.0, 0.01, 1), samples_of(fresh, 20.0, 0.01, 2));
  EXPECT_EQ(samples_of(fresh, 20.0, 0.01, 1), samples_of(fresh, 20.0, 0.01, 1));
}

/// Mean, and root mean square of the change from one sample to the next, around the cycle.
std::pair<double, double> mean_and_speed(const std::vector<double>& x) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double change = x[(k + 1) % x.size()] - x[k];
    sum += x[k];
    squares += change * change;
  }
  const auto n = static_cast<double>(x.size());
  return {sum / n, std::sqrt(squares / n)};
}

/// One trial of each parallel form, by form.
std::map<int, std::vector<double>> every_form(const Waveform& wave, double duration_s) {
  std::map<int, std::vector<double>> forms;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    forms.try_emplace(form_of(wave, seed), samples_of(wave, duration_s, 0.01, seed));
  return forms;
}

TEST(Waveform, ParallelFormsTakeTheSameValuesAtTheSameSpeedsInAnotherOrder) {
  for (const auto shape : {Waveform::Shape::sine, Waveform::Shape::triangle})
    for (const int count : {2, 3, 4}) {
      Waveform wave;
      wave.shape = shape;
      wave.forms = count;
      const auto forms = every_form(wave, 30.0);
      ASSERT_EQ(forms.size(), static_cast<std::size_t>(count)) << "every form is reached";
      const auto [mean, speed] = mean_and_speed(forms.at(0));
      for (const auto& [form, x] : test::every(forms)) {
        const auto [its_mean, its_speed] = mean_and_speed(x);
        constexpr double kRounding = 1e-12;
        EXPECT_WITHIN(its_mean, mean, kRounding) << name_of(shape) << ' ' << form;
        // A corner of the triangle may lie between two samples: 12 corners, one change of 4e-3
        // each.
        constexpr double kCorners = 1e-5;
        EXPECT_WITHIN(its_speed, speed, kCorners) << name_of(shape) << ' ' << form;
        const double start = static_cast<double>(form) / count;
        EXPECT_WITHIN(x.front(),
                      shape == Waveform::Shape::sine
                          ? 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * start))
                          : 1.0 - std::abs(2.0 * start - 1.0),
                      kRounding);
        EXPECT_EQ(x == forms.at(0), form == 0);
      }
    }
}

TEST(Waveform, TwoFormsMirrorEachOtherAndBothBeginAtRest) {
  Waveform wave;
  wave.forms = 2;
  const auto forms = every_form(wave, 30.0);
  for (std::size_t k = 0; k < forms.at(0).size(); ++k)
    ASSERT_WITHIN(forms.at(1)[k], 1.0 - forms.at(0)[k], 1e-12);
  constexpr double kAtRest = 1e-4;  // of a change of up to 6e-3 a sample: the curve's top is flat
  EXPECT_WITHIN(forms.at(1)[1], forms.at(1)[0], kAtRest);
}

TEST(Waveform, FormZeroAndASingleFormAreTheCurveThatBeginsAtTheLeastBitForBit) {
  Waveform wave;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto single = samples_of(wave, 30.0, 0.01, seed);
    for (std::size_t k = 0; k < single.size(); ++k) {
      const double t_s = static_cast<double>(k) * 0.01;
      ASSERT_EQ(single[k], 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * (0.2 * t_s))));
    }
    Waveform several = wave;
    several.forms = 4;
    EXPECT_EQ(form_of(several, seed) == 0, samples_of(several, 30.0, 0.01, seed) == single);
    EXPECT_EQ(samples_of(several, 30.0, 0.01, seed), samples_of(several, 30.0, 0.01, seed));
  }
}

TEST(Waveform, EveryFormIsAsLikely) {
  Waveform wave;
  wave.forms = 4;
  std::array<int, 4> count{};
  for (std::uint64_t seed = 0; seed < 4000; ++seed)
    ++count.at(static_cast<std::size_t>(form_of(wave, seed)));
  for (const int each : count) EXPECT_WITHIN(each, 1000, 110) << "four standard deviations";
}

TEST(Timeline, TheLeadInHoldsTheFirstValueOfEveryForm) {
  ForceTrackingSpec spec;
  spec.waveform.forms = 4;
  std::set<int> seen;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    TaskContext context = context_of();
    context.seed = seed;
    const auto timeline = timeline_of(spec_of(spec), context).value();
    for (const double held_N : test::every(timeline.segments[0].target_N))
      ASSERT_EQ(held_N, timeline.segments[1].target_N.front());
    seen.insert(form_of(spec.waveform, seed));
  }
  EXPECT_EQ(seen.size(), 4u);
}

}  // namespace
}  // namespace isograsp::tasks::timeline_test
