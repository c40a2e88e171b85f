// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/digits.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::digits_test {
namespace {

constexpr double kRounding = 1e-12;

/// Forces F = E u of a hand with enslaving E, over a resting force, digit j instructed to u.
DigitHold hold_of(const Eigen::Matrix3d& enslaved, Finger j, double u_N, double rest_N) {
  DigitHold hold;
  hold.instructed = j;
  for (std::size_t i = 0; i < kFingerCount; ++i) {
    hold.start_N[i] = rest_N;
    hold.mean_N[i] = rest_N + enslaved(static_cast<int>(i), static_cast<int>(index_of(j))) * u_N;
  }
  return hold;
}
Eigen::Matrix3d hand() {
  Eigen::Matrix3d e;
  e << 1.0, 0.02, -0.01, 0.05, 1.0, 0.30, -0.04, 0.25, 1.0;
  return e;
}

TEST(Digits, TheEnslavingOfAHandIsFoundWithItsSignsWhateverItsToneAndEffort) {
  const Eigen::Matrix3d e = hand();
  std::vector<DigitHold> holds;
  for (const Finger j : kFingers)
    for (const double u_N : {2.0, 5.0, 11.0}) holds.push_back(hold_of(e, j, u_N, 1.5 * u_N));
  for (const Finger i : kFingers)
    for (const Finger j : kFingers) {
      const double entry = e(static_cast<int>(index_of(i)), static_cast<int>(index_of(j)));
      EXPECT_WITHIN(enslaving(holds, i, j).value.value(), entry, kRounding);
      EXPECT_WITHIN(enslaving_of_maximum(holds, i, j, 20.0).value.value(), entry * 6.0 / 20.0,
                    kRounding);
    }
}

TEST(Digits, AHoldWithoutAPressOfTheInstructedDigitDoesNotCount) {
  std::vector<DigitHold> holds{hold_of(hand(), Finger::index, 4.0, 0.0),
                               hold_of(hand(), Finger::index, 0.0, 1.0)};
  EXPECT_WITHIN(enslaving(holds, Finger::middle, Finger::index).value.value(), 0.25, kRounding);
  EXPECT_FALSE(enslaving(holds, Finger::middle, Finger::index, 4.5).value);
  EXPECT_FALSE(enslaving(holds, Finger::middle, Finger::thumb).value);
  EXPECT_FALSE(enslaving_of_maximum(holds, Finger::middle, Finger::index, 0.0).value);
}

TEST(Digits, DeviationIsTheRootMeanSquareOfTheOtherDigitsAboveTheirStart) {
  const std::vector<double> thumb{1.0, 2.0};
  const std::vector<double> index{50.0, 60.0};
  const std::vector<double> middle{0.5, 0.5};
  const std::vector<double> weight{1.0, 3.0};
  const DigitForces forces{{thumb, index, middle}, weight};
  // Thumb off by 0 for 1 s and 1 for 3 s, middle off by 2 for 4 s: (3 + 16) / 8.
  EXPECT_WITHIN(uninstructed_deviation(forces, Finger::index, {1.0, 0.0, -1.5}).value.value(),
                std::sqrt(19.0 / 8.0), kRounding);
  EXPECT_FALSE(uninstructed_deviation({}, Finger::index, {}).value);
}

TEST(Digits, IndividuationIsTheSlopeOfMostHoldsAndDoesNotSeeAFewOutliers) {
  constexpr double kSlope = 0.087;  // controls of Xu et al. 2017
  std::vector<Individuation> holds;
  for (const double force_N : {4.0, 8.0, 12.0, 16.0, 4.0, 8.0, 12.0, 16.0})
    holds.push_back({force_N, kSlope * force_N});
  EXPECT_WITHIN(individuation_slope(holds).value.value(), kSlope, kRounding);
  EXPECT_WITHIN(individuation_index(holds).value.value(), 2.4418, 0.5e-4);
  holds[0].deviation_N = 30.0;
  holds[3].deviation_N = 30.0;
  holds[6].deviation_N = 0.0;
  EXPECT_WITHIN(individuation_slope(holds).value.value(), kSlope, kRounding);
}

TEST(Digits, IndividuationMinimisesTheSumOfAbsoluteDeviations) {
  Random random(4);
  std::vector<Individuation> holds;
  for (int k = 0; k < 25; ++k) {
    const double force_N = 1.0 + 10.0 * random.uniform();
    holds.push_back({force_N, 0.2 * force_N * random.uniform()});
  }
  const auto cost = [&](double slope) {
    double sum = 0.0;
    for (const auto& hold : holds) sum += std::abs(hold.deviation_N - slope * hold.instructed_N);
    return sum;
  };
  const double slope = individuation_slope(holds).value.value();
  for (double other = 0.0; other < 0.25; other += 0.001)
    EXPECT_LE(cost(slope), cost(other) + kRounding) << other;
}

TEST(Digits, IndividuationIsBlindToTheUnitAndRefusesTooFewHolds) {
  std::vector<Individuation> holds{{4.0, 0.4}, {8.0, 1.0}, {12.0, 0.9}};
  auto in_grams = holds;
  for (auto& hold : in_grams) hold = {hold.instructed_N * 1024.0, hold.deviation_N * 1024.0};
  EXPECT_EQ(individuation_index(holds).value, individuation_index(in_grams).value);
  EXPECT_EQ(english(individuation_index(std::span(holds).first(2)).reason),
            "fewer than three holds with force");
  for (auto& hold : holds) hold.deviation_N = 0.0;
  EXPECT_EQ(english(individuation_index(holds).reason), "the other digits did not move");
}

TEST(Digits, CoflexionIsTheBestWindowOfAnyDigitsPressInShareOfThatOfTheOpening) {
  const std::vector<double> thumb{-1.0, -4.0, -3.0, 0.0};
  const std::vector<double> index{0.0, -6.0, -2.0, 0.0};
  const std::vector<double> middle{0.5, 0.5, 1.5, 2.5};
  const std::vector<double> still(4, 0.0);
  const std::vector<double> weight(4, 0.25);
  const std::vector<bool> all(4, true);
  constexpr double kWindow_s = 0.5;
  const auto share = [&](const auto& a, const auto& b, const auto& c, const auto& valid) {
    return coflexion({{a, b, c}, weight}, valid, kWindow_s);
  };
  EXPECT_WITHIN(share(thumb, index, middle, all).value.value(), 100.0 * 2.0 / 7.5, kRounding);
  EXPECT_WITHIN(share(thumb, index, still, all).value.value(), 0.0, kRounding);
  EXPECT_EQ(english(share(still, still, middle, all).reason), "there was no opening force");
  // No window reaches over a sample that does not count.
  EXPECT_WITHIN(share(thumb, index, middle, std::vector{true, true, false, true}).value.value(),
                100.0 * 0.5 / 5.5, kRounding);
  EXPECT_FALSE(share(thumb, index, middle, std::vector{true, false, true, false}).value);
}

TEST(Digits, NoiseAddsLessToCoflexionThanItsPeaks) {
  Random random(4);
  std::array<std::vector<double>, kFingerCount> force_N;
  double highest_N = 0.0;
  constexpr double kNoise_N = 0.1;
  for (int k = 0; k < 300; ++k) {
    force_N[0].push_back(-10.0 + kNoise_N * random.gaussian());
    force_N[1].push_back(kNoise_N * random.gaussian());
    force_N[2].push_back(0.0);
    highest_N = std::max(highest_N, force_N[1].back());
  }
  const std::vector<double> weight(300, 0.01);
  const double share =
      coflexion({{force_N[0], force_N[1], force_N[2]}, weight}, std::vector<bool>(300, true), 0.5)
          .value.value();
  EXPECT_LT(share, 0.25 * 100.0 * highest_N / 10.0);
}

TEST(Digits, SharesAddUpToAllAndABalancedThumbHasHalf) {
  const PerDigit mean_N{8.0, 5.0, 3.0};
  double sum = 0.0;
  for (const Finger finger : kFingers) sum += sharing(mean_N, finger).value.value();
  EXPECT_WITHIN(sum, 100.0, kRounding);
  EXPECT_DOUBLE_EQ(sharing(mean_N, Finger::thumb).value.value(), 50.0);
  EXPECT_DOUBLE_EQ(thumb_opposition(mean_N).value.value(), 1.0);
  EXPECT_FALSE(sharing({0.0, 0.0, 0.0}, Finger::thumb).value);
  EXPECT_FALSE(thumb_opposition({2.0, 0.0, -1.0}).value);
}

}  // namespace
}  // namespace isograsp::tasks::digits_test
