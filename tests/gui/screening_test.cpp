// SPDX-License-Identifier: GPL-3.0-or-later
// The screening: what the answers suggest, and that the therapist decides.
#include "gui/rules/screening.hpp"

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::gui::screening_test {
namespace {

Screening with(Caution caution, int pain = 0) {
  Screening screening;
  screening.applies[static_cast<std::size_t>(caution)] = true;
  screening.pain = pain;
  return screening;
}

TEST(Screening, SuggestsNothingBeforePainIsKnown) {
  EXPECT_FALSE(suggested(Screening{}).has_value());
  EXPECT_FALSE(Screening{}.complete());
}

TEST(Screening, NeverSuggestsMoreWhenMoreApplies) {
  for (int pain = 0; pain <= 10; ++pain)
    for (unsigned less = 0; less < 1U << kCautionCount; ++less)
      for (std::size_t added = 0; added < kCautionCount; ++added) {
        Screening few;
        few.pain = pain;
        for (std::size_t i = 0; i < kCautionCount; ++i) few.applies[i] = (less >> i & 1U) != 0;
        Screening more = few;
        more.applies[added] = true;
        EXPECT_LE(suggested(more), suggested(few));
        more.pain = std::min(10, pain + 1);
        EXPECT_LE(suggested(more), suggested(few));
      }
}

TEST(Screening, WithoutClearanceOnlyComfortableForceIsSuggested) {
  EXPECT_EQ(suggested(with(Caution::no_clearance)), tasks::Effort::comfortable);
  EXPECT_EQ(suggested(with(Caution::seizures)), tasks::Effort::maximum);
}

TEST(Screening, AnInjuredOrPainfulHandIsSuggestedNoForce) {
  EXPECT_EQ(suggested(with(Caution::injury)), tasks::Effort::none);
  EXPECT_EQ(suggested(with(Caution::skin, kTooMuchPain)), tasks::Effort::none);
  EXPECT_EQ(suggested(with(Caution::skin, kTooMuchPain - 1)), tasks::Effort::maximum);
}

TEST(Screening, IsCompleteOnlyWithTheTherapistsDecision) {
  Screening screening = with(Caution::no_clearance);
  EXPECT_FALSE(screening.complete());
  screening.allowed = tasks::Effort::maximum;  // cleared after all: it is the therapist who decides
  EXPECT_TRUE(screening.complete());
}

TEST(Screening, IsStoredWithEveryAnswer) {
  Screening screening = with(Caution::skin, 2);
  screening.allowed = tasks::Effort::comfortable;
  const auto answers = stored(screening);
  ASSERT_EQ(answers.size(), kCautionCount + 1);
  int yes = 0;
  for (const auto& answer : test::every(answers)) {
    EXPECT_EQ(answer.topic, "screening");
    yes += answer.value == "yes" ? 1 : 0;
  }
  EXPECT_EQ(yes, 1);
  EXPECT_EQ(answers.back().item, "pain");
  EXPECT_EQ(answers.back().value, "2");
}

}  // namespace
}  // namespace isograsp::gui::screening_test
