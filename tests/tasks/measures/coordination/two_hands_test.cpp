// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/two_hands.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tasks/measures/delay.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::two_hands_test {
namespace {

using statistics::UniformSamples;
using test::sampled;
using test::times;

constexpr double kRounding = 1e-9;

double target_at(double s) {
  return 8.0 + 3.0 * std::sin(1.3 * s) + std::sin(2.9 * s + 1.0);
}

struct Hands {
  UniformSamples left{0.01, {}};
  UniformSamples right{0.01, {}};
  UniformSamples target{0.01, {}};
};
/// Halves of the target, with noise that both have and noise that one takes from the other.
Hands hands(double common_N, double apart_N) {
  constexpr std::size_t kRows = 3000;
  Random random(5);
  Hands made;
  made.target.values = sampled(times(kRows), target_at);
  for (const double target : made.target.values) {
    const double common = common_N * random.gaussian();
    const double apart = apart_N * random.gaussian();
    made.left.values.push_back(0.5 * target + common + apart);
    made.right.values.push_back(0.5 * target + common - apart);
  }
  return made;
}
double synergy_of(const Hands& of, bool without_target = false) {
  return *hand_synergy(of.left, of.right, without_target ? nullptr : &of.target).value;
}

TEST(TwoHands, SharesOfBothHandsAddUpAndTheAsymmetryTurnsWithTheHand) {
  for (const auto& [a, u] : {std::pair{3.0, 9.0}, {5.0, 5.0}, {0.0, 4.0}, {7.5, 0.1}}) {
    const HandShare one = hand_share(a, u);
    const HandShare other = hand_share(u, a);
    EXPECT_WITHIN(*one.affected_percent.value + *other.affected_percent.value, 100.0, kRounding);
    EXPECT_EQ(*one.asymmetry_percent.value, -*other.asymmetry_percent.value);
    EXPECT_WITHIN(*one.asymmetry_percent.value, 100.0 - 2.0 * *one.affected_percent.value,
                  kRounding);
  }
}

TEST(TwoHands, AForceBelowRestIsNoShareAndTwoOfThemHaveNone) {
  EXPECT_EQ(*hand_share(-1.0, 4.0).affected_percent.value, 0.0);
  EXPECT_EQ(*hand_share(4.0, -1.0).affected_percent.value, 100.0);
  EXPECT_FALSE(hand_share(-1.0, 0.0).affected_percent.value);
  EXPECT_FALSE(hand_share(-1.0, 0.0).asymmetry_percent.value);
}

TEST(TwoHands, EffortIsTheShareOfHandsOfOneStrengthAndHalfForEqualPartsOfUnequalOnes) {
  EXPECT_WITHIN(*effort_share(3.0, 9.0, 40.0, 40.0).value,
                *hand_share(3.0, 9.0).affected_percent.value, kRounding);
  EXPECT_WITHIN(*effort_share(2.0, 10.0, 12.0, 60.0).value, 50.0, kRounding);
}

TEST(TwoHands, SynergyIsTwoForHandsThatMakeUpForEachOtherAndLessTwoForACommonDrive) {
  EXPECT_WITHIN(synergy_of(hands(0.0, 0.5)), 2.0, kRounding);
  EXPECT_WITHIN(synergy_of(hands(0.5, 0.0)), -2.0, kRounding);
  // 3000 samples of each noise: their variances are known within some 5 %.
  EXPECT_WITHIN(synergy_of(hands(0.5, 0.5)), 0.0, 0.1);
}

TEST(TwoHands, WithoutTheTargetPerfectCompensationLooksLikeACommonDrive) {
  EXPECT_LT(synergy_of(hands(0.0, 0.5), true), -1.0);
}

TEST(TwoHands, SynergyIsTheSameOfExchangedHandsOtherUnitsAndADrift) {
  Hands of = hands(0.4, 0.3);
  const double before = synergy_of(of);
  std::swap(of.left, of.right);
  EXPECT_WITHIN(synergy_of(of), before, kRounding);
  for (std::size_t k = 0; k < of.left.values.size(); ++k) {
    of.left.values[k] = 1e3 * of.left.values[k] + 2.0 * static_cast<double>(k);
    of.right.values[k] *= 1e3;
  }
  EXPECT_WITHIN(synergy_of(of), before, kRounding);
}

TEST(TwoHands, AConstantTargetTakesNothingOut) {
  Hands of = hands(0.4, 0.3);
  const double without = synergy_of(of, true);
  for (double& value : of.target.values) value = 8.1;
  EXPECT_WITHIN(synergy_of(of), without, kRounding);
}

TEST(TwoHands, WhatTheTargetExplainsAloneHasNoSynergy) {
  const Hands of = hands(0.0, 0.0);
  const auto synergy = hand_synergy(of.left, of.right, &of.target);
  EXPECT_FALSE(synergy.value);
  EXPECT_NE(english(synergy.reason).find("beside the target"), std::string::npos);
  const UniformSamples two{0.01, {1.0, 2.0}};
  EXPECT_FALSE(hand_synergy(two, two, nullptr).value);
}

TEST(TwoHands, OppositePushesCancelPushesOfOneDirectionDoNot) {
  const std::vector<Vec3> push{{1.0, -2.0, 0.5}, {0.0, 3.0, 0.0}};
  std::vector<Vec3> opposite;
  std::vector<Vec3> twice;
  for (const Vec3& each : push) {
    opposite.push_back(-each);
    twice.push_back(2.0 * each);
  }
  const std::vector<double> weight{0.01, 0.02};
  EXPECT_WITHIN(*cancelled_share(push, opposite, weight).value, 100.0, kRounding);
  EXPECT_WITHIN(*cancelled_share(push, twice, weight).value, 0.0, kRounding);
}

TEST(TwoHands, HandsThatDoNotPushTakeNothingFromEachOther) {
  const std::vector<double> weight{0.01, 0.02};
  const auto of_pushes = [&](double each_N) {
    const std::vector<Vec3> left(2, Vec3(each_N, 0.0, 0.0));
    const std::vector<Vec3> right(2, Vec3(0.0, each_N, 0.0));
    return cancelled_share(left, right, weight);
  };
  EXPECT_FALSE(of_pushes(0.0).value);
  EXPECT_FALSE(of_pushes(0.24).value) << "noise of six sensors";
  EXPECT_TRUE(of_pushes(0.26).value);
}

TEST(TwoHands, TheCorrelationAtALagIsThatOfTheShiftedSamples) {
  const auto t = times(3000);
  const UniformSamples first{0.01, sampled(t, target_at)};
  const UniformSamples later{0.01, sampled(t, [](double s) { return target_at(s - 0.13); })};
  const LagPeak peak = lag_peak(first, later);
  EXPECT_EQ(*peak.lag_s.value, *lag(first, later).value);
  EXPECT_WITHIN(*peak.correlation.value, 1.0, kRounding);
  const LagPeak back = lag_peak(later, first);
  EXPECT_WITHIN(*back.lag_s.value, -*peak.lag_s.value, kRounding);
  const UniformSamples against{0.01, sampled(t, [](double s) { return -target_at(s); })};
  EXPECT_EQ(lag_peak(first, against).lag_s.value.has_value(),
            lag_peak(first, against).correlation.value.has_value());
}

}  // namespace
}  // namespace isograsp::tasks::two_hands_test
