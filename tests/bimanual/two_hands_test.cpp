// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of two hands as points: nothing jumps at the edge of a bubble, hands never cross, left is
// the mirror of right, bubbles that move as one keep their distance.
#include "bimanual/two_hands.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "bimanual/carried_object.hpp"
#include "bimanual/clip.hpp"
#include "bimanual/read_hands.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "tests/support/golden_table.hpp"
#include "tests/support/must.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::two_hands_test {
namespace {

constexpr double kStep_s = 0.01;
const std::string kData = std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/bimanual/bubble/";

HandsSpec spec_of(BubbleShape shape = BubbleShape::ellipsoid) {
  HandsSpec spec;
  spec.shape = shape;
  spec.half_size_m = Vec3(0.06, 0.04, 0.03);
  spec.hands[0] = {Vec3(-0.12, 0, 0), Vec3(2, 2, 2)};
  spec.hands[1] = {Vec3(0.12, 0, 0), Vec3(8, 8, 8)};
  return spec;
}

TEST(Bubble, NeitherPlaceNorRateJumpsWhereThePushReachesTheEdge) {
  for (const BubbleShape shape :
       {BubbleShape::ellipsoid, BubbleShape::box, BubbleShape::superellipsoid}) {
    const HandsSpec spec = spec_of(shape);
    const Vec3 direction = Vec3(0.3, -0.5, 0.8).normalized();
    Vec3 before_m = Vec3::Zero();
    double excess_before = 0.0;
    constexpr double kStep_N = 1e-3;
    for (double push_N = 0.0; push_N < 20.0; push_N += kStep_N) {
      const BubblePush push = push_in_bubble(spec, Side::right, push_N * direction);
      // At most half size over force at the edge for each newton, and the same in the excess.
      const double lipschitz = 2.0 * kStep_N * spec.half_size_m.maxCoeff() / 8.0;
      ASSERT_LE((push.offset_m - before_m).norm(), lipschitz) << push_N;
      ASSERT_LE(std::abs(push.excess - excess_before), 2.0 * kStep_N / 8.0) << push_N;
      ASSERT_LE(push.offset_m.cwiseQuotient(spec.half_size_m).cwiseAbs().maxCoeff(), 1.0 + 1e-12);
      before_m = push.offset_m;
      excess_before = push.excess;
    }
    EXPECT_GT(excess_before, 0.0);
  }
}

TEST(Bubble, AWeakHandReachesAsFarWithAQuarterOfTheForce) {
  const HandsSpec spec = spec_of();
  const Vec3 push_N(1.0, 0.5, -0.2);
  EXPECT_EQ(push_in_bubble(spec, Side::left, push_N).offset_m,
            push_in_bubble(spec, Side::right, 4.0 * push_N).offset_m);
}

TEST(TwoHands, APushSweptThroughTheBorderMovesHandAndBubbleWithoutAJump) {
  for (const BubbleShape shape :
       {BubbleShape::ellipsoid, BubbleShape::box, BubbleShape::superellipsoid}) {
    const HandsSpec spec = spec_of(shape);
    TwoHands hands(spec);
    HandsInput input;
    // Outward, so that neither plane nor door has a part in it; up and back through the border.
    const Vec3 direction = Vec3(0.8, 0.6, 0.0);
    HandsState before = hands.see(input);
    double speed_before = 0.0, fastest = 0.0;
    constexpr double kRow_N = 0.02;
    const double edge_N = spec.hands[1].force_at_edge_N.x();
    for (int k = 0; k < 2400; ++k) {
      const double push_N = kRow_N * (k < 1200 ? k : 2400 - k);
      input.push_N[1] = push_N * direction;
      hands.move(kStep_s, false);
      const HandsState& now = hands.see(input);
      const double speed = (now.bubble_W[1] - before.bubble_W[1]).norm() / kStep_s;
      const double moved_m = (now.p_W[1] - before.p_W[1]).norm();
      // Twice: at the border the offset turns from growing to staying.
      ASSERT_LE(moved_m,
                2.0 * spec.half_size_m.maxCoeff() * kRow_N / edge_N + kStep_s * spec.rate_limit_m_s)
          << k;
      constexpr double kRounding_m_s = 1e-12;
      ASSERT_LE(std::abs(speed - speed_before),
                2.0 * spec.rate_m_s * kRow_N / edge_N + kRounding_m_s)
          << k;
      fastest = std::max(fastest, speed);
      speed_before = speed;
      before = now;
    }
    EXPECT_GT(fastest, 0.1) << "it went far beyond the border";
    EXPECT_EQ(speed_before, 0.0) << "and came back";
  }
}

TEST(TwoHands, NeverCrossInAMillionRandomRows) {
  Random random(3, 14);
  TwoHands hands(spec_of());
  HandsInput input;
  bool joint = false;
  for (int k = 0; k < 1'000'000; ++k) {
    if (k % 20 == 0)
      for (std::size_t side = 0; side < kSides; ++side)
        input.push_N[side] = test::random_vector(random, side == 0 ? 12.0 : 50.0);
    if (k % 500 == 0) joint = random.uniform() < 0.3;
    const HandsState& state = hands.see(input);
    const Vec3 between = state.bubble_W[1] - state.bubble_W[0];
    const double apart_m = std::hypot(between.x(), between.z());
    ASSERT_GE(apart_m, 0.08 - 1e-12) << k;
    const Vec3 line = Vec3(between.x(), 0.0, between.z()) / apart_m;
    ASSERT_GE(line.dot(state.p_W[1] - state.p_W[0]), 0.02 - 1e-12) << k;
    hands.move(kStep_s, joint);
  }
}

/// Left and right exchanged, x turned round.
Vec3 mirrored(const Vec3& v) {
  return {-v.x(), v.y(), v.z()};
}

TEST(TwoHands, LeftIsTheMirrorOfRight) {
  Random random(4, 14);
  HandsSpec spec = spec_of();
  HandsSpec other = spec;
  for (std::size_t side = 0; side < kSides; ++side) {
    other.hands[side] = spec.hands[1 - side];
    other.hands[side].center_m = mirrored(spec.hands[1 - side].center_m);
  }
  TwoHands hands(spec), mirror(other);
  HandsInput input, seen_in_mirror;
  for (int k = 0; k < 20000; ++k) {
    if (k % 20 == 0)
      for (std::size_t side = 0; side < kSides; ++side) {
        input.push_N[side] = test::random_vector(random, side == 0 ? 6.0 : 25.0);
        seen_in_mirror.push_N[1 - side] = mirrored(input.push_N[side]);
      }
    const HandsState& a = hands.see(input);
    const HandsState& b = mirror.see(seen_in_mirror);
    for (std::size_t side = 0; side < kSides; ++side) {
      ASSERT_WITHIN((a.p_W[side] - mirrored(b.p_W[1 - side])).norm(), 0.0, 1e-9) << k;
      ASSERT_EQ(a.excess[side], b.excess[1 - side]);
    }
    hands.move(kStep_s, false);
    mirror.move(kStep_s, false);
  }
}

TEST(TwoHands, BubblesThatMoveAsOneKeepTheirDistanceToTheLastDigits) {
  Random random(5, 14);
  TwoHands hands(spec_of());
  HandsInput input;
  const Vec3 apart = hands.state().bubble_W[1] - hands.state().bubble_W[0];
  for (int k = 0; k < 5000; ++k) {
    for (std::size_t side = 0; side < kSides; ++side)
      input.push_N[side] = test::random_vector(random, 30.0);
    static_cast<void>(hands.see(input));
    hands.move(kStep_s, true);
    ASSERT_WITHIN((hands.state().bubble_W[1] - hands.state().bubble_W[0] - apart).norm(), 0.0,
                  1e-12);
  }
}

TEST(TwoHands, ASecondRunIsTheSameBits) {
  const auto end = [] {
    Random random(6, 14);
    TwoHands hands(spec_of());
    HandsInput input;
    for (int k = 0; k < 3000; ++k) {
      for (std::size_t side = 0; side < kSides; ++side)
        input.push_N[side] = test::random_vector(random, 30.0);
      static_cast<void>(hands.see(input));
      hands.move(kStep_s, k % 700 > 500);
    }
    return hands.state();
  };
  const HandsState a = end(), b = end();
  EXPECT_EQ(std::memcmp(&a.p_W, &b.p_W, sizeof a.p_W), 0);
  EXPECT_EQ(std::memcmp(&a.bubble_W, &b.bubble_W, sizeof a.bubble_W), 0);
}

TEST(TwoHands, WhatTheClutchHoldsStaysAndTheBubbleComesAlong) {
  HandsSpec spec = spec_of();
  spec.explore = Explore::clutch;
  TwoHands hands(spec);
  HandsInput input;
  input.push_N = {Vec3(1, 0, 0), Vec3(4, 2, 0)};
  const Vec3 reached = hands.see(input).p_W[1];
  hands.move(kStep_s, false);
  input.clutch = {false, true};
  input.push_N[1] = Vec3(-4, 0, 0);
  EXPECT_WITHIN((hands.see(input).p_W[1] - reached).norm(), 0.0, 1e-15);
  input.clutch = {};
  EXPECT_WITHIN((hands.see(input).p_W[1] - reached).norm(), 0.0, 1e-15);
  input.push_N[1] = Vec3(0, 0, 0);
  EXPECT_GT(hands.see(input).p_W[1].x(), reached.x() + 0.02) << "it reaches farther than before";
}

/// Points of the segment are inside exactly where the clipped part says.
TEST(Clip, SaysWhichPointsOfASegmentAreInside) {
  Random random(7, 14);
  for (int k = 0; k < 3000; ++k) {
    const Vec3 size_m(0.06, 0.05, 0.08);
    const Vec3 a = test::random_vector(random, 0.08), b = test::random_vector(random, 0.08);
    for (const Shape shape : {Shape::box, Shape::sphere, Shape::cylinder}) {
      const auto part = clip(shape, size_m, a, b);
      for (int i = 0; i <= 50; ++i) {
        const double t = i / 50.0;
        const Vec3 p = a + t * (b - a);
        const bool inside = shape == Shape::box ? (p.cwiseAbs() - size_m / 2.0).maxCoeff() < 0.0
                            : shape == Shape::sphere
                                ? p.norm() < 0.03
                                : p.head<2>().norm() < 0.03 && std::abs(p.z()) < 0.025;
        constexpr double kEdge = 1e-9;
        if (inside)
          ASSERT_TRUE(part && t >= part->from - kEdge && t <= part->to + kEdge) << k;
        else
          ASSERT_TRUE(!part || t <= part->from + kEdge || t >= part->to - kEdge) << k;
      }
    }
  }
}

TEST(Pinch, OnSpringsGivesNoMoreEnergyThanItTook) {
  const std::string file = kData + "tilt_spring.toml";
  const HandsScene scene = test::must(parse_hands_scene(test::must(read_text(file)), file));
  const Plan plan = test::must(Plan::compile(scene.object, kStep_s));
  Random random(8, 14);
  for (int trial = 0; trial < 20; ++trial) {
    CarriedObject object(plan, scene.magnet);
    GraspOfHands grasp(*scene.grasp, scene.object.shape, scene.object.size_m);
    const std::array<Vec3, kSides> push{Vec3(3, 0, 0), Vec3(-3, 0, 0)};
    std::array<Vec3, kSides> p{Vec3(-0.033, 0, 0), Vec3(0.033, 0, 0)};
    ASSERT_TRUE(grasp.see(p, push, object.state().X_WO));
    const double k = scene.magnet.stiffness_N_m;
    const auto stored = [&] {
      const ObjectState& now = object.state();
      double energy = 0.5 * scene.object.mass_kg * now.v_WO_W.squaredNorm() +
                      0.5 * now.w_WO_W.dot(scene.object.inertia_kg_m2.cwiseProduct(now.w_WO_W));
      for (std::size_t side = 0; side < kSides; ++side)
        energy +=
            0.5 * k * (p[side] - now.X_WO.p - now.X_WO.q * grasp.anchors_O()[side]).squaredNorm();
      return energy;
    };
    double had = stored();
    EXPECT_LE(had, 2 * 0.5 * k * std::pow(scene.grasp->reach_m, 2)) << "what attaching gives";
    Vec3 v = Vec3::Zero();
    for (int row = 0; row < 300; ++row) {
      object.move(p, grasp, kStep_s);
      constexpr double kIntegrated = 1e-9;
      ASSERT_LE(stored(), had + kIntegrated) << "while the hands stand still nothing comes in";
      v = 0.9 * v + test::random_vector(random, 0.05);
      for (Vec3& hand : p) hand += Vec3(kStep_s * v.x(), kStep_s * v.y(), 0.0);
      had = stored();
    }
  }
}

TEST(HandsScene, WhatIsWrongIsToldWithItsKey) {
  const std::string file = kData + "tilt_spring.toml";
  const std::string good = test::must(read_text(file));
  const auto field = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto scene = parse_hands_scene(text.replace(at, from.size(), to), file);
    return scene ? std::string() : scene.error().field;
  };
  EXPECT_EQ(field("left_share = 0.5", "left_share = 0.5"), "");
  EXPECT_EQ(field("left_share = 0.5", "left_share = 1.5"), "hands.left_share");
  EXPECT_EQ(field("rate_m_s = 0.1", "rate_m_s = 0"), "hands.rate_m_s");
  EXPECT_EQ(field("force_at_edge_N = [8.0, 8.0, 8.0]", "force_at_edge_N = [8.0, -1.0, 8.0]"),
            "hands.left.force_at_edge_N");
  EXPECT_EQ(field("center_m = [-0.05, 0.0, 0.0]", "center_m = [0.0, 0.0, 0.0]"), "hands.left");
  EXPECT_EQ(field("stiffness_N_m = 150.0", "stiffness_N_m = -1.0"), "magnet.stiffness_N_m");
  EXPECT_EQ(field("shape = \"ellipsoid\"", "shape = \"star\""), "hands.shape");
  // Beside so much the separation of the hands is lost to rounding, and they would cross.
  EXPECT_EQ(field("rate_m_s = 0.1", "rate_m_s = 1e17"), "hands.rate_m_s");
  EXPECT_EQ(field("half_size_m = [0.05, 0.05, 0.05]", "half_size_m = [1e17, 0.05, 0.05]"),
            "hands.half_size_m");
  EXPECT_EQ(field("center_m = [-0.05, 0.0, 0.0]", "center_m = [-1e17, 0.0, 0.0]"),
            "hands.left.center_m");
  EXPECT_EQ(field("mode = \"spring\"", "mode = \"spring\"\nglue = 1"), "magnet.glue");
}

TEST(HandsScene, NumbersOfPadsThatWouldOverflowAreRefusedWithTheirKey) {
  const std::string file = kData + "../pad_lift.toml";
  const std::string good = test::must(read_text(file));
  const auto field = [&](const std::string& key, const std::string& value) {
    std::string text = good;
    const std::size_t at = text.find(key + " = ");
    EXPECT_NE(at, std::string::npos) << key;
    const std::size_t end = text.find('\n', at);
    const auto scene = parse_hands_scene(text.replace(at, end - at, key + " = " + value), file);
    return scene ? std::string() : scene.error().field;
  };
  EXPECT_EQ(field("mass_kg", "0.2"), "");
  EXPECT_EQ(field("mass_kg", "1e200"), "object.mass_kg");
  EXPECT_EQ(field("inertia_kg_m2", "[6e205, 6e-5, 6e-5]"), "object.inertia_kg_m2");
  EXPECT_EQ(field("damping", "[1e10, 0, 0, 0, 0, 0]"), "dynamics.damping");
  EXPECT_EQ(field("step_s", "1e-12"), "dynamics.step_s");
  EXPECT_EQ(field("foundation_N_m3", "1e300"), "pad[1].foundation_N_m3");
}

}  // namespace
}  // namespace isograsp::bimanual::two_hands_test
