// SPDX-License-Identifier: GPL-3.0-or-later
// A hand that grips: laws first, then the hard cases.
#include <gtest/gtest.h>

#include "grasp_model/rotation.hpp"
#include "hand_world/tracked_target.hpp"
#include "tests/hand_world/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::grip_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::hand_world;
using virtual_hand::DigitState;
using virtual_hand::HandModel;
using virtual_hand::ObjectShape;

const std::vector<Digit> kTwo{Digit::thumb, Digit::index};
const std::vector<Digit> kThree{Digit::thumb, Digit::index, Digit::middle};
const std::vector<Digit> kFive{Digit::thumb, Digit::index, Digit::middle, Digit::ring,
                               Digit::little};
constexpr double kGap_m = 0.002;
constexpr double kPress_m = 0.012;

HandModel middle_hand() {
  return golden_hand("hand_default");
}

double energy_J(const World& world) {
  return world.object().kinetic_J() +
         world.object().body().mass_kg * 9.81 * world.object().motion().X_WO.p.y();
}

/// Everything is a number, and nothing is faster than anything here may be.
void expect_sound(const World& world) {
  constexpr double kFast_m_s = 30.0;
  const ObjectMotion& motion = world.object().motion();
  EXPECT_TRUE(motion.X_WO.p.allFinite() && motion.X_WO.q.coeffs().allFinite());
  EXPECT_LT(motion.v_WO_W.norm(), kFast_m_s);
  if (world.hand() == nullptr) return;
  EXPECT_TRUE(world.hand()->pose().X_WP.p.allFinite());
  EXPECT_LT(world.hand()->velocity().palm_v_W.norm(), kFast_m_s);
}

TEST(Grip, HoldsAnObjectAgainstItsWeightWithoutCreeping) {
  for (const auto& digits : {kTwo, kThree, kFive}) {
    Grip grip = grip_of(middle_hand(), digits, kGap_m, {});
    grip.run(grip.pressed(kPress_m), 1000);
    const Pose settled = grip.object().X_WO;
    grip.run(grip.pressed(kPress_m), 5000);
    constexpr double kCreep_m = 1e-9;
    constexpr double kCreep_rad = 1e-7;
    EXPECT_WITHIN((grip.object().X_WO.p - settled.p).norm(), 0.0, kCreep_m) << digits.size();
    EXPECT_WITHIN(angle_between(grip.object().X_WO.q, settled.q), 0.0, kCreep_rad);
    EXPECT_TRUE(grip.world->touches()[0].contact);
  }
}

TEST(Grip, TheSameCallsGiveTheSameBits) {
  const auto run = [] {
    Grip grip = grip_of(middle_hand(), kFive, kGap_m, {});
    for (int k = 0; k < 500; ++k) grip.run(grip.pressed(kPress_m * (k % 100) / 100.0), 1);
    return grip.object();
  };
  const ObjectMotion a = run();
  const ObjectMotion b = run();
  EXPECT_EQ(a.X_WO.p, b.X_WO.p);
  EXPECT_EQ(a.X_WO.q.coeffs(), b.X_WO.q.coeffs());
  EXPECT_EQ(a.w_WO_O, b.w_WO_O);
}

/// A turn about the vertical and a shift.
Pose moved(const Pose& by, const Pose& pose) {
  return {by.p + by.q * pose.p, (by.q * pose.q).normalized()};
}

TEST(Grip, DoesNotDependOnWhereTheWorldStandsAndLooks) {
  const Pose by{{0.7, 0.2, -0.4}, Quat(Eigen::AngleAxisd(1.1, Vec3::UnitY()))};
  Grip here = grip_of(middle_hand(), kTwo, kGap_m, {});
  Grip there = grip_of(middle_hand(), kTwo, kGap_m, {});
  virtual_hand::HandPose pose = half_closed();
  pose.X_WP = moved(by, pose.X_WP);
  there.world->place_hand(middle_hand(), pose);
  ObjectMotion motion = there.object();
  motion.X_WO = moved(by, motion.X_WO);
  there.world->place_object(motion);
  HandTarget target = here.pressed(kPress_m);
  HandTarget turned = target;
  turned.palm.X_W = moved(by, target.palm.X_W);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      turned.links[d][k].X_W = moved(by, target.links[d][k].X_W);
  here.run(target, 400);
  there.run(turned, 400);
  // Contacts that slip first settle to 0.1 um/s a step; tangents lie otherwise.
  constexpr double kSame_m = 1e-6;
  constexpr double kSame_rad = 1e-4;
  const Pose expected = moved(by, here.object().X_WO);
  EXPECT_WITHIN((there.object().X_WO.p - expected.p).norm(), 0.0, kSame_m);
  EXPECT_WITHIN(angle_between(there.object().X_WO.q, expected.q), 0.0, kSame_rad);
}

TEST(Grip, ALeftHandIsTheReflectionOfARightOne) {
  HandModel left = middle_hand();
  left.side = Hand::left;
  const auto mirror = [](const Pose& pose) {
    return Pose{{-pose.p.x(), pose.p.y(), pose.p.z()},
                Quat(pose.q.w(), pose.q.x(), -pose.q.y(), -pose.q.z())};
  };
  Grip right = grip_of(middle_hand(), kTwo, kGap_m, {});
  World world(right.world->object().body(), {});
  virtual_hand::HandPose pose = half_closed();
  pose.X_WP = mirror(pose.X_WP);
  world.place_hand(left, pose);
  ObjectMotion motion;
  motion.X_WO = mirror(right.object().X_WO);
  world.place_object(motion);
  const HandTarget target = right.pressed(kPress_m);
  HandTarget reflected = target;
  reflected.palm.X_W = mirror(target.palm.X_W);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      reflected.links[d][k].X_W = mirror(target.links[d][k].X_W);
  for (int k = 0; k < 400; ++k) world.step(kStep_s, reflected);
  right.run(target, 400);
  constexpr double kSame_m = 1e-6;
  const Vec3 expected = mirror(right.object().X_WO).p;
  EXPECT_WITHIN((world.object().motion().X_WO.p - expected).norm(), 0.0, kSame_m);
}

TEST(Grip, AnObjectThatIsLetGoGainsNoEnergy) {
  for (const double mass_kg : {0.002, 0.06, 0.3}) {
    Grip grip = grip_of(middle_hand(), kThree, kGap_m, {}, 0.02, 0.05, mass_kg);
    const virtual_hand::TieGains gains = virtual_hand::tie_gains({mass_kg});
    grip.run(grip.pressed(kPress_m), 500);
    std::array<DigitState, kDigitCount> states{};
    states[0] = states[1] = states[2] = DigitState::attached;
    grip.world->tie(states, gains);
    EXPECT_TRUE(grip.world->tied(Digit::index));
    grip.run(grip.pressed(kPress_m), 200);
    states.fill(DigitState::blocked);  // all in one row
    grip.world->tie(states, gains);
    EXPECT_FALSE(grip.world->tied(Digit::index));
    const double before_J = energy_J(*grip.world);
    constexpr double kRounding_J = 1e-12;
    for (int k = 0; k < 140; ++k) {
      grip.run(grip.open, 1);
      ASSERT_LE(energy_J(*grip.world), before_J + kRounding_J) << mass_kg << " at " << k;
    }
  }
}

TEST(Grip, TiedFingersCarryWhatTheirNormalForceCouldNot) {
  WorldRules slippery;
  slippery.pad.friction = 0.02;
  Grip grip = grip_of(middle_hand(), kTwo, kGap_m, slippery);
  grip.run(grip.pressed(kPress_m), 60);
  std::array<DigitState, kDigitCount> states{};
  states[0] = states[1] = DigitState::attached;
  grip.world->tie(states, virtual_hand::tie_gains({0.06}));
  ASSERT_TRUE(grip.world->tied(Digit::thumb) && grip.world->tied(Digit::index));
  const double begin_m = grip.object().X_WO.p.y();
  grip.run(grip.pressed(kPress_m), 3000);
  constexpr double kStretched_m = 0.02;  // springs give by 2 mm under the load, the hand more
  EXPECT_GT(grip.object().X_WO.p.y(), begin_m - kStretched_m);
  constexpr double kStill_m_s = 1e-3;
  EXPECT_LT(grip.object().v_WO_W.norm(), kStill_m_s);
  EXPECT_LT(grip.world->assistance_row(0.0).digits[1].pull_N,
            virtual_hand::tie_gains({0.06}).release_N);
}

TEST(Coupling, NoStepPushesTheHandHarderThanItsLimitsAllow) {
  const HandDynamics dynamics;
  const double most_N = 15.0 * dynamics.link.most_N + dynamics.palm.most_N;
  const double mass_kg = 0.3 + 5.0 * (0.012 + 0.008 + 0.005);
  Grip grip = grip_of(middle_hand(), kTwo, 0.01, weightless());
  HandTarget target = grip.open;
  target.palm.X_W.p.x() += 1.0;  // the hand is seen a metre beside
  for (auto& digit : target.links)
    for (auto& link : digit) link.X_W.p.x() += 1.0;
  ObjectMotion away;
  away.X_WO.p.y() = -5.0;
  grip.world->place_object(away);
  Vec3 last = grip.world->hand()->velocity().palm_v_W;
  double fastest_m_s = 0.0;
  for (int k = 0; k < 3000; ++k) {
    grip.run(target, 1);
    const Vec3 now = grip.world->hand()->velocity().palm_v_W;
    fastest_m_s = std::max(fastest_m_s, now.norm());
    // Fingers may swing against the palm: twice what all together could do.
    ASSERT_LT((now - last).norm(), 2.0 * kStep_s * most_N / mass_kg) << k;
    last = now;
  }
  EXPECT_GT(fastest_m_s, 1.0);
  constexpr double kThere_m = 0.002;
  EXPECT_LT((palm_middle(grip.world->hand()->in_space()).p - target.palm.X_W.p).norm(), kThere_m);
}

TEST(HardCases, HandsOfAllSizesAndSidesGripAndStayCalm) {
  for (const char* name : {"hand_default", "hand_large", "hand_small_left"}) {
    Grip grip = grip_of(golden_hand(name), kTwo, kGap_m, {});
    grip.run(grip.pressed(kPress_m), 2000);
    expect_sound(*grip.world);
    constexpr double kStill_m_s = 1e-4;
    EXPECT_LT(grip.object().v_WO_W.norm(), kStill_m_s) << name;
    EXPECT_TRUE(grip.world->touches()[0].contact && grip.world->touches()[1].contact) << name;
  }
}

/// The middle-sized hand, larger or smaller in all its measures.
HandModel hand_of_length(double length_m) {
  HandModel hand = middle_hand();
  const double scale = length_m / hand.length_m;
  hand.length_m *= scale;
  hand.breadth_m *= scale;
  for (auto& digit : hand.digits) {
    digit.base_m *= scale;
    digit.metacarpal_m *= scale;
    for (double& length : digit.lengths_m) length *= scale;
    for (double& radius : digit.radii_m) radius *= scale;
  }
  return hand;
}

TEST(HardCases, TheSmallestAndTheLargestHandsGripToo) {
  for (const double length_m : {0.15, 0.22}) {
    Grip grip = grip_of(hand_of_length(length_m), kThree, kGap_m, {});
    grip.run(grip.pressed(kPress_m), 2000);
    expect_sound(*grip.world);
    constexpr double kStill_m_s = 1e-4;
    EXPECT_LT(grip.object().v_WO_W.norm(), kStill_m_s) << length_m;
    EXPECT_TRUE(grip.world->touches()[0].contact && grip.world->touches()[1].contact) << length_m;
  }
}

TEST(HardCases, AHandThatBeginsInsideTheObjectPushesItOutGently) {
  Grip grip = grip_of(middle_hand(), kTwo, -0.015, weightless());
  double fastest_m_s = 0.0;
  for (int k = 0; k < 1000; ++k) {
    grip.run(grip.open, 1);
    fastest_m_s = std::max(fastest_m_s, grip.object().v_WO_W.norm());
  }
  expect_sound(*grip.world);
  constexpr double kGentle_m_s = 2.0;
  EXPECT_LT(fastest_m_s, kGentle_m_s);
}

TEST(HardCases, AnObjectWedgedBetweenFingersAndTableStays) {
  Grip grip = grip_of(middle_hand(), kThree, kGap_m, {});
  const Pose& X_WO = grip.object().X_WO;
  const Vec3 reach =
      (X_WO.q.toRotationMatrix().cwiseAbs() * grip.world->object().body().shape.half_m);
  Ground ground;
  ground.table_m = X_WO.p.y() - reach.y();
  grip.world->place_ground(ground);
  HandTarget target = grip.pressed(kPress_m);
  target.palm.X_W.p.y() -= 0.02;
  for (auto& digit : target.links)
    for (auto& link : digit) link.X_W.p.y() -= 0.02;
  for (int k = 0; k < 3000; ++k) {
    grip.run(target, 1);
    ASSERT_LT(grip.object().v_WO_W.norm(), 2.0) << k;
  }
  expect_sound(*grip.world);
  EXPECT_TRUE(grip.world->supported());
  constexpr double kSunk_m = 0.003;
  EXPECT_GT(grip.object().X_WO.p.y(), ground.table_m - kSunk_m);
}

TEST(HardCases, ALightObjectOnStiffSpringsIsHeldAndLetGo) {
  Grip grip = grip_of(middle_hand(), kTwo, kGap_m, {}, 0.02, 0.05, 0.002);
  grip.run(grip.pressed(kPress_m), 200);
  virtual_hand::TieGains gains = virtual_hand::tie_gains({0.002});
  gains.stiffness_N_m = 300.0;
  std::array<DigitState, kDigitCount> states{};
  states[0] = states[1] = DigitState::attached;
  grip.world->tie(states, gains);
  grip.run(grip.pressed(kPress_m), 2000);
  expect_sound(*grip.world);
  constexpr double kStill_m_s = 1e-4;
  EXPECT_LT(grip.object().v_WO_W.norm(), kStill_m_s);
}

TEST(HardCases, AFistAroundAThinRodAndARodAlongAFingerStayCalm) {
  const HandModel model = middle_hand();
  virtual_hand::HandPose fist = half_closed();
  for (std::size_t d = 1; d < kDigitCount; ++d) fist.angles[d] = {0.0, 1.4, 1.6, 1.0};
  const virtual_hand::HandInSpace closed = virtual_hand::hand_in_space(model, fist);
  for (const bool coaxial : {false, true}) {
    World world(solid_object({ObjectShape::Kind::cylinder, {0.006, 0.006, 0.05}}, 1000.0),
                weightless());
    world.place_hand(model, fist);
    ObjectMotion motion;
    const auto& index = closed.digit(Digit::index);
    const Vec3 along = coaxial ? Vec3(index.joints[1] - index.joints[0])
                               : Vec3(closed.digit(Digit::little).joints[2] - index.joints[2]);
    motion.X_WO.p = coaxial ? Vec3(0.5 * (index.joints[0] + index.joints[1]))
                            : Vec3(closed.digit(Digit::middle).joints[2]);
    motion.X_WO.q = so3::shortest(Vec3::UnitZ(), along);
    world.place_object(motion);
    const HandTarget target = still_target(closed);
    double fastest_m_s = 0.0;
    for (int k = 0; k < 1500; ++k) {
      world.step(kStep_s, target);
      fastest_m_s = std::max(fastest_m_s, world.object().motion().v_WO_W.norm());
    }
    expect_sound(world);
    constexpr double kThrown_m_s = 3.0;
    EXPECT_LT(fastest_m_s, kThrown_m_s) << coaxial;
  }
}

TEST(HardCases, AHandThatJumpsAMetreThroughTheObjectLeavesNumbersBehind) {
  Grip grip = grip_of(middle_hand(), kFive, kGap_m, {});
  grip.run(grip.pressed(kPress_m), 300);
  HandTarget target = grip.pressed(kPress_m);
  target.palm.X_W.p.z() += 1.0;
  for (auto& digit : target.links)
    for (auto& link : digit) link.X_W.p.z() += 1.0;
  for (int k = 0; k < 2000; ++k) grip.run(target, 1);
  expect_sound(*grip.world);
}

TEST(Grip, AStepAllocatesNothing) {
  Grip grip = grip_of(middle_hand(), kFive, kGap_m, {});
  grip.world->place_ground({});
  const HandTarget target = grip.pressed(kPress_m);
  const auto before = allocations();
  grip.run(target, 200);
  EXPECT_EQ(allocations(), before);
  EXPECT_GE(grip.world->contacts().size(), 5U);
}

TEST(TrackedTarget, IsBetweenTwoFramesAndNoFasterThanItsLimits) {
  const HandTarget first = still_target(virtual_hand::hand_in_space(middle_hand(), half_closed()));
  HandTarget second = first;
  second.palm.X_W.p.x() += 0.01;
  second.links[1][2].X_W.p.x() += 1.0;  // a jump
  constexpr double kRounding = 1e-12;
  const HandTarget now = between_targets(first, second, 0.25, 0.02);
  EXPECT_WITHIN(now.palm.X_W.p.x(), first.palm.X_W.p.x() + 0.0025, kRounding);
  EXPECT_WITHIN(now.palm.v_m_s.x(), 0.5, kRounding);
  EXPECT_WITHIN(now.links[1][2].v_m_s.norm(), kMostTracked_m_s, kRounding);
  EXPECT_WITHIN(furthest(first, second), 1.0, kRounding);
  EXPECT_WITHIN(between_targets(second, second, 0.5, 0.02).palm.v_m_s.norm(), 0.0, kRounding);
}

}  // namespace
}  // namespace isograsp::grip_test
