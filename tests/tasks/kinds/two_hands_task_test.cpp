// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks of two hands: what is asked of each, what is refused, and the laws of their measures.
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tasks/kinds/two_hands/bilateral_maximum.hpp"
#include "tasks/kinds/two_hands/bilateral_rest.hpp"
#include "tasks/kinds/two_hands/bilateral_tracking.hpp"
#include "tasks/kinds/two_hands/mirror.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/tasks/kinds/hands_play.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::two_hands_task_test {
namespace {

constexpr double kFrame_s = 0.01;
constexpr double kRounding = 1e-9;  // of sums over some thousand rows of numbers up to 100

/// A weak left hand, which is the affected one, and a strong right one.
TaskContext weak_left() {
  TaskContext context;
  context.period_s = kFrame_s;
  context.two_hands.affected = Hand::left;
  context.two_hands.of.left.maximum_N = 20.0;
  context.two_hands.of.right.maximum_N = 60.0;
  context.two_hands.of.left.resting_N = 0.0;
  context.two_hands.of.right.resting_N = 0.0;
  return context;
}

BilateralTrackingSpec sine(BilateralTrackingSpec::Goal goal) {
  BilateralTrackingSpec spec;
  spec.goal = goal;
  spec.waveform.frequency_Hz = 0.5;
  spec.lead_in_s = 0.5;
  spec.duration_s = 8.0;
  return spec;
}

using Press = test::PressHands;

template <class Spec>
std::vector<Measure> scored(const Spec& spec, const TaskContext& context, const Press& press) {
  return score(test::spec_of(spec), test::play_hands(test::spec_of(spec), context, press));
}

const Measure& measure(const std::vector<Measure>& all, std::string_view name,
                       std::string_view channel) {
  for (const Measure& one : all)
    if (one.name == name && one.channel == channel) return one;
  throw std::runtime_error("there is no " + std::string(name) + " of " + std::string(channel));
}

double value(const std::vector<Measure>& all, std::string_view name, std::string_view channel) {
  const Measure& one = measure(all, name, channel);
  if (!one.value) throw std::runtime_error(std::string(name) + ": " + one.reason);
  return *one.value;
}

TEST(TwoHands, OfASumWhatIsAskedIsAPartOfBothMaxima) {
  auto task =
      test::must(make_task(test::spec_of(sine(BilateralTrackingSpec::Goal::sum)), weak_left()));
  double least_N = 1e9, most_N = 0.0;
  for (TaskView view = task->step(std::monostate()); view.phase != Phase::done;
       view = task->step(std::monostate())) {
    const TwoHandsView& hands = view.two_hands();
    ASSERT_TRUE(hands.target_sum_N.has_value());
    EXPECT_FALSE(hands.of.left.target_N || hands.of.right.target_N);
    least_N = std::min(least_N, *hands.target_sum_N);
    most_N = std::max(most_N, *hands.target_sum_N);
  }
  EXPECT_NEAR(least_N, 0.1 * 80.0, kRounding);
  EXPECT_NEAR(most_N, 0.3 * 80.0, kRounding);
}

TEST(TwoHands, ByTurnsOneGoesUpByAsMuchOfItsMaximumAsTheOtherGoesDown) {
  auto task = test::must(
      make_task(test::spec_of(sine(BilateralTrackingSpec::Goal::antiphase)), weak_left()));
  test::AtLeast frames(100);
  for (TaskView view = task->step(std::monostate()); view.phase != Phase::done;
       view = task->step(std::monostate())) {
    const TwoHandsView& hands = view.two_hands();
    EXPECT_NEAR(*hands.of.left.target_N / 20.0 + *hands.of.right.target_N / 60.0, 0.4, kRounding);
    ++frames;
  }
}

TEST(TwoHands, EachGetsThePartThatTheTaskSays) {
  auto spec = sine(BilateralTrackingSpec::Goal::each);
  spec.ratio_left = 0.25;
  auto task = test::must(make_task(test::spec_of(spec), weak_left()));
  test::AtLeast frames(100);
  for (TaskView view = task->step(std::monostate()); view.phase != Phase::done;
       view = task->step(std::monostate())) {
    const TwoHandsView& hands = view.two_hands();
    EXPECT_NEAR(3.0 * *hands.of.left.target_N, *hands.of.right.target_N, kRounding);
    ++frames;
  }
}

TEST(TwoHands, NoHandIsAskedForMoreThanHalfOfItsMaximum) {
  auto spec = sine(BilateralTrackingSpec::Goal::each);
  spec.ratio_left = 0.5;  // of 80 N: the weak hand would be asked for 12 of its 20 N
  auto made = make_task(test::spec_of(spec), weak_left());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, Error::Code::bad_input);
  EXPECT_EQ(made.error().field, "most_fraction");
  EXPECT_NE(made.error().message().find("left hand for 12.0 N"), std::string::npos)
      << made.error().message();
  spec.ratio_left = 0.4;  // 9.6 N
  EXPECT_TRUE(make_task(test::spec_of(spec), weak_left()));
  auto sum = sine(BilateralTrackingSpec::Goal::sum);
  sum.most = 0.51;  // of each by what it can do
  EXPECT_FALSE(make_task(test::spec_of(sum), weak_left()));
  sum.most = 0.5;
  EXPECT_TRUE(make_task(test::spec_of(sum), weak_left()));
}

TEST(TwoHands, NoHandIsAskedForMoreThanItsCeiling) {
  TaskContext context = weak_left();
  context.two_hands.of.right.ceiling_N = 17.9;  // by capacity it is asked for 18
  const auto spec = test::spec_of(sine(BilateralTrackingSpec::Goal::sum));
  const auto made = make_task(spec, context);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message().find("ceiling"), std::string::npos);
  context.two_hands.of.right.ceiling_N = 18.0;
  EXPECT_TRUE(make_task(spec, context));
}

TEST(TwoHands, WithoutBothMaximaThereIsNoTarget) {
  for (const Hand hand : test::every(kBothHands)) {
    TaskContext context = weak_left();
    context.two_hands.of[hand].maximum_N.reset();
    for (const auto& spec :
         {test::spec_of(sine(BilateralTrackingSpec::Goal::sum)),
          test::spec_of(sine(BilateralTrackingSpec::Goal::antiphase)), test::spec_of(MirrorSpec{})})
      EXPECT_FALSE(make_task(spec, context)) << name_of(hand) << ", " << spec.kind->name;
  }
}

TEST(TwoHands, TheStricterScreeningHoldsForBoth) {
  TaskContext context = weak_left();
  context.references.allowed = Effort::comfortable;
  EXPECT_FALSE(make_task(test::spec_of(BilateralMaximumSpec{}), context));
  EXPECT_TRUE(make_task(test::spec_of(sine(BilateralTrackingSpec::Goal::sum)), context));
  context.references.allowed = Effort::none;
  EXPECT_FALSE(make_task(test::spec_of(sine(BilateralTrackingSpec::Goal::sum)), context));
  EXPECT_TRUE(make_task(test::spec_of(BilateralRestSpec{}), context));
}

TEST(TwoHands, ABandThatTheSensorsOfOneHandCannotResolveIsRefused) {
  TaskContext context = weak_left();
  context.two_hands.of.left.resolution_N = 0.13;  // 5 steps are more than 10 % of 6 N
  const auto made = make_task(test::spec_of(sine(BilateralTrackingSpec::Goal::sum)), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "band_fraction");
}

/// Both follow a sum as it is, each by its part.
Press sharing(double left_part) {
  return [left_part](const TaskView& view) {
    const double sum_N = view.two_hands().target_sum_N.value_or(0.0);
    return OfHands<double>{left_part * sum_N, (1.0 - left_part) * sum_N};
  };
}

TEST(TwoHands, ByCapacityTheShareIsThatOfTheMaximaAndTheEffortIsEqual) {
  const auto all =
      scored(sine(BilateralTrackingSpec::Goal::sum), weak_left(), sharing(20.0 / 80.0));
  EXPECT_NEAR(value(all, "share_affected", "left"), 25.0, kRounding);
  EXPECT_NEAR(value(all, "effort_share_affected", "left"), 50.0, kRounding);
  EXPECT_NEAR(value(all, "asymmetry", "left"), 50.0, kRounding);
  EXPECT_NEAR(value(all, "rmse", "sum"), 0.0, kRounding);
}

TEST(TwoHands, AHandThatHasToneOnlyHasNoShare) {
  constexpr double kMostShare_percent = 2.0;  // clinical rule
  constexpr double kTone_N = 4.0;
  TaskContext context = weak_left();
  context.two_hands.of.left.resting_N = kTone_N;
  const auto all =
      scored(sine(BilateralTrackingSpec::Goal::sum), context, [](const TaskView& view) {
        return OfHands<double>{kTone_N, view.two_hands().target_sum_N.value_or(0.0)};
      });
  EXPECT_LE(value(all, "share_affected", "left"), kMostShare_percent);
  EXPECT_NEAR(value(all, "force_above_rest", "left"), 0.0, kRounding);
  EXPECT_NEAR(value(all, "mean_force", "left"), kTone_N, kRounding);
}

TEST(TwoHands, WithoutRestOfAHandThereIsNoShare) {
  TaskContext context = weak_left();
  context.two_hands.of.right.resting_N.reset();
  const auto all = scored(sine(BilateralTrackingSpec::Goal::sum), context, sharing(0.25));
  for (const char* name : {"share_affected", "asymmetry", "effort_share_affected"})
    EXPECT_FALSE(measure(all, name, "left").value) << name;
  EXPECT_TRUE(measure(all, "force_above_rest", "left").value);
}

TEST(TwoHands, PlatformsThatMoveEachOtherGiveNoShareAndSayWhy) {
  TaskContext context = weak_left();
  context.two_hands.coupled = true;
  const auto all = scored(sine(BilateralTrackingSpec::Goal::sum), context, sharing(0.25));
  for (const char* name : {"share_affected", "asymmetry", "effort_share_affected"}) {
    EXPECT_FALSE(measure(all, name, "left").value) << name;
    EXPECT_NE(measure(all, name, "left").reason.find("mount them apart"), std::string::npos)
        << name;
  }
  EXPECT_TRUE(measure(all, "rmse", "sum").value) << "what both do together stands";
  context.two_hands.coupled = false;
  const auto apart = scored(sine(BilateralTrackingSpec::Goal::sum), context, sharing(0.25));
  EXPECT_NEAR(value(apart, "share_affected", "left"), 25.0, kRounding);
}

TEST(TwoHands, WithoutAnAffectedSideThereIsNoShareAndNoLag) {
  TaskContext context = weak_left();
  context.two_hands.affected.reset();
  const auto all = scored(sine(BilateralTrackingSpec::Goal::sum), context, sharing(0.25));
  for (const char* name : {"share_affected", "effort_share_affected", "hand_lag"})
    EXPECT_FALSE(measure(all, name, "both").value) << name;
  EXPECT_TRUE(measure(all, "hand_correlation", "both").value);
}

TEST(TwoHands, MirroringTheHandsMirrorsTheMeasures) {
  TaskContext mirrored = weak_left();
  std::swap(mirrored.two_hands.of.left, mirrored.two_hands.of.right);
  mirrored.two_hands.affected = Hand::right;
  const auto spec = sine(BilateralTrackingSpec::Goal::sum);
  const auto left = scored(spec, weak_left(), sharing(0.2));
  const auto right = scored(spec, mirrored, sharing(0.8));
  ASSERT_EQ(left.size(), right.size());
  for (const char* name : {"share_affected", "asymmetry", "effort_share_affected",
                           "hand_correlation", "hand_lag_correlation"})
    EXPECT_NEAR(value(left, name, "left"), value(right, name, "right"), kRounding) << name;
}

/// Squeezes what is asked for with these forces.
Press squeezing(OfHands<double> alone_N, OfHands<double> both_N) {
  return [=](const TaskView& view) {
    const TwoHandsView& hands = view.two_hands();
    const OfHands<bool> squeezes{hands.of.left.cue == Cue::squeeze,
                                 hands.of.right.cue == Cue::squeeze};
    OfHands<double> force_N;
    for (const Hand hand : kBothHands)
      if (squeezes[hand]) force_N[hand] = squeezes[other_than(hand)] ? both_N[hand] : alone_N[hand];
    return force_N;
  };
}

BilateralMaximumSpec quick_maximum() {
  BilateralMaximumSpec spec;
  spec.rest_s = 1.0;
  return spec;
}

TEST(TwoHands, TheBilateralIndexIsTheClosedFormOfItsForces) {
  TaskContext context = weak_left();
  context.two_hands.of.left.resting_N = 1.0;
  const auto all = scored(quick_maximum(), context, squeezing({21.0, 60.0}, {17.0, 56.0}));
  EXPECT_NEAR(value(all, "maximum_force", "left"), 20.0, kRounding);
  EXPECT_NEAR(value(all, "maximum_force", "right"), 60.0, kRounding);
  EXPECT_NEAR(value(all, "maximum_force_total", "left"), 21.0, kRounding);
  EXPECT_NEAR(value(all, "bilateral_force", "left"), 16.0, kRounding);
  EXPECT_NEAR(value(all, "bilateral_deficit", "both"), 100.0 * 72.0 / 80.0 - 100.0, kRounding);
}

TEST(TwoHands, WhichHandBeginsAlternatesFromTrialToTrial) {
  const auto first = [](std::uint64_t seed) {
    TaskContext context = weak_left();
    context.seed = seed;
    auto task = test::must(make_task(test::spec_of(quick_maximum()), context));
    for (;;) {
      const TaskView view = task->step(std::monostate());
      if (view.phase != Phase::active) continue;
      return view.two_hands().of.left.cue == Cue::squeeze ? Hand::left : Hand::right;
    }
  };
  for (std::uint64_t seed = 7001; seed < 7005; ++seed) EXPECT_NE(first(seed), first(seed + 1));
}

TEST(TwoHands, OverflowIsTheRiseOfTheHandAtRestInPercentOfTheOther) {
  TaskContext context = weak_left();
  context.two_hands.of.right.resting_N = 0.5;
  for (const auto active :
       test::every(std::array{MirrorSpec::Active::affected, MirrorSpec::Active::left})) {
    MirrorSpec spec;
    spec.active = active;
    const auto all = scored(spec, context, [](const TaskView& view) {
      const double works_N = view.two_hands().of.left.target_N.value_or(0.0);
      return OfHands<double>{works_N, works_N > 0.0 ? 0.5 + 0.1 * works_N : 0.5};
    });
    EXPECT_NEAR(value(all, "mirror_force", "right"), 10.0, kRounding);
    EXPECT_NEAR(value(all, "rmse", "left"), 0.0, kRounding);
  }
}

TEST(TwoHands, WhichHandWorksMustBeKnown) {
  TaskContext context = weak_left();
  context.two_hands.affected.reset();
  const auto made = make_task(test::spec_of(MirrorSpec{}), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "active");
  MirrorSpec spec;
  spec.active = MirrorSpec::Active::right;
  EXPECT_TRUE(make_task(test::spec_of(spec), context));
}

TEST(TwoHands, AStepTakesNoMemory) {
  for (const auto& spec :
       test::every(std::vector{test::spec_of(sine(BilateralTrackingSpec::Goal::each)),
                               test::spec_of(quick_maximum()), test::spec_of(MirrorSpec{})})) {
    TaskContext context = weak_left();
    context.two_hands.of.left.maximum_N = 60.0;
    auto task = test::must(make_task(spec, context));
    const auto before = test::allocations();
    for (int k = 0; k < 500; ++k) (void)task->step(TwoHandsInput{});
    EXPECT_EQ(test::allocations(), before) << spec.kind->name;
  }
}

}  // namespace
}  // namespace isograsp::tasks::two_hands_task_test
