// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands of one virtual person: what two are more than one.
#include <gtest/gtest.h>

#include "core/files.hpp"
#include "hand/force_channel.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "virtual_patient/pair/virtual_pair.hpp"

namespace isograsp::virtual_patient::pair_test {
namespace {

constexpr double kPicture_s = 0.01;
constexpr int kPressesAPicture = 10;

OfHands<PatientTraits> people(std::string_view left, std::string_view right) {
  return {patient_traits(left).value(), patient_traits(right).value()};
}

/// Both hands are to follow a sum that stands still, and see it.
Stimulus sum_of(double t_s, double target_N, double sum_N) {
  Stimulus picture;
  picture.t_s = t_s;
  picture.cue = picture.page_cue = Cue::follow;
  ShownHands& hands = picture.hands.emplace();
  for (const Hand hand : kBothHands) hands.of[hand].cue = Cue::follow;
  hands.sum.target_shown = hands.sum.force_shown = true;
  hands.sum.target_force_N = target_N;
  hands.sum.force_N = sum_N;
  return picture;
}

/// Grip of each hand, picture by picture, in closed loop with the screen.
std::vector<OfHands<double>> followed(VirtualPair& pair, double target_N, double duration_s) {
  std::vector<OfHands<double>> grips;
  OfHands<double> grip_N;
  for (int picture = 0; picture * kPicture_s < duration_s; ++picture) {
    const double t_s = picture * kPicture_s;
    pair.see(sum_of(t_s, target_N, grip_N.left + grip_N.right));
    for (int k = 0; k < kPressesAPicture; ++k)
      for (const Hand hand : kBothHands)
        grip_N[hand] = force_of(pair.source(hand).press(t_s + k * kPicture_s / kPressesAPicture),
                                ForceChannel{});
    grips.push_back(grip_N);
  }
  return grips;
}

OfHands<double> mean_of_last(const std::vector<OfHands<double>>& grips, std::size_t count) {
  OfHands<double> mean_N;
  for (std::size_t k = grips.size() - count; k < grips.size(); ++k)
    for (const Hand hand : kBothHands) mean_N[hand] += grips[k][hand] / static_cast<double>(count);
  return mean_N;
}

TEST(VirtualPair, ByTheExponentTheShareIsEqualOrThatOfWhatEachCan) {
  constexpr double kNoise = 0.03;  // wander of a paretic hand of 5 % over ten seconds
  for (const auto& [exponent, share] : test::every(
           std::vector<std::pair<double, double>>{{0.0, 0.5}, {1.0, 12.0 / (12.0 + 60.0)}})) {
    PairTraits traits;
    traits.share_exponent = exponent;
    VirtualPair pair(traits, people("paretic", "healthy"), 5);
    const auto mean_N = mean_of_last(followed(pair, 10.0, 20.0), 1000);
    EXPECT_NEAR(mean_N.left + mean_N.right, 10.0, 10.0 * kNoise);
    EXPECT_NEAR(mean_N.left / (mean_N.left + mean_N.right), share, kNoise) << exponent;
  }
}

TEST(VirtualPair, WhicheverHandIsAskedFirstTheForcesAreTheSame) {
  PairTraits traits{0.2, 0.02, 1.0, 0.5, 0.05};
  VirtualPair left_first(traits, people("paretic", "healthy"), 9);
  VirtualPair right_first(traits, people("paretic", "healthy"), 9);
  test::AtLeast pressed(1000);
  for (int k = 0; k < 2000; ++k) {
    const double t_s = k * 1e-3;
    if (k % kPressesAPicture == 0)
      for (VirtualPair* pair : {&left_first, &right_first}) pair->see(sum_of(t_s, 10.0, 0.0));
    const FingerWrenches l1 = left_first.source(Hand::left).press(t_s);
    const FingerWrenches r1 = left_first.source(Hand::right).press(t_s);
    const FingerWrenches r2 = right_first.source(Hand::right).press(t_s);
    const FingerWrenches l2 = right_first.source(Hand::left).press(t_s);
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      EXPECT_EQ(l1[f].force, l2[f].force);
      EXPECT_EQ(r1[f].force, r2[f].force);
    }
    ++pressed;
  }
}

TEST(VirtualPair, OneHandMayBeAskedForManyTimesBeforeTheOther) {
  VirtualPair together({}, people("healthy", "healthy"), 2);
  VirtualPair apart({}, people("healthy", "healthy"), 2);
  for (VirtualPair* pair : {&together, &apart}) pair->see(sum_of(0.0, 10.0, 0.0));
  std::vector<FingerWrenches> expected;
  for (int k = 0; k < 1000; ++k) {
    expected.push_back(together.source(Hand::right).press(k * 1e-3));
    (void)together.source(Hand::left).press(k * 1e-3);
  }
  for (int k = 0; k < 1000; ++k) (void)apart.source(Hand::left).press(k * 1e-3);
  for (int k = 0; k < 1000; ++k)
    EXPECT_EQ(apart.source(Hand::right).press(k * 1e-3)[0].force,
              expected[static_cast<std::size_t>(k)][0].force);
}

/// The right hand is to press, the left one to rest.
Stimulus right_works(double t_s) {
  Stimulus picture = sum_of(t_s, 0.0, 0.0);
  picture.hands->sum = {};
  picture.hands->of.left.cue = Cue::relax;
  ShownHand& right = picture.hands->of.right;
  right.target_shown = true;
  right.target_force_N = 20.0;
  return picture;
}

TEST(VirtualPair, CrosstalkIsAPartOfWhatTheOtherHandDidADelayBefore) {
  PairTraits traits;
  traits.crosstalk = 0.25;
  traits.crosstalk_delay_s = 0.05;
  PatientTraits quiet = patient_traits("healthy").value();
  quiet.force_cv = quiet.tremor_fraction = quiet.resting_force_N = 0.0;
  VirtualPair pair(traits, {quiet, quiet}, 3);
  std::vector<OfHands<double>> force_N;
  for (int k = 0; k < 4000; ++k) {
    const double t_s = k * 1e-3;
    if (k % kPressesAPicture == 0) pair.see(right_works(t_s));
    OfHands<double> now_N;
    for (const Hand hand : kBothHands) now_N[hand] = pair.source(hand).press(t_s)[0].force.z();
    force_N.push_back(now_N);
  }
  constexpr double kRounding_N = 1e-12;
  test::AtLeast worked(1000);
  for (std::size_t k = 50; k < force_N.size(); ++k) {
    EXPECT_NEAR(force_N[k].left, 0.25 * force_N[k - 50].right, kRounding_N);
    if (force_N[k].right > 10.0) ++worked;
  }
}

TEST(VirtualPair, TheWeakerHandDoesAllLaterByTheLag) {
  PairTraits traits;
  traits.lag_s = 0.2;
  traits.share_exponent = 0.0;
  PatientTraits weak = patient_traits("healthy").value();
  weak.maximum_force_N *= 0.5;
  weak.force_cv = weak.tremor_fraction = 0.0;
  PatientTraits strong = weak;
  strong.maximum_force_N *= 2.0;
  VirtualPair pair(traits, {weak, strong}, 3);
  std::array<std::optional<int>, 2> begun;
  for (int k = 0; k < 2000; ++k) {
    const double t_s = k * 1e-3;
    if (k % kPressesAPicture == 0) pair.see(sum_of(t_s, 10.0, 0.0));
    for (const Hand hand : kBothHands) {
      auto& first = begun[hand == Hand::left ? 0 : 1];
      if (pair.source(hand).press(t_s)[0].force.z() > 1.0 && !first) first = k;
    }
  }
  ASSERT_TRUE(begun[0] && begun[1]);
  EXPECT_EQ(*begun[0] - *begun[1], 200);
}

TEST(VirtualPair, PressingAndSeeingTakeNoMemory) {
  VirtualPair pair({0.1, 0.05, 1.0, 0.5, 0.1}, people("paretic", "healthy"), 1);
  const auto before = test::allocations();
  (void)followed(pair, 10.0, 0.0);  // its own list apart
  for (int k = 0; k < 3000; ++k) {
    if (k % kPressesAPicture == 0) pair.see(sum_of(k * 1e-3, 10.0, 5.0));
    for (const Hand hand : kBothHands) (void)pair.source(hand).press(k * 1e-3);
  }
  EXPECT_EQ(test::allocations(), before);
}

TEST(PairFile, ShippedPairsAreReadAndWrongOnesAreRefusedWithTheirLine) {
  const std::string folder = std::string(ISOGRASP_SOURCE_DIR) + "/library/patients/pairs/";
  for (const char* name : {"healthy", "paretic_left", "paretic_right"}) {
    const std::string path = folder + name + ".toml";
    EXPECT_TRUE(parse_pair(test::must(read_text(path)), path)) << name;
  }
  std::string text = test::must(read_text(folder + "healthy.toml"));
  const auto at = text.find("lag_s = 0");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
  text.replace(at, 9, "lag_s = 7");
  const auto refused = parse_pair(text, "pair.toml");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().line, line);
  EXPECT_EQ(refused.error().field, "together.lag_s") << refused.error().message();
}

}  // namespace
}  // namespace isograsp::virtual_patient::pair_test
