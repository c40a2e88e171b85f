// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for a tray that two hands lift, whoever they are.
#include <gtest/gtest.h>

#include "core/files.hpp"
#include "tasks/kinds/two_hands/bimanual_lift.hpp"
#include "tasks/score.hpp"
#include "tests/session/lift_play.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::session::lift_laws_test {
namespace {

constexpr double kRounding = 1e-9;  // of sums over some thousand rows of numbers up to 100

tasks::BimanualLiftSpec tray(int lifts = 2) {
  tasks::BimanualLiftSpec spec;
  spec.scene = "tray";
  spec.position_tolerance_m = 0.02;
  spec.lifts = lifts;
  return spec;
}

/// Each hand does so much of what a hand has to do at the target, while it is asked to.
struct Parts {
  double raise = 1.0;
  double squeeze = 1.0;  ///< of what friction needs for the half of the object that it carries
  double tone_N = 0.0;   ///< up, all the time
};
test::PushHands pressing(const tasks::BimanualLiftSpec& spec, const tasks::TaskContext& context,
                         const OfHands<Parts>& parts) {
  const auto task = test::spec_of(spec);
  const auto object = test::must(LiftedObject::read(task, context, test::kLiftLibrary));
  const auto text = test::must(read_text(test::kLiftLibrary + "/scenes/tray.toml"));
  const auto scene = test::must(bimanual::parse_hands_scene(text, "tray.toml"));
  const auto demand = test::must(bimanual::lift_demand(scene, spec.height_m));
  const double raise_N = object.strength() * demand.raise_N;
  const double friction_N = object.strength() * demand.squeeze_N / bimanual::kSqueezeMargin;
  return [=](const tasks::TaskView& view, const LiftedView&) {
    OfHands<Vec3> push_W{Vec3::Zero(), Vec3::Zero()};
    for (const Hand hand : kBothHands) {
      push_W[hand].y() = parts[hand].tone_N;
      if (view.cue != Cue::move) continue;
      const double inward = hand == Hand::left ? 1.0 : -1.0;
      push_W[hand].x() = inward * parts[hand].squeeze * friction_N;
      push_W[hand].y() += parts[hand].raise * raise_N;
    }
    return push_W;
  };
}

std::vector<Measure> scored(const tasks::BimanualLiftSpec& spec, const tasks::TaskContext& context,
                            const OfHands<Parts>& parts) {
  const auto task = test::spec_of(spec);
  return tasks::score(task, test::play_lift(task, context, pressing(spec, context, parts)));
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

TEST(LiftLaws, EqualHandsLiftAllOfThemWithoutTiltAndShareInHalves) {
  const auto all = scored(tray(3), test::lifting_hands(40.0, 60.0), {{1.0, 1.5}, {1.0, 1.5}});
  EXPECT_EQ(value(all, "targets_reached", "targets"), 3.0);
  EXPECT_EQ(value(all, "drops", "contact"), 0.0);
  EXPECT_NEAR(value(all, "object_tilt", "angle"), 0.0, kRounding);
  EXPECT_NEAR(value(all, "raise_share_affected", "left"), 50.0, kRounding);
  EXPECT_NEAR(value(all, "squeeze_share_affected", "left"), 50.0, kRounding);
  EXPECT_NEAR(value(all, "path_share_affected", "left"), 50.0, kRounding);
}

TEST(LiftLaws, TheForceOfEachHandIsThePartOfTheWeakerMaximumThatTheTaskSays) {
  auto spec = tray();
  spec.level = 0.3;
  const auto all = scored(spec, test::lifting_hands(40.0, 60.0),
                          {{1.0, bimanual::kSqueezeMargin}, {1.0, bimanual::kSqueezeMargin}});
  for (const char* hand : {"left", "right"})
    EXPECT_NEAR(
        std::hypot(value(all, "raise_above_rest", hand), value(all, "squeeze_above_rest", hand)),
        0.3 * 40.0, kRounding)
        << hand;
}

TEST(LiftLaws, ExchangingTheHandsChangesTheSideOfTheTiltAndNothingElse) {
  const Parts weak{0.97, 1.6}, strong{1.03, 1.7};
  tasks::TaskContext mirrored = test::lifting_hands(60.0, 40.0);
  mirrored.two_hands.affected = Hand::right;
  const auto left = scored(tray(), test::lifting_hands(40.0, 60.0), {weak, strong});
  const auto right = scored(tray(), mirrored, {strong, weak});
  ASSERT_EQ(left.size(), right.size());
  EXPECT_GT(value(left, "object_tilt_mean", "angle"), 0.01) << "the right hand raises more";
  EXPECT_NEAR(value(left, "object_tilt_mean", "angle"), -value(right, "object_tilt_mean", "angle"),
              kRounding);
  test::AtLeast compared(10);
  for (const Measure& one : left) {
    if (one.name == "object_tilt_mean") continue;
    const std::string channel = one.channel == "left"    ? "right"
                                : one.channel == "right" ? "left"
                                                         : one.channel;
    EXPECT_NEAR(value(right, one.name, channel), *one.value, kRounding)
        << one.name << " " << one.channel;
    ++compared;
  }
}

TEST(LiftLaws, ASqueezeBelowTheLimitOfFrictionDropsAndOneAboveItHolds) {
  const auto context = test::lifting_hands(40.0, 60.0);
  const auto loose = scored(tray(), context, {{1.0, 0.98}, {1.0, 0.98}});
  EXPECT_EQ(value(loose, "targets_reached", "targets"), 0.0);
  EXPECT_GE(value(loose, "drops", "contact"), 2.0);
  EXPECT_GT(value(loose, "friction_utilisation", "left"), 100.0);
  const auto firm = scored(tray(), context, {{1.0, 1.02}, {1.0, 1.02}});
  EXPECT_EQ(value(firm, "targets_reached", "targets"), 2.0);
  EXPECT_EQ(value(firm, "drops", "contact"), 0.0);
  EXPECT_NEAR(value(firm, "friction_utilisation", "left"), 100.0 / 1.02, kRounding);
}

TEST(LiftLaws, OneHandThatLetsGoDropsItAndItMayBeFetchedAgain) {
  const auto context = test::lifting_hands(40.0, 60.0);
  const auto spec = tray(1);
  const auto firm = pressing(spec, context, {{1.0, 1.5}, {1.0, 1.5}});
  int moving = 0;
  const auto task = test::spec_of(spec);
  const auto signals = test::play_lift(task, context, [&](const auto& view, const auto& seen) {
    auto push_W = firm(view, seen);
    moving += view.cue == Cue::move ? 1 : 0;
    constexpr int kLetsGo = 150;  // after a second and a half, before it was held for long enough
    if (moving == kLetsGo) push_W.left = Vec3::Zero();
    return push_W;
  });
  const auto all = tasks::score(task, signals);
  EXPECT_EQ(value(all, "drops", "contact"), 1.0);
  EXPECT_EQ(value(all, "targets_reached", "targets"), 1.0);
  EXPECT_GT(value(all, "completion_time", "target_1"), spec.fetch_s);
}

TEST(LiftLaws, TwiceTheStrengthAndTwiceTheForceAreTheSameLift) {
  const OfHands<Parts> parts{{0.98, 1.6}, {1.02, 1.5}};
  const auto once = scored(tray(), test::lifting_hands(20.0, 30.0), parts);
  const auto twice = scored(tray(), test::lifting_hands(40.0, 60.0), parts);
  ASSERT_EQ(once.size(), twice.size());
  for (std::size_t k = 0; k < once.size(); ++k) {
    const double factor = once[k].unit == "N" ? 2.0 : 1.0;
    EXPECT_EQ(once[k].name, twice[k].name);
    EXPECT_EQ(factor * once[k].value.value(), twice[k].value.value()) << once[k].name;
  }
}

TEST(LiftLaws, AHandWithToneAndNoEffortHasNoShareOfTheRaising) {
  constexpr double kMostShare_percent = 2.0;  // clinical rule
  // The other hand raises as much more, so that the tray leaves its rest, tilted.
  auto spec = tray(1);
  spec.angle_tolerance_rad = 1.5;
  const auto all =
      scored(spec, test::lifting_hands(40.0, 60.0), {{0.0, 4.0, 4.0}, {1.5, 4.0, 0.0}});
  EXPECT_NEAR(value(all, "raise_above_rest", "left"), 0.0, kRounding);
  EXPECT_LE(value(all, "raise_share_affected", "left"), kMostShare_percent);
}

TEST(LiftLaws, WhatIsNotLiftedIsCensoredNotLeftOut) {
  const auto all = scored(tray(), test::lifting_hands(40.0, 60.0), {{0.2, 1.5}, {0.2, 1.5}});
  EXPECT_EQ(value(all, "targets_reached", "targets"), 0.0);
  EXPECT_FALSE(measure(all, "median_completion_time", "targets").value);
  EXPECT_NEAR(value(all, "restricted_mean_time", "targets"), tray().time_limit_s, kRounding);
  EXPECT_FALSE(measure(all, "object_tilt", "angle").value);
}

TEST(LiftLaws, WhatIsRefusedNamesFieldAndRemedy) {
  auto context = test::lifting_hands(40.0, 60.0);
  const auto task = [](const auto& spec) { return test::spec_of(spec); };
  context.two_hands.of.left.maximum_N.reset();
  auto made = tasks::make_task(task(tray()), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "scale");
  context = test::lifting_hands(40.0, 60.0);
  context.two_hands.of.right.ceiling_N = 5.0;  // 8 N are asked of each
  made = tasks::make_task(task(tray()), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "level_fraction");
  context = test::lifting_hands(40.0, 60.0);
  context.two_hands.of.left.resolution_N = 0.5;
  context.lift_N_m = 20.0;
  made = tasks::make_task(task(tray()), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "position_tolerance_m");
  context.references.allowed = tasks::Effort::none;
  made = tasks::make_task(task(tray()), context);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "kind");
}

TEST(LiftLaws, AnObjectThatHandsCannotLiftIsRefused) {
  const auto text = test::must(read_text(test::kLiftLibrary + "/scenes/tray.toml"));
  const auto refused_field = [&](const std::string& what, const std::string& by) {
    std::string changed = text;
    const auto at = changed.find(what);
    if (at == std::string::npos) throw std::runtime_error(what);
    changed.replace(at, what.size(), by);
    const auto scene = test::must(bimanual::parse_hands_scene(changed, "tray.toml"));
    const auto demand = bimanual::lift_demand(scene, 0.08);
    return demand ? std::string("nothing") : demand.error().field;
  };
  EXPECT_EQ(refused_field("normal = [1, 0, 0]", "normal = [-1, 0, 0]"), "normal");
  EXPECT_EQ(refused_field("friction = 0.8", "friction = 0"), "friction");
  EXPECT_EQ(refused_field("max_m = 0.15 },       # the", "max_m = 0.05 },       # the"), "limits");
  EXPECT_EQ(refused_field("gravity_m_s2 = [0, -9.81, 0]", "gravity_m_s2 = [0, 9.81, 0]"),
            "mass_kg");
  EXPECT_EQ(refused_field("hand = \"left\" ", "hand = \"left\"\nfinger = \"thumb\" "), "contact");
}

TEST(LiftLaws, AFrameTakesNoMemory) {
  const auto context = test::lifting_hands(40.0, 60.0);
  const auto spec = test::spec_of(tray());
  auto object = test::must(LiftedObject::read(spec, context, test::kLiftLibrary));
  const auto task = test::must(tasks::make_task(spec, context));
  LiftedView seen;
  object.begin(seen);
  const auto before = test::allocations();
  for (int k = 0; k < 1000; ++k) {
    object.press({Vec3(6.0, 5.0, 0.0), Vec3(-6.0, 5.0, 0.0)}, seen);
    tasks::TwoHandsInput input;
    input.object = &seen.object;
    input.touches = {seen.of.left.touches, seen.of.right.touches};
    const auto view = task->step(input);
    if (view.two_hands().moved->on_rest)
      object.stay(view.two_hands().moved->rest_X_WO, seen);
    else
      object.move(seen);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::session::lift_laws_test
