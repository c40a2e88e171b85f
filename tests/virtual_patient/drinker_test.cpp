// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated person who drinks: a body that stays one body, the five phases of the task, and a
// paretic one who needs longer, in more pieces, with more of the trunk.
#include <cmath>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "kinematics/measures/drinking.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "virtual_patient/arm/virtual_drinker.hpp"

namespace isograsp::virtual_patient::drinker_test {
namespace {

constexpr double kRate_Hz = 100.0;
constexpr double kLeadIn_s = 2.0;

/// What cameras see of somebody who is asked to drink after kLeadIn_s.
DrinkingMarkers drink(VirtualDrinker& person, double duration_s = 22.0) {
  DrinkingMarkers seen;
  std::array<std::vector<Vec3>*, 7> parts{&seen.hand,  &seen.wrist, &seen.elbow, &seen.shoulder,
                                          &seen.trunk, &seen.face,  &seen.glass};
  std::array<Vec3, 7> p;
  for (int row = 0; row < static_cast<int>(duration_s * kRate_Hz); ++row) {
    const double t_s = row / kRate_Hz;
    Stimulus picture;
    picture.t_s = t_s;
    picture.cue = t_s < kLeadIn_s ? Cue::relax : Cue::move;
    person.markers(t_s, p);
    person.see(picture);
    seen.t_s.push_back(t_s);
    for (std::size_t part = 0; part < parts.size(); ++part) parts[part]->push_back(p[part]);
  }
  return seen;
}

ArmTraits seen_always(std::string_view name) {
  ArmTraits traits = *arm_traits(name);
  traits.loss_per_s = 0.0;
  return traits;
}

TEST(VirtualDrinker, HasArmsOfOneLengthFromRestToMouthAndBack) {
  ArmTraits traits = seen_always("healthy");
  traits.camera_m = 0.0;
  traits.tremor_rad = 0.0;
  VirtualDrinker person(traits, 3);
  const ArmTraits body = drawn(traits, 3);
  const DrinkingMarkers seen = drink(person);
  constexpr double kRounding_m = 1e-12;
  for (std::size_t row = 0; row < test::every(seen.t_s).size(); ++row) {
    ASSERT_WITHIN((seen.elbow[row] - seen.shoulder[row]).norm(), body.upper_arm_m, kRounding_m);
    ASSERT_WITHIN((seen.wrist[row] - seen.elbow[row]).norm(), body.forearm_m, kRounding_m);
    ASSERT_WITHIN((seen.hand[row] - seen.wrist[row]).norm(), body.palm_m, kRounding_m);
  }
  // Nothing jumps: nobody moves a hand by more than 2 m/s, or an elbow.
  constexpr double kMostStep_m = 2.0 / kRate_Hz;
  for (const auto* part : {&seen.hand, &seen.elbow, &seen.glass, &seen.shoulder})
    for (std::size_t row = 1; row < part->size(); ++row)
      ASSERT_LT(((*part)[row] - (*part)[row - 1]).norm(), kMostStep_m) << row;
}

TEST(VirtualDrinker, MovesNothingBeforeItIsAskedTo) {
  ArmTraits traits = seen_always("healthy");
  traits.camera_m = 0.0;
  VirtualDrinker person(traits, 4);
  const DrinkingMarkers seen = drink(person, kLeadIn_s);
  for (const Vec3& p : test::every(seen.hand)) EXPECT_EQ(p, seen.hand.front());
}

TEST(VirtualDrinker, AsALeftArmIsItsOwnReflectionAndComesAgainBitForBit) {
  VirtualDrinker right(*arm_traits("paretic"), 5), again(*arm_traits("paretic"), 5);
  VirtualDrinker left(*arm_traits("paretic"), 5, Hand::left);
  const DrinkingMarkers a = drink(right), b = drink(again), c = drink(left);
  const auto same = [](const Vec3& p, const Vec3& q) {
    return p == q || (std::isnan(p.x()) && std::isnan(q.x()));
  };
  for (std::size_t row = 0; row < test::every(a.t_s).size(); ++row) {
    ASSERT_TRUE(same(a.hand[row], b.hand[row]));
    ASSERT_TRUE(same(a.hand[row], Vec3(-c.hand[row].x(), c.hand[row].y(), c.hand[row].z())));
  }
}

/// Values by "name channel"; every measure must have one.
std::map<std::string, double> measured(std::string_view name, std::uint64_t seed) {
  VirtualDrinker person(seen_always(name), seed);
  const DrinkingTask task = drinking_task(drink(person, 30.0));
  EXPECT_EQ(english(task.reason), "") << name << " " << seed;
  std::map<std::string, double> values;
  for (const Measure& one : task.measures) {
    EXPECT_TRUE(one.value) << one.name << " " << one.channel << " " << name << " " << seed;
    values[one.name + " " + one.channel] = one.value.value_or(0.0);
  }
  return values;
}

TEST(VirtualDrinker, OfAParesisTakesLongerInMorePiecesAndLeansFurther) {
  constexpr int kPeople = 12;
  for (std::uint64_t seed = 1; seed <= kPeople; ++seed) {
    auto healthy = measured("healthy", seed);
    auto paretic = measured("paretic", seed);
    EXPECT_GT(paretic["total_movement_time task"], 1.5 * healthy["total_movement_time task"]);
    EXPECT_GT(paretic["movement_units total"], healthy["movement_units total"]);
    EXPECT_GT(paretic["trunk_displacement trunk"], 1.5 * healthy["trunk_displacement trunk"]);
    EXPECT_LT(paretic["peak_velocity reaching"], healthy["peak_velocity reaching"]);
    // A healthy person drinks within some seconds, one movement for each of the four ways.
    EXPECT_WITHIN(healthy["total_movement_time task"], 6.0, 3.0);
    EXPECT_WITHIN(healthy["movement_units total"], 4.0, 1.0);
  }
}

}  // namespace
}  // namespace isograsp::virtual_patient::drinker_test
