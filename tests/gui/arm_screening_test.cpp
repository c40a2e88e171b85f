// SPDX-License-Identifier: GPL-3.0-or-later
// The screening of an arm: what the answers suggest, and what is stored of them.
#include "gui/rules/arm_screening.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "gui/rules/screening.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::arm_screening_test {
namespace {

/// Each bit of `yes` is a question.
ArmScreening with(unsigned yes, int pain) {
  ArmScreening screening;
  screening.pain = pain;
  for (std::size_t q = 0; q < kArmQuestionCount; ++q) screening.yes[q] = (yes >> q & 1U) != 0;
  return screening;
}
constexpr unsigned kAble = 1U << static_cast<unsigned>(ArmQuestion::turns) |
                           1U << static_cast<unsigned>(ArmQuestion::holds);
constexpr unsigned bit(ArmQuestion question) {
  return 1U << static_cast<unsigned>(question);
}

TEST(ArmScreening, SuggestsNothingBeforePainIsKnown) {
  EXPECT_FALSE(suggested(ArmScreening{}).has_value());
  EXPECT_FALSE(ArmScreening{}.complete());
}

TEST(ArmScreening, NeverSuggestsMoreWhenMoreAppliesItHurtsMoreOrTheArmCanDoLess) {
  for (int pain = 0; pain <= 10; ++pain)
    for (unsigned yes = 0; yes < 1U << kArmQuestionCount; ++yes) {
      for (const ArmQuestion reason :
           {ArmQuestion::shoulder, ArmQuestion::contracture, ArmQuestion::tape})
        EXPECT_LE(suggested(with(yes | bit(reason), pain)), suggested(with(yes, pain)));
      for (const ArmQuestion able : {ArmQuestion::turns, ArmQuestion::holds})
        EXPECT_GE(suggested(with(yes | bit(able), pain)), suggested(with(yes, pain)));
      EXPECT_LE(suggested(with(yes, std::min(10, pain + 1))), suggested(with(yes, pain)));
    }
}

TEST(ArmScreening, OffersNothingBelowTenDegreesAndTenSecondsAndNamesTheIsometricTasks) {
  for (const unsigned yes : {0U, bit(ArmQuestion::turns), bit(ArmQuestion::holds)}) {
    const ArmScreening screening = with(yes, 0);
    EXPECT_EQ(suggested(screening), tasks::Effort::none);
    EXPECT_FALSE(screening.offered());
    EXPECT_TRUE(advice(screening).contains("isometric")) << advice(screening).toStdString();
  }
  EXPECT_EQ(suggested(with(kAble, 0)), tasks::Effort::maximum);
  EXPECT_FALSE(advice(with(kAble, 0)).contains("isometric"));
}

TEST(ArmScreening, PainOfFourIsNoMovementAPainfulShoulderASmallRange) {
  EXPECT_EQ(suggested(with(kAble, kTooMuchPain)), tasks::Effort::none);
  EXPECT_EQ(suggested(with(kAble, kTooMuchPain - 1)), tasks::Effort::maximum);
  EXPECT_EQ(suggested(with(kAble | bit(ArmQuestion::shoulder), 0)), tasks::Effort::comfortable);
}

TEST(ArmScreening, IsCompleteOnlyWithADecisionAndRangesThatHoldAnAngle) {
  ArmScreening screening = with(kAble, 1);
  EXPECT_FALSE(screening.complete());
  screening.allowed = tasks::Effort::maximum;
  EXPECT_TRUE(screening.complete());
  screening.passive[0] = PassiveDegrees{-20, 20};  // never reaches neutral, and never 20 degrees
  EXPECT_FALSE(screening.complete());
  screening.passive[0] = PassiveDegrees{-20, 21};
  EXPECT_TRUE(screening.complete());
}

TEST(ArmScreening, WhatIsStoredIsReadBackAsTheRangesThatWereEntered) {
  constexpr double kDegree_rad = std::numbers::pi / 180.0;
  constexpr double kRounding_rad = 1e-12;  // through the decimal text of degrees
  ArmScreening screening = with(kAble, 3);
  screening.allowed = tasks::Effort::comfortable;
  screening.passive[0] = PassiveDegrees{80, 60};
  screening.passive[2] = PassiveDegrees{15, -5};
  const auto answers = stored(screening);
  const auto limits = test::must(session::passive_limits_in(answers));
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0].angle, (LinkAngle{ArmLink::forearm, 3})) << "pronation is positive";
  EXPECT_WITHIN(limits[0].least_rad, -80.0 * kDegree_rad, kRounding_rad);
  EXPECT_WITHIN(limits[0].most_rad, 60.0 * kDegree_rad, kRounding_rad);
  EXPECT_EQ(limits[1].angle, (LinkAngle{ArmLink::wrist, 2})) << "ulnar deviation is positive";
  EXPECT_WITHIN(limits[1].most_rad, -5.0 * kDegree_rad, kRounding_rad);
  for (const auto& answer : test::every(answers)) EXPECT_EQ(answer.topic, "screening");
}

TEST(ArmScreening, NoWordOfItIsOneOfThePlatform) {
  for (const auto effort :
       {tasks::Effort::none, tasks::Effort::comfortable, tasks::Effort::maximum}) {
    ArmScreening screening = with(kAble, 0);
    screening.allowed = effort;
    const auto said = range_words(effort) + summary(screening);
    for (const char* word : {"maximum", "force", "device", "strap"})
      EXPECT_FALSE(said.contains(word, Qt::CaseInsensitive)) << said.toStdString();
  }
}

}  // namespace
}  // namespace isograsp::gui::arm_screening_test
