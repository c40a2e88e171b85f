// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of two hands that, as points, take an object and carry it.
#include "bimanual/carrying_hands.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::bimanual::carrying_hands_test {
namespace {

constexpr double kFrame_s = 0.01;
constexpr double kRounding_m = 1e-12;  // of sums over some hundred frames
const std::string kBox = std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/carried_box.toml";

std::string box_text() {
  return test::must(read_text(kBox));
}
HandsScene box(const Technique& technique) {
  return test::must(
      with_technique(test::must(parse_hands_scene(box_text(), "box.toml")), technique));
}
CarryingHands carrying(const HandsScene& scene) {
  auto hands = test::must(CarryingHands::compile(scene, kFrame_s));
  hands.begin_hands();
  hands.put(scene.object.initial_X_WO);
  return hands;
}

/// What both hands do in common, and how they squeeze; the box begins between them.
struct Push {
  double squeeze_N = 0.0;
  Vec3 common_N = Vec3::Zero();
};
HandsInput input_of(const Push& push) {
  HandsInput input;
  input.push_N[0] = push.common_N + Vec3(push.squeeze_N, 0, 0);
  input.push_N[1] = push.common_N - Vec3(push.squeeze_N, 0, 0);
  return input;
}
/// So that points that squeeze with half the force at the edge are at the faces of the box.
HandsScene near(HandsScene scene, double squeeze_share = 0.5) {
  const double away_m = scene.object.size_m.x() / 2.0 + squeeze_share * scene.hands.half_size_m.x();
  scene.hands.hands[0].center_m = Vec3(-away_m, 0, 0);
  scene.hands.hands[1].center_m = Vec3(away_m, 0, 0);
  return scene;
}
void frame(CarryingHands& hands, const Push& push) {
  hands.see(input_of(push));
  hands.move();
}

TEST(CarryingHands, WhatIsPinchedGoesWithTheMiddleOfThePointsAndThatIsAsFarAsTheyGo) {
  auto hands = carrying(near(box({false, true})));
  for (int k = 0; k < 20; ++k) frame(hands, {1.5, Vec3::Zero()});
  ASSERT_TRUE(hands.held());
  EXPECT_TRUE(hands.joint());
  const Vec3 before = hands.object().X_WO.p;
  const Vec3 middle = 0.5 * (hands.hands().p_W[0] + hands.hands().p_W[1]);
  const double apart_m = (hands.hands().bubble_W[1] - hands.hands().bubble_W[0]).norm();
  Vec3 now = middle;
  for (int k = 0; k < 200; ++k) {
    hands.see(input_of({1.5, Vec3(0.3, 4.0, 0.0)}));
    now = 0.5 * (hands.hands().p_W[0] + hands.hands().p_W[1]);
    hands.move();
  }
  EXPECT_GT(now.y() - middle.y(), 0.1) << "beyond the edge the bubbles move";
  EXPECT_NEAR((hands.object().X_WO.p - before - (now - middle)).norm(), 0.0, kRounding_m);
  EXPECT_NEAR((hands.hands().bubble_W[1] - hands.hands().bubble_W[0]).norm(), apart_m, kRounding_m)
      << "as one they keep their distance";
}

TEST(CarryingHands, TheMirrorImageOfAPushMovesTheMirrorImageOfTheBox) {
  for (const bool pinch : {true, false}) {
    auto hands = carrying(near(box({false, pinch})));
    auto mirrored = carrying(near(box({false, pinch})));
    test::AtLeast held(30);
    for (int k = 0; k < 150; ++k) {
      HandsInput input = input_of({1.8, Vec3(0.2, k < 40 ? 0.0 : 1.5, 0.0)});
      input.push_N[0].y() += 0.3;
      HandsInput other;
      for (std::size_t side = 0; side < kSides; ++side)
        other.push_N[side] = input.push_N[1 - side].cwiseProduct(Vec3(-1, 1, 1));
      hands.see(input);
      mirrored.see(other);
      hands.move();
      mirrored.move();
      const Vec3 p = mirrored.object().X_WO.p.cwiseProduct(Vec3(-1, 1, 1));
      // Of pads: their solver ends where forces change by less than that.
      constexpr double kSolver_m = 1e-9;
      ASSERT_NEAR((hands.object().X_WO.p - p).norm(), 0.0, pinch ? kRounding_m : kSolver_m) << k;
      ASSERT_EQ(hands.held(), mirrored.held());
      if (hands.held()) ++held;
    }
  }
}

TEST(CarryingHands, TwiceTheForceAtTheEdgeAndTwiceThePushMoveItAsBefore) {
  HandsScene scene = near(box({false, true}));
  auto once = carrying(scene);
  for (HandSpec& hand : scene.hands.hands) hand.force_at_edge_N *= 2.0;
  for (double& on_N : scene.grasp->force_on_N) on_N *= 2.0;
  auto twice = carrying(scene);
  for (int k = 0; k < 150; ++k) {
    const Push push{1.6, Vec3(0.1, k < 30 ? 0.0 : 3.5, 0.0)};
    frame(once, push);
    frame(twice, {2.0 * push.squeeze_N, 2.0 * push.common_N});
    ASSERT_EQ(once.object().X_WO.p, twice.object().X_WO.p);
    ASSERT_EQ(once.held(), twice.held());
  }
  EXPECT_TRUE(once.held());
}

/// How the box hangs in pads that are this far inside it.
struct Hung {
  double early_m = 0.0;  ///< its height after half a second
  double late_m = 0.0;   ///< … and after two and a half
  bool held = false;
};
Hung hung(double depth_m) {
  const HandsScene scene = near(box({false, false}));
  const double at_edge_N = scene.hands.hands[0].force_at_edge_N.x();
  const double squeeze_N = at_edge_N * (0.5 + depth_m / scene.hands.half_size_m.x());
  auto hands = carrying(scene);
  Hung hung;
  for (int k = 0; k < 250; ++k) {
    frame(hands, {squeeze_N, Vec3::Zero()});
    if (k == 50) hung.early_m = hands.object().X_WO.p.y();
  }
  hung.late_m = hands.object().X_WO.p.y();
  hung.held = hands.held();
  return hung;
}

TEST(CarryingHands, PadsHoldTheBoxByFrictionAndBelowThatItSlidesOut) {
  // Half of 0.1 kg over friction 0.8 and 400 N/m: 1.5 mm.
  const Hung firm = hung(0.008);
  EXPECT_TRUE(firm.held);
  constexpr double kSettles_m = 1e-6;  // of the springs of the pads, after half a second
  EXPECT_NEAR(firm.late_m, firm.early_m, kSettles_m) << "in stick it does not creep";
  EXPECT_GT(firm.late_m, -0.01) << "the springs of the pads give by its weight";
  const Hung loose = hung(0.001);
  EXPECT_FALSE(loose.held);
  EXPECT_LT(loose.late_m, -0.02);
}

TEST(CarryingHands, WhatNobodyHoldsStandsStillAndPushesOutOfTheScreenDoNothing) {
  for (const bool pinch : {true, false}) {
    auto hands = carrying(box({false, pinch}));
    auto pushed = carrying(box({false, pinch}));
    for (int k = 0; k < 100; ++k) {
      const Vec3 common(1.0 + 0.01 * k, -0.5, 0.0);
      frame(hands, {-0.5, common});
      frame(pushed, {-0.5, common + Vec3(0, 0, 3.0)});
      ASSERT_EQ(hands.object().X_WO.p, Vec3::Zero());
      for (std::size_t side = 0; side < kSides; ++side)
        ASSERT_EQ(hands.hands().p_W[side], pushed.hands().p_W[side]);
      ASSERT_EQ(pushed.hands().view.yaw_rad, 0.0) << "the view never turns";
    }
  }
}

TEST(CarryingHands, WithTheClutchPointsStayAndTheirBubblesComeAlong) {
  auto hands = carrying(near(box({true, true})));
  for (int k = 0; k < 10; ++k) frame(hands, {1.5, Vec3::Zero()});
  for (int k = 0; k < 30; ++k) frame(hands, {1.5, Vec3(0, 2.0, 0)});
  ASSERT_TRUE(hands.held());
  const Vec3 box_W = hands.object().X_WO.p;
  const Vec3 point_W = hands.hands().p_W[0];
  HandsInput relaxing = input_of({1.5, Vec3::Zero()});
  relaxing.clutch.fill(true);
  for (int k = 0; k < 30; ++k) {
    hands.see(relaxing);
    hands.move();
  }
  EXPECT_NEAR((hands.hands().p_W[0] - point_W).norm(), 0.0, kRounding_m);
  EXPECT_NEAR((hands.object().X_WO.p - box_W).norm(), 0.0, kRounding_m);
  for (int k = 0; k < 30; ++k) frame(hands, {1.5, Vec3(0, 2.0, 0)});
  EXPECT_GT(hands.object().X_WO.p.y(), 1.5 * box_W.y()) << "and on from there";
}

TEST(CarryingHands, AFrameTakesNoMemory) {
  for (const bool pinch : {true, false}) {
    auto hands = carrying(near(box({false, pinch})));
    const auto before = test::allocations();
    for (int k = 0; k < 300; ++k) {
      frame(hands, {2.0, Vec3(0, k < 50 ? 0.0 : 2.0, 0)});
      if (k == 150) hands.put(Pose{});
      if (k == 200) hands.begin_hands();
    }
    EXPECT_EQ(test::allocations(), before) << pinch;
  }
}

TEST(CarryingHands, ASceneThatCannotBeCarriedSoIsRefused) {
  const auto field = [](const Technique& technique, const std::string& what,
                        const std::string& by) {
    std::string text = box_text();
    for (auto at = text.find(what); !what.empty() && at != std::string::npos;
         at = text.find(what, at + by.size()))
      text.replace(at, what.size(), by);
    const auto scene = parse_hands_scene(text, "box.toml");
    if (!scene) return "read: " + scene.error().field;
    const auto with = with_technique(*scene, technique);
    return with ? std::string("good") : with.error().field;
  };
  const Technique pinch{false, true}, pads{false, false};
  EXPECT_EQ(field(pinch, "", ""), "good");
  EXPECT_EQ(field(pads, "", ""), "good");
  EXPECT_EQ(field(pinch, "mode = \"constraint\"", "mode = \"off\""), "magnet");
  EXPECT_EQ(field(pads, "hand = \"right\"", "hand = \"left\""), "pad");
  EXPECT_EQ(field(pinch, "[\"x\", \"y\"]", "[\"x\", \"y\", \"z\"]"), "free");
  EXPECT_EQ(field(pinch, "[\"x\", \"y\"]", "[\"x\", \"y\", \"rz\"]"), "good");
  EXPECT_EQ(field(pads, "[\"x\", \"y\"]", "[\"x\", \"y\", \"rz\"]"), "free");
  const auto tray = test::must(parse_hands_scene(
      test::must(read_text(std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/tray.toml")),
      "tray.toml"));
  EXPECT_EQ(with_technique(tray, pinch).error().field, "coupling");
}

}  // namespace
}  // namespace isograsp::bimanual::carrying_hands_test
