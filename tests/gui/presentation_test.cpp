// SPDX-License-Identifier: GPL-3.0-or-later
// What suits one person on the screen, and that an angle on it is what was asked for.
#include "gui/picture/presentation.hpp"

#include <gtest/gtest.h>

#include "gui/rules/posture.hpp"
#include "tests/support/within.hpp"

namespace isograsp::gui::presentation_test {
namespace {

using Half = Presentation::Half;

constexpr double kRounding = 1e-12;  // a few operations on numbers of order one

TEST(Presentation, WhatIsStoredIsReadBack) {
  for (const auto half : {Half::whole, Half::left, Half::right})
    for (unsigned bits = 0; bits < 16; ++bits) {
      const Presentation written{half, (bits & 1U) != 0, (bits & 2U) != 0, (bits & 4U) != 0,
                                 (bits & 8U) != 0};
      EXPECT_EQ(presentation_in(stored(written)), written);
    }
  EXPECT_EQ(presentation_in({{"posture", "half", "left"}}), Presentation{}) << "another topic";
}

TEST(Presentation, HalfAScreenIsOnItsSideAndNoneOfTheOther) {
  for (const auto& screen : {QRectF(0, 0, 1920, 1080), QRectF(10, 20, 1024, 768)}) {
    const auto left = content_area(screen, Half::left);
    const auto right = content_area(screen, Half::right);
    EXPECT_LE(left.right(), screen.center().x());
    EXPECT_GE(right.left(), screen.center().x());
    EXPECT_EQ(left.size(), right.size());
    EXPECT_TRUE(screen.contains(left));
    EXPECT_TRUE(screen.contains(right));
    EXPECT_EQ(content_area(screen, Half::whole), screen);
  }
}

TEST(Presentation, AnAxisHasTheGainThatTheTaskAsksFor) {
  const Viewing viewing{0.30, 0.60};
  for (const ForceAxis& fit : {ForceAxis{0.0, 5.0}, ForceAxis{-2.0, 5.0}}) {
    const double most = gain_of(fit, viewing);
    for (const double share : {0.1, 0.5, 0.9}) {
      const auto axis = with_gain(fit, share * most, viewing);
      EXPECT_WITHIN(gain_of(axis, viewing), share * most, kRounding);
      EXPECT_LE(axis.least_N, fit.least_N);
      EXPECT_GE(axis.most_N, fit.most_N) << "every target stays on the screen";
    }
    EXPECT_EQ(gain_of(with_gain(fit, 2.0 * most, viewing), viewing), most)
        << "more than fits: as it is, and that is what is stored";
  }
}

TEST(Presentation, AnAngleIsHalfAsLargeFromTwiceAsFar) {
  const ForceAxis axis{0.0, 4.0};
  EXPECT_WITHIN(gain_of(axis, {0.3, 0.6}), 2.0 * gain_of(axis, {0.3, 1.2}), kRounding);
  EXPECT_WITHIN(Viewing({0.3, 1.0}).angle_deg(0.01745329251994329577), 1.0, kRounding);
  EXPECT_FALSE(Viewing({0.0, 0.6}).known()) << "a display that does not tell its size";
}

TEST(SittingPosture, WhatIsStoredIsReadBack) {
  SittingPosture posture;
  for (const auto item : kPostureOrder)
    posture.of(item) = choices_of(item).empty() ? "B 3" : choices_of(item).back();
  EXPECT_EQ(posture_in(stored(posture)), posture);
  EXPECT_TRUE(stored(SittingPosture{}).empty()) << "what was not said is not stored";
}

TEST(SittingPosture, OfBothHandsEachHasItsOwnAndThePersonHasOneSeat) {
  OfHands<SittingPosture> postures;
  postures.left.of(PostureItem::seat) = postures.right.of(PostureItem::seat) = "wheelchair";
  postures.left.of(PostureItem::elbow) = "90";
  postures.right.of(PostureItem::elbow) = "110";
  postures.right.of(PostureItem::straps) = "3, 4, 4";
  const auto answers = stored(postures);
  EXPECT_EQ(answers.size(), 4U) << "the seat is said once";
  EXPECT_EQ(postures_in(answers), postures);
  OfHands<SittingPosture> exchanged{postures.right, postures.left};
  EXPECT_NE(postures_in(stored(exchanged)), postures);
  EXPECT_EQ(posture_in(answers).of(PostureItem::elbow), "") << "nothing of one hand alone";
}

TEST(SittingPosture, ADeviationNamesWhatIsAndWhatWas) {
  SittingPosture last;
  last.of(PostureItem::elbow) = "90";
  SittingPosture now = last;
  EXPECT_TRUE(deviations(now, last).isEmpty());
  now.of(PostureItem::elbow) = "110";
  now.of(PostureItem::wrist) = "flexed";
  EXPECT_EQ(deviations(now, last), "Elbow: 110° instead of 90°") << "the wrist was not said before";
  EXPECT_TRUE(deviations(now, SittingPosture{}).isEmpty());
}

}  // namespace
}  // namespace isograsp::gui::presentation_test
