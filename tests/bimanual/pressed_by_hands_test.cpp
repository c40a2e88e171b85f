// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of an object between two measured hands: what both do is the sum of what each does, left is
// the mirror of right, and a hand without contacts is not there.
#include "bimanual/pressed_by_hands.hpp"

#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "bimanual/read_hands.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::pressed_by_hands_test {
namespace {

constexpr double kHold_s = 0.01;
const std::string kScenes = std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/";

HandsScene tray() {
  const std::string file = kScenes + "tray.toml";
  return test::must(parse_hands_scene(test::must(read_text(file)), file));
}
PressedByHands compiled(const HandsScene& scene) {
  return test::must(PressedByHands::compile(scene.object, scene.contacts, kHold_s));
}
HandWrenches pushed(const HandsScene& scene, const Vec3& left_N, const Vec3& right_N) {
  return {of_whole_hand(scene.contacts[0], {left_N, Vec3::Zero()}),
          of_whole_hand(scene.contacts[1], {right_N, Vec3::Zero()})};
}
/// Of each hand, towards the other by 2 to 8 N, besides up, down, forth and back by up to 3 N.
std::array<Vec3, kSides> random_pushes(Random& random) {
  std::array<Vec3, kSides> push_N;
  for (std::size_t side = 0; side < kSides; ++side) {
    push_N[side] = test::random_vector(random, 3.0);
    push_N[side].x() = (side == 0 ? 1.0 : -1.0) * (2.0 + 6.0 * random.uniform());
  }
  return push_N;
}
bool same_bits(const ObjectState& a, const ObjectState& b) {
  return a.X_WO.p == b.X_WO.p && a.X_WO.q.coeffs() == b.X_WO.q.coeffs() && a.v_WO_W == b.v_WO_W &&
         a.w_WO_W == b.w_WO_W && a.angle_rad == b.angle_rad;
}

TEST(PressedByHands, ATrayIsLiftedByBothAndByNoneAlone) {
  const HandsScene scene = tray();
  const PressedByHands pressed = compiled(scene);
  const auto height_after = [&](const Vec3& left_N, const Vec3& right_N) {
    PressedState state = pressed.initial_state();
    for (int k = 0; k < 500; ++k)
      pressed.move(pressed.grasp(pushed(scene, left_N, right_N), state), state);
    return state.object.X_WO.p.y();
  };
  constexpr double kAtRest_m = 1e-3;  // the spring's rest is approached, not reached, in 5 s
  EXPECT_WITHIN(height_after({3, 2, 0}, {-3, 2, 0}), (4.0 - 0.3 * 9.81) / 10.0, kAtRest_m);
  EXPECT_EQ(height_after({8, 5, 0}, Vec3::Zero()), 0.0);
  EXPECT_EQ(height_after(Vec3::Zero(), {-8, 5, 0}), 0.0);
  EXPECT_EQ(height_after({1, 2, 0}, {-1, 2, 0}), 0.0) << "without squeeze it slips";
}

TEST(PressedByHands, WhoRaisesMoreTiltsTheTray) {
  const HandsScene scene = tray();
  const PressedByHands pressed = compiled(scene);
  PressedState state = pressed.initial_state();
  for (int k = 0; k < 500; ++k)
    pressed.move(pressed.grasp(pushed(scene, {4, 2, 0}, {-4, 3, 0}), state), state);
  constexpr double kAtRest_rad = 1e-3;
  EXPECT_WITHIN(state.object.angle_rad, 1.0 * 0.15 / 0.57, kAtRest_rad);
}

TEST(PressedByHands, LeftIsTheMirrorOfRight) {
  const HandsScene scene = tray();
  const PressedByHands pressed = compiled(scene);
  Random random(1, 21);
  PressedState state = pressed.initial_state(), mirror = state;
  const auto mirrored = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
  constexpr double kRounding = 1e-12;
  for (int k = 0; k < 2000; ++k) {
    const auto push_N = random_pushes(random);
    pressed.move(pressed.grasp(pushed(scene, push_N[0], push_N[1]), state), state);
    pressed.move(pressed.grasp(pushed(scene, mirrored(push_N[1]), mirrored(push_N[0])), mirror),
                 mirror);
    ASSERT_WITHIN((state.object.X_WO.p - mirrored(mirror.object.X_WO.p)).norm(), 0.0, kRounding)
        << k;
    ASSERT_WITHIN(state.object.angle_rad + mirror.object.angle_rad, 0.0, kRounding) << k;
    ASSERT_EQ(state.touching[0], mirror.touching[1]);
  }
}

/// The fingers of one hand on a block, as a scene with one hand and as one of two.
TEST(PressedByHands, WithTheContactsOfOneHandAloneItIsTheSceneOfOneHand) {
  for (const char* name : {"planar_block.toml", "free_block.toml", "weight.toml", "knob.toml"}) {
    const std::string file = kScenes + name;
    const Scene one = test::must(parse_scene(test::must(read_text(file)), file));
    const Plan plan = test::must(Plan::compile(one, kHold_s));
    Scene object = one;
    object.contacts.clear();
    for (std::size_t side = 0; side < kSides; ++side) {
      std::array<HandContacts, kSides> hands;
      hands[side].contacts = one.contacts;
      const PressedByHands pressed = test::must(PressedByHands::compile(object, hands, kHold_s));
      Random random(2, 21);
      ObjectState alone = plan.initial_state();
      PressedState state = pressed.initial_state();
      bool touched = false;
      for (int k = 0; k < 1000; ++k) {
        HandWrenches wrench_C{};
        for (Wrench& wrench : wrench_C[side]) {
          wrench.force = test::random_vector(random, 1.5) + Vec3(0, 0, 1.5);
          wrench.torque = test::random_vector(random, 0.01);
        }
        if (k % 50 == 7) wrench_C[side][2].force.x() = std::numeric_limits<double>::quiet_NaN();
        const GraspWrench wrench = plan.grasp(wrench_C[side], alone);
        plan.move(wrench, alone);
        const PressedWrench both = pressed.grasp(wrench_C, state);
        pressed.move(both, state);
        ASSERT_TRUE(same_bits(state.object, alone)) << name << " row " << k;
        ASSERT_EQ(both.both.F_O_W.force, wrench.F_O_W.force) << name << " row " << k;
        ASSERT_EQ(both.hand[side].utilisation, wrench.utilisation);
        ASSERT_EQ(state.touching[side], alone.contact);
        touched = touched || wrench.F_O_W.force.norm() > 0.0;
      }
      EXPECT_TRUE(touched) << name;
    }
  }
}

/// Springs, dampers and mass are linear: what both hands do from rest is the sum of what each does.
TEST(PressedByHands, WhatBothDoIsTheSumOfWhatEachDoes) {
  HandsScene scene = tray();
  scene.object.limits.clear();  // stops are not linear
  scene.object.gravity_m_s2.setZero();
  scene.object.grasp_rule = GraspRule::any;
  const PressedByHands pressed = compiled(scene);
  Random random(3, 21);
  PressedState both = pressed.initial_state(), left = both, right = both;
  constexpr double kRounding = 1e-12;
  for (int k = 0; k < 2000; ++k) {
    const auto push_N = random_pushes(random);
    const Vec3 none = Vec3::Zero();
    pressed.move(pressed.grasp(pushed(scene, push_N[0], push_N[1]), both), both);
    pressed.move(pressed.grasp(pushed(scene, push_N[0], none), left), left);
    pressed.move(pressed.grasp(pushed(scene, none, push_N[1]), right), right);
    const Vec3 sum = left.object.X_WO.p + right.object.X_WO.p;
    ASSERT_WITHIN((both.object.X_WO.p - sum).norm(), 0.0, kRounding) << k;
    ASSERT_WITHIN(both.object.angle_rad - left.object.angle_rad - right.object.angle_rad, 0.0,
                  kRounding)
        << k;
  }
  EXPECT_GT(both.object.X_WO.p.norm(), 1e-3) << "it moved";
}

TEST(PressedByHands, ASecondRunIsTheSameBitsAndDoesNotAllocate) {
  const HandsScene scene = tray();
  const PressedByHands pressed = compiled(scene);
  const auto end = [&] {
    Random random(4, 21);
    PressedState state = pressed.initial_state();
    for (int k = 0; k < 2000; ++k) {
      const auto push_N = random_pushes(random);
      const std::uint64_t before = test::allocations();
      pressed.move(pressed.grasp(pushed(scene, push_N[0], push_N[1]), state), state);
      EXPECT_EQ(test::allocations(), before);
    }
    return state;
  };
  const PressedState a = end(), b = end();
  EXPECT_TRUE(same_bits(a.object, b.object));
}

TEST(PressedByHands, TheGraspRuleLooksAtBothHands) {
  HandsScene scene = tray();
  scene.object.grasp_rule = GraspRule::closure;
  const PressedByHands pressed = compiled(scene);
  PressedState state = pressed.initial_state();
  const auto force = [&](const Vec3& left_N, const Vec3& right_N) {
    return pressed.grasp(pushed(scene, left_N, right_N), state).both.F_O_W.force;
  };
  EXPECT_EQ(force({3, 1, 0}, Vec3::Zero()), Vec3(0, 0, 0));
  EXPECT_EQ(force({3, 1, 0}, {-3, 1, 0}), Vec3(0, 2, 0));
}

TEST(HandsScene, OfTheLibraryMoveUnderTwoWeakHands) {
  test::AtLeast scenes(2);
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    const std::string file = entry.path();
    const std::string text = test::must(read_text(file));
    if (!has_hands(text)) continue;
    const HandsScene scene = test::must(parse_hands_scene(text, file));
    if (scene.coupling != Coupling::force) continue;  // carrying_hands_test.cpp
    ++scenes;
    const PressedByHands pressed = compiled(scene);
    PressedState state = pressed.initial_state();
    const auto start = state.object.X_WO.p;
    constexpr double kWeak_N = 3.0;
    for (int k = 0; k < 300; ++k)
      pressed.move(pressed.grasp(pushed(scene, {kWeak_N, 2, 0}, {-kWeak_N, 2, 0}), state), state);
    constexpr double kOffRest_m = 0.01;  // of a tray on springs this is a newton
    EXPECT_GT((state.object.X_WO.p - start).norm(), kOffRest_m) << file;
  }
}

std::string field_of(const std::string& text) {
  const auto scene = parse_hands_scene(text, "scene.toml");
  return scene ? std::string() : scene.error().field;
}

TEST(HandsScene, ContactsOfMeasuredForcesAreRefusedWithTheirKey) {
  const std::string good = test::must(read_text(kScenes + "tray.toml"));
  const auto field = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return field_of(text.replace(at, from.size(), to));
  };
  EXPECT_EQ(field_of(good), "");
  EXPECT_EQ(field("hand = \"right\"", "hand = \"left\""), "contact[2].hand");
  EXPECT_EQ(field("hand = \"right\"", "hand = \"left\"\nfinger = \"index\""), "contact[2].hand");
  EXPECT_EQ(field("hand = \"right\"", "hand = \"both\""), "contact[2].hand");
  EXPECT_EQ(field("hand = \"right\"", ""), "contact[2].hand");
  EXPECT_EQ(field("hand = \"right\"", "hand = \"right\"\nfinger = \"toe\""), "contact[2].finger");
  EXPECT_EQ(field("coupling = \"force\"", "coupling = \"force\"\nrate_m_s = 0.1"),
            "hands.rate_m_s");
  EXPECT_EQ(field("[object]", "[magnet]\nmode = \"off\"\n[object]"), "magnet");
  EXPECT_EQ(field("coupling = \"force\"", "coupling = \"none\""), "object");
  EXPECT_EQ(field("coupling = \"force\"", "coupling = \"proxy\""), "contact[1].hand");
  EXPECT_EQ(field_of(good.substr(0, good.find("[[contact]]"))), "contact");
  const auto one_hand = parse_scene(good, "scene.toml");
  ASSERT_FALSE(one_hand);
  EXPECT_EQ(one_hand.error().field, "hands");
  std::string without = good;
  const std::string table = "[hands]\ncoupling = \"force\"";
  const auto none = parse_scene(without.replace(without.find(table), table.size(), ""), "one.toml");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().field, "contact[1].hand");
}

TEST(HandsScene, HandsWithoutCouplingNeedNothingElse) {
  const std::string good =
      "format = \"isograsp-scene-1\"\nname = \"two numbers\"\n[hands]\ncoupling = \"none\"\n";
  EXPECT_EQ(field_of(good), "");
  EXPECT_EQ(field_of(good + "separation_m = 0.02\n"), "hands.separation_m");
  EXPECT_EQ(field_of(good + "[[pad]]\nhand = \"left\"\n"), "pad");
}

}  // namespace
}  // namespace isograsp::bimanual::pressed_by_hands_test
