// SPDX-License-Identifier: GPL-3.0-or-later
// Carrying with both hands as a task: what counts as placed, dropped, censored, what is refused.
#include "tasks/kinds/two_hands/bimanual_pick_place.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "hand/two_hands_columns.hpp"
#include "tasks/carry_forces.hpp"
#include "tasks/score.hpp"
#include "tests/support/every.hpp"
#include "tests/tasks/kinds/hands_play.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::tasks::bimanual_pick_place_test {
namespace {

constexpr double kFrame_s = 0.01;

BimanualPickPlaceSpec carries(int repetitions = 1) {
  BimanualPickPlaceSpec spec;
  spec.scene = "carried_box";
  spec.targets = {{Vec3(0.1, 0, 0)}, {Vec3(0, 0.1, 0)}};
  spec.repetitions = repetitions;
  spec.hold_s = 0.5;
  spec.time_limit_s = 4.0;
  spec.lead_in_s = spec.rest_s = 0.5;
  spec.fetch_s = 0.5;
  return spec;
}

/// The box and whether both hands hold it, by what is asked.
struct Hands {
  ObjectState box;
  bool hold = false;
};
using Move = std::function<void(const TaskView& view, int frames_of_carry, Hands& hands)>;

/// Held, led straight to its target in half a second, kept until it is to be let go.
void carry_well(const TaskView& view, int k, Hands& hands) {
  const MovedView& moved = *view.two_hands().moved;
  if (view.cue == Cue::let_go) {
    hands.hold = false;
    return;
  }
  hands.hold = k > 10;
  const double share = std::clamp((k - 10) / 50.0, 0.0, 1.0);
  hands.box.X_WO.p = moved.rest_X_WO.p + share * (moved.X_WT.p - moved.rest_X_WO.p);
}

Signals play(const BimanualPickPlaceSpec& spec, const Move& move, std::uint64_t seed = 1) {
  auto context = test::known_hands(kFrame_s);
  context.seed = seed;
  const auto task = test::must(make_task(test::spec_of(spec), context));
  std::vector<std::string> names{
      columns::t_s,          columns::phase,           columns::sample_flags,
      columns::target_index, columns::targets_reached, columns::drops,
      columns::both_hold,    columns::affected_hand,   columns::platforms_coupled};
  for (const auto& axis : columns::actual_position) names.emplace_back(axis);
  for (const auto& axis : columns::target_position) names.emplace_back(axis);
  for (const Hand hand : kBothHands) {
    names.emplace_back(columns::hand_squeeze_N[hand]);
    for (const auto& axis : columns::hand_point[hand]) names.emplace_back(axis);
  }
  Signals signals(names);
  Hands hands;
  TaskView view;
  int of_carry = 0, last = -1;
  for (int k = 0;; ++k) {
    const auto& moved = view.two_hands().moved;
    if (moved && moved->on_rest) hands = {{}, false};
    of_carry = view.target_index == last ? of_carry + 1 : 0;
    last = view.target_index;
    if (moved && !moved->on_rest) move(view, of_carry, hands);
    TwoHandsInput input{{test::gripping(0.0), test::gripping(0.0)}};
    input.object = &hands.box;
    input.touches = {hands.hold, hands.hold};
    view = task->step(input);
    const MovedView& asked = *view.two_hands().moved;
    std::vector<double> row{k * kFrame_s,
                            static_cast<double>(view.phase),
                            0.0,
                            static_cast<double>(view.target_index),
                            static_cast<double>(view.targets_reached),
                            static_cast<double>(asked.drops),
                            hands.hold ? 1.0 : 0.0,
                            0.0,
                            kNotMeasured};
    for (const double place : hands.box.X_WO.p) row.push_back(place);
    for (const double place : asked.X_WT.p)
      row.push_back(asked.target_shown ? place : kNotMeasured);
    for (const Hand hand : kBothHands) {
      row.push_back(hand == Hand::left ? 2.0 : 3.0);
      const double side = hand == Hand::left ? -1.0 : 1.0;
      // The left point goes twice as far as the right one.
      const Vec3 point =
          Vec3(0.03 * side, 0, 0) + (hand == Hand::left ? 2.0 : 1.0) * hands.box.X_WO.p;
      for (const double place : point) row.push_back(place);
    }
    signals.append_row(row);
    if (view.phase == Phase::done) return signals;
  }
}

double value(const std::vector<Measure>& all, std::string_view name, std::string_view channel) {
  for (const Measure& one : all)
    if (one.name == name && one.channel == channel) {
      if (!one.value) throw std::runtime_error(std::string(name) + ": " + one.reason);
      return *one.value;
    }
  throw std::runtime_error("there is no " + std::string(name));
}
std::vector<Measure> scored(const BimanualPickPlaceSpec& spec, const Move& move) {
  return score(test::spec_of(spec), play(spec, move));
}

constexpr double kRounding = 1e-9;

TEST(BimanualPickPlace, CarriedStraightHeldAndLetGoItIsPlacedAndEachCarryIsTimed) {
  const auto all = scored(carries(), carry_well);
  EXPECT_EQ(value(all, "targets_reached", "targets"), 2.0);
  EXPECT_EQ(value(all, "drops", "contact"), 0.0);
  EXPECT_NEAR(value(all, "path_efficiency", "position"), 100.0, kRounding);
  EXPECT_NEAR(value(all, "least_squeeze", "right"), 3.0, kRounding);
  EXPECT_NEAR(value(all, "path_share_affected", "left"), 200.0 / 3.0, kRounding);
  // 0.6 s to the place less what is inside its tolerance, half a second there, a frame to let go.
  const double time_s = value(all, "completion_time", "target_1");
  EXPECT_GT(time_s, 1.0);
  EXPECT_LT(time_s, 1.2);
}

TEST(BimanualPickPlace, LetGoOnTheWayItIsDroppedOnceAndMayBeFetched) {
  bool dropped = false;
  const auto all = scored(carries(), [&](const TaskView& view, int k, Hands& hands) {
    carry_well(view, k, hands);
    if (dropped || k < 40 || view.target_index != 0) return;
    hands.hold = false;
    dropped = true;
  });
  EXPECT_EQ(value(all, "drops", "contact"), 1.0);
  EXPECT_EQ(value(all, "targets_reached", "targets"), 2.0);
}

TEST(BimanualPickPlace, LetGoWhereItBeganOrTooEarlyAtItsPlaceIsNoDrop) {
  int held_inside = 0;
  const auto all = scored(carries(), [&](const TaskView& view, int k, Hands& hands) {
    carry_well(view, k, hands);
    if (k == 15) hands.hold = false;  // touched and let go at once
    if (view.phase == Phase::hold && ++held_inside == 10) hands.hold = false;
  });
  EXPECT_EQ(value(all, "drops", "contact"), 0.0);
  EXPECT_EQ(value(all, "targets_reached", "targets"), 2.0);
}

TEST(BimanualPickPlace, WhatIsNotPlacedInTimeIsCensoredNotLeftOut) {
  const auto all = scored(carries(), [](const TaskView&, int, Hands&) {});
  EXPECT_EQ(value(all, "targets_reached", "targets"), 0.0);
  EXPECT_NEAR(value(all, "restricted_mean_time", "targets"), 4.0, kRounding);
  EXPECT_THROW((void)value(all, "least_squeeze", "left"), std::runtime_error);
}

TEST(BimanualPickPlace, EachRepetitionHasAllTargetsAndOrdersDifferBetweenSeeds) {
  const auto order = [](std::uint64_t seed) {
    const Signals signals = play(carries(6), carry_well, seed);
    const auto index = signals.column(columns::target_index);
    const auto x_m = signals.column(columns::target_position[0]);
    std::vector<double> places;
    int last = -1;
    for (std::size_t row = 0; row < signals.rows(); ++row) {
      const int now = static_cast<int>(index[row]);
      if (now < 0 || now == last) continue;
      last = now;
      places.push_back(x_m[row]);
    }
    return places;
  };
  const auto first = order(1);
  ASSERT_EQ(first.size(), 12U);
  for (std::size_t k = 0; k < first.size(); k += 2) EXPECT_NE(first[k], first[k + 1]) << k;
  std::set<std::vector<double>> orders;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) orders.insert(order(seed));
  EXPECT_GT(orders.size(), 3U);
}

TEST(BimanualPickPlace, ForcesAreThoseOfTheHandAndOfTheNoiseOfItsPlatform) {
  HandReferences hand;
  hand.maximum_N = 40.0;
  EXPECT_DOUBLE_EQ(carry_forces(hand, 0.15).at_edge_N, 6.0);
  EXPECT_DOUBLE_EQ(carry_forces(hand, 0.15).on_N, 1.5);
  hand.maximum_N = 4.0;
  hand.noise_sd_N = 0.1;
  EXPECT_DOUBLE_EQ(carry_forces(hand, 0.15).at_edge_N, 1.0) << "ten times the noise";
  EXPECT_DOUBLE_EQ(carry_forces(hand, 0.15).on_N, 0.5);
  hand.resolution_N = 0.08;
  EXPECT_DOUBLE_EQ(carry_forces(hand, 0.15).at_edge_N, 1.6) << "twenty steps of the sensors";
}

TEST(BimanualPickPlace, WhatIsRefusedNamesFieldAndRemedy) {
  const auto refused = [](const TaskContext& context, int repetitions = 1) {
    const auto made = make_task(test::spec_of(carries(repetitions)), context);
    return made ? std::string("nothing") : made.error().field;
  };
  auto context = test::known_hands(kFrame_s);
  EXPECT_EQ(refused(context), "nothing");
  context.two_hands.of.left.maximum_N.reset();
  EXPECT_EQ(refused(context), "scale");
  context = test::known_hands(kFrame_s);
  context.two_hands.of.right.ceiling_N = 11.0;  // up to 12 N move its bubble
  EXPECT_EQ(refused(context), "edge_fraction");
  context = test::known_hands(kFrame_s);
  context.two_hands.of.left.noise_sd_N = 1.1;  // the edge would be more than a quarter of 40 N
  EXPECT_EQ(refused(context), "edge_fraction");
  context = test::known_hands(kFrame_s);
  context.references.allowed = Effort::none;
  EXPECT_EQ(refused(context), "kind");
  // A patient's dose; of volunteers no side is affected.
  context = test::known_hands(kFrame_s);
  context.carries_left = 3;
  EXPECT_EQ(refused(context, 2), "repetitions");
  context.two_hands.affected.reset();
  EXPECT_EQ(refused(context, 11), "nothing");
}

TEST(BimanualPickPlace, OnlyTrainingGivesTheAffectedHandAnotherWeightAndThenAsksLittleOfIt) {
  const std::string text = test::library_task_text("two_hands_carry_training.toml");
  const auto at_level = [&](const std::string& level) {
    return test::must(parse_task(text + "\n[chosen]\nlevel = " + level + "\n", "training"));
  };
  EXPECT_DOUBLE_EQ(at_level("0").hands_carry()->affected_share, 0.5);
  EXPECT_DOUBLE_EQ(at_level("1").hands_carry()->affected_share, 0.8);
  constexpr double kStep = 0.05 * 0.3;  // a success adds a twentieth of the range
  EXPECT_NEAR(at_level("0.05").hands_carry()->affected_share, 0.5 + kStep, kRounding);
  EXPECT_EQ(test::library_task("two_hands_carry.toml").hands_carry()->affected_share, 0.5);
  std::string assessment = test::library_task_text("two_hands_carry.toml");
  assessment.insert(assessment.find("edge_fraction"), "affected_share = 0.6\n");
  EXPECT_FALSE(parse_task(assessment, "assessment")) << "no key of an assessment";
  for (const Hand affected : kBothHands) {
    auto context = test::known_hands(kFrame_s);
    context.two_hands.affected = affected;
    EXPECT_TRUE(make_task(at_level("1"), context));
    context.two_hands.of[affected].noise_sd_N = 0.7;  // the edge is 7 of 40 N
    const auto weak = make_task(at_level("1"), context);
    ASSERT_FALSE(weak);
    EXPECT_EQ(weak.error().field, "edge_fraction");
    EXPECT_TRUE(make_task(at_level("0"), context)) << "as much as the other hand";
  }
  auto context = test::known_hands(kFrame_s);
  context.two_hands.affected.reset();
  const auto unknown = make_task(at_level("1"), context);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().field, "difficulty");
}

}  // namespace
}  // namespace isograsp::tasks::bimanual_pick_place_test
