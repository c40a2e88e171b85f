// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/hand_frame.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "kinematics/attitude.hpp"
#include "tests/support/every.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::hand_frame_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

/// Exact positions: rounding of metres, over the length of a link for angles.
constexpr double kExact_m = 1e-13;
constexpr double kExact_rad = 1e-11;

/// What a perfect tracker sees of a hand. The palm frame follows from the knuckles, so that the
/// model must have its middle knuckle on -z and all of them in a plane.
HandModel flat_hand(Hand side) {
  HandModel hand = golden_hand("hand_default");
  hand.side = side;
  for (DigitModel& digit : hand.digits) digit.base_m.y() = 0.0;
  return hand;
}
HandFrame seen(const HandModel& hand, const HandPose& pose, double t_s = 0.0) {
  HandFrame frame;
  frame.t_s = t_s;
  frame.side = hand.side;
  frame.tracked = true;
  const auto joints = joint_poses(hand_in_space(hand, pose));
  for (std::size_t j = 0; j < kHandJointCount; ++j) frame.joints[j] = joints[j].p;
  return frame;
}
HandPose bent(Random& random, const HandModel& hand) {
  HandPose pose;
  pose.X_WP = random_pose(random);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t a = 0; a < kAngleCount; ++a) {
      const AngleRange& limits = hand.digits[d].limits[a];
      // Below a right angle: a digit that points backwards tells no abduction.
      const double most = std::min(limits.most, 1.4);
      pose.angles[d][a] = limits.least + random.uniform() * (most - limits.least);
    }
  return pose;
}

TEST(HandFrame, ThePoseOfAHandIsFoundAgainFromItsJointsAlone) {
  Random random(70);
  for (const Hand side : {Hand::right, Hand::left}) {
    const HandModel hand = flat_hand(side);
    for (int k = 0; k < 200; ++k) {
      const HandPose pose = bent(random, hand);
      const auto fit = fitted_pose(hand, seen(hand, pose));
      ASSERT_TRUE(fit);
      EXPECT_WITHIN(fit->residual_m, 0.0, kExact_m);
      EXPECT_WITHIN(angle_between(fit->pose.X_WP.q, pose.X_WP.q), 0.0, kExact_rad);
      for (std::size_t d = 0; d < kDigitCount; ++d)
        for (std::size_t a = 0; a < kAngleCount; ++a)
          EXPECT_WITHIN(fit->pose.angles[d][a], pose.angles[d][a], kExact_rad)
              << kDigitNames[d] << a;
    }
  }
}

TEST(HandFrame, TheSizeOfAHandIsFoundAgainWhateverItDoes) {
  Random random(71);
  for (const Hand side : {Hand::right, Hand::left}) {
    const HandModel hand = flat_hand(side);
    std::vector<HandFrame> frames;
    for (int k = 0; k < 21; ++k) frames.push_back(seen(hand, bent(random, hand), 0.01 * k));
    const auto calibrated = calibrated_hand(frames, side, golden_hand("hand_large"));
    ASSERT_TRUE(calibrated) << calibrated.error().message();
    EXPECT_EQ(calibrated->frames, 21u);
    for (std::size_t d = 0; d < kDigitCount; ++d) {
      const DigitModel& found = calibrated->hand.digits[d];
      EXPECT_WITHIN((found.base_m - hand.digits[d].base_m).norm(), 0.0, kExact_m);
      for (std::size_t k = 0; k < kLinkCount; ++k)
        EXPECT_WITHIN(found.lengths_m[k], hand.digits[d].lengths_m[k], kExact_m);
    }
    const double scale = calibrated->hand.length_m / golden_hand("hand_large").length_m;
    EXPECT_WITHIN(calibrated->hand.digits[1].radii_m[0],
                  scale * golden_hand("hand_large").digits[1].radii_m[0], kExact_m);
  }
}

TEST(HandFrame, FramesOfTheOtherHandLostOnesAndDoubtfulOnesDoNotCount) {
  Random random(72);
  const HandModel hand = flat_hand(Hand::right);
  std::vector<HandFrame> frames(4, seen(hand, bent(random, hand)));
  frames[1].side = Hand::left;
  frames[2].tracked = false;
  frames[3].confidence = 0.49;
  EXPECT_EQ(calibrated_hand(frames, Hand::right, hand)->frames, 1u);
  frames.erase(frames.begin());
  const auto none = calibrated_hand(frames, Hand::right, hand);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message().find("no frame shows the right hand well"), std::string::npos);
}

TEST(HandFrame, MissingJointsGiveNothingAndNeverANumberThatIsNone) {
  Random random(73);
  const HandModel hand = flat_hand(Hand::right);
  const Vec3 lost = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  AtLeast without(100);
  for (int k = 0; k < 1000; ++k) {
    HandFrame frame = seen(hand, bent(random, hand));
    for (Vec3& joint : frame.joints)
      if (random.uniform() < 0.1) joint = lost;
    const auto fit = fitted_pose(hand, frame);
    if (!fit) {
      ++without;
      continue;
    }
    for (const DigitAngles& digit : fit->pose.angles)
      for (const double angle_rad : digit) ASSERT_TRUE(std::isfinite(angle_rad));
  }
  HandFrame line = seen(hand, bent(random, hand));
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    line.joints[j] = 0.01 * static_cast<double>(j) * Vec3::UnitX();
  EXPECT_FALSE(palm_of(line)) << "joints on a line tell no palm";
}

}  // namespace
}  // namespace isograsp::hand_frame_test
