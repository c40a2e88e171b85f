// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled plan: locked axes, frames, rules, limits, hands; what is real time.
#include "grasp_model/plan.hpp"

#include <cmath>

#include "tests/grasp_model/support.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::plan_test {
namespace {

FingerWrenches press(double thumb_N, double index_N, double middle_N,
                     const Vec3& sideways = {0, 0, 0}) {
  FingerWrenches forces;
  forces[0].force = sideways + Vec3(0, 0, thumb_N);
  forces[1].force = sideways + Vec3(0, 0, index_N);
  forces[2].force = sideways + Vec3(0, 0, middle_N);
  return forces;
}

const FingerWrenches kPress = press(4.0, 2.5, 1.0, {0.6, 0.3, 0.0});

ObjectState run(const Plan& plan, const FingerWrenches& forces, int holds) {
  ObjectState state = plan.initial_state();
  for (int i = 0; i < holds; ++i) plan.move(plan.grasp(forces, state), state);
  return state;
}

std::string dynamics(const std::string& free, const std::string& more = "") {
  return "free = [" + free +
         "]\nstiffness = [30, 40, 50, 0.2, 0.2, 0.2]\n"
         "damping = [1, 1, 1, 0.001, 0.001, 0.001]\n" +
         more;
}

TEST(Plan, LockedAxesKeepTheirBits) {
  Scene scene = test::scene_of(
      test::block(dynamics("\"x\", \"rz\"", "gravity_m_s2 = [1, -9.81, 3]"),
                  "[initial]\nposition_m = [0.1, 0.2, 0.3]\n" + test::kDeviceContacts));
  const ObjectState state = run(test::plan_of(scene), kPress, 500);
  EXPECT_NE(state.X_WO.p.x(), 0.1);
  EXPECT_EQ(state.X_WO.p.y(), 0.2);
  EXPECT_EQ(state.X_WO.p.z(), 0.3);
  EXPECT_EQ(state.X_WO.q.x(), 0.0);
  EXPECT_EQ(state.X_WO.q.y(), 0.0);
  EXPECT_EQ(state.v_WO_W.y(), 0.0);
  EXPECT_EQ(state.w_WO_W.x(), 0.0);
  EXPECT_NE(state.w_WO_W.z(), 0.0);
}

/// A pose that differs from the origin in every degree of freedom but turns about one axis alone.
Pose turned_about(const Vec3& axis, double angle_rad) {
  return {Vec3(0.11, -0.07, 0.05), Quat(Eigen::AngleAxisd(angle_rad, axis))};
}

TEST(Plan, AnObjectPutDownRestsThereAndItsLockedAxesStay) {
  const Scene scene = test::scene_of(
      test::block(dynamics("\"x\", \"rz\""),
                  "[initial]\nposition_m = [0.1, 0.2, 0.3]\nvelocity_m_s = [1, 0, 0]\n" +
                      test::kDeviceContacts));
  const Plan plan = test::plan_of(scene);
  const ObjectState state = plan.at_rest(turned_about(Vec3::UnitZ(), 0.4));
  EXPECT_EQ(state.X_WO.p, Vec3(0.11, 0.2, 0.3));
  EXPECT_WITHIN(state.angle_rad, 0.4, 4.0 * test::kEpsilon);
  EXPECT_WITHIN(angle_between(state.X_WO.q, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitZ()))), 0.0,
                4.0 * test::kEpsilon);
  EXPECT_EQ(state.v_WO_W, Vec3::Zero());
  EXPECT_EQ(state.w_WO_W, Vec3::Zero());
  EXPECT_EQ(state.contact, (std::array<bool, kFingerCount>{})) << "nobody touches it yet";
}

TEST(Plan, ALockedAttitudeStaysWhateverThePoseSays) {
  const Plan plan = test::plan_of(test::scene_of(test::block(dynamics("\"x\", \"y\""))));
  const ObjectState state = plan.at_rest(turned_about(Vec3::UnitZ(), 0.4));
  EXPECT_EQ(state.X_WO.q.coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(state.angle_rad, 0.0);
}

TEST(Plan, OneFreeRotationTakesItsOwnAngleWithinHalfATurn) {
  const Plan plan = test::plan_of(test::scene_of(test::block(dynamics("\"ry\""))));
  constexpr double kRounding_rad = 4e-15;
  for (const double angle_rad : {-3.0, -0.5, 0.0, 1.5, 3.0}) {
    Pose pose = turned_about(Vec3::UnitY(), angle_rad);
    EXPECT_WITHIN(plan.at_rest(pose).angle_rad, angle_rad, kRounding_rad);
    pose.q.coeffs() = -pose.q.coeffs();  // the same attitude
    EXPECT_WITHIN(plan.at_rest(pose).angle_rad, angle_rad, kRounding_rad);
  }
  EXPECT_EQ(plan.at_rest(turned_about(Vec3::UnitX(), 0.5)).angle_rad, 0.0);
}

TEST(Plan, AnObjectPutDownGoesBackTheShorterWayWhicheverSignsItsQuaternionsHave) {
  const Pose pose = turned_about(Vec3(1, 2, 2) / 3.0, 0.6);
  Pose same = pose;
  same.q.coeffs() = -same.q.coeffs();
  for (const char* initial : {"[1, 0, 0, 0]", "[-1, 0, 0, 0]"})
    for (const char* free : {"\"rz\"", "\"rx\", \"ry\", \"rz\""}) {
      const Plan plan = test::plan_of(test::scene_of(test::block(
          dynamics(free),
          "[initial]\nquaternion_wxyz = " + std::string(initial) + "\n" + test::kDeviceContacts)));
      for (const Pose& put : {pose, same}) {
        ObjectState state = plan.at_rest(put);
        const Quat before = state.X_WO.q;
        double largest_rad = angle_between(before, Quat::Identity());
        plan.step({}, state);
        EXPECT_GT(before.dot(state.X_WO.q), 0.0) << "the sign is continuous";
        for (int hold = 0; hold < 2; ++hold) {
          plan.step({}, state);
          const double angle_rad = angle_between(state.X_WO.q, Quat::Identity());
          EXPECT_LE(angle_rad, largest_rad);
          largest_rad = angle_rad;
        }
      }
    }
}

TEST(Plan, EachFreeAxisMovesAsIfAlone) {
  const ObjectState all =
      run(test::plan_of(test::scene_of(test::block(dynamics("\"x\", \"y\", \"z\", \"ry\"")))),
          kPress, 300);
  const ObjectState y =
      run(test::plan_of(test::scene_of(test::block(dynamics("\"y\"")))), kPress, 300);
  const ObjectState ry =
      run(test::plan_of(test::scene_of(test::block(dynamics("\"ry\"")))), kPress, 300);
  EXPECT_EQ(all.X_WO.p.y(), y.X_WO.p.y());
  EXPECT_EQ(all.angle_rad, ry.angle_rad);
}

TEST(Plan, OneAxisAndThreeAxesAgreeOnATurnAboutOneAxis) {
  const auto three = test::scene_of(test::block(dynamics("\"rx\", \"ry\", \"rz\"")));
  const auto one = test::scene_of(test::block(dynamics("\"rz\"")));
  FingerWrenches forces = press(0, 0, 0);
  forces[1].force = Vec3(0, 0, 2);  // torque about z alone
  const ObjectState a = run(test::plan_of(three), forces, 200);
  const ObjectState b = run(test::plan_of(one), forces, 200);
  EXPECT_GT(std::abs(b.angle_rad), 0.01);
  EXPECT_LE((a.X_WO.q.coeffs() - b.X_WO.q.coeffs()).norm(), 1e-7);
}

TEST(Plan, HoldOfAnotherLengthIsThePlanOfThatLength) {
  const auto scene = test::scene_of(test::block(dynamics("\"x\", \"y\", \"rz\"")));
  const Plan fast = test::plan_of(scene, 0.004);
  const Plan slow = test::plan_of(scene, 0.01);
  ObjectState a = fast.initial_state();
  ObjectState b = slow.initial_state();
  for (int i = 0; i < 100; ++i) {
    fast.move(fast.grasp(kPress, a), a);
    slow.move(slow.grasp(kPress, b), 0.004, b);
  }
  EXPECT_EQ(a.X_WO.p, b.X_WO.p);
  EXPECT_EQ(a.angle_rad, b.angle_rad);
}

TEST(Plan, ForceInHandAxesIgnoresTheAttitudeAndInObjectAxesTurnsWithIt) {
  const std::string quarter =
      "[initial]\nquaternion_wxyz = [0.7071067811865476, 0, 0, 0.7071067811865476]\n";
  const auto wrench = [&](const std::string& frame) {
    const Plan plan = test::plan_of(test::scene_of(
        test::block(dynamics("\"x\", \"y\", \"rz\"", "wrench_frame = \"" + frame + "\""),
                    quarter + test::kDeviceContacts)));
    ObjectState state = plan.initial_state();
    return plan.grasp(press(5, 1, 1), state).F_O_W;
  };
  EXPECT_LE((wrench("hand").force - Vec3(3, 0, 0)).norm(), 1e-15);
  EXPECT_LE((wrench("object").force - Vec3(0, 3, 0)).norm(), 1e-15);
  EXPECT_LE((wrench("object").torque - wrench("hand").torque).norm(), 1e-16);
}

/// The follower scenes with a hold against the same motion in 2,000 short holds with the force
/// turned by hand at the middle of each: that converges with the square of the short hold.
void expect_follows_exactly(const std::string& free, double tolerance) {
  const auto scene = test::scene_of(
      test::block(dynamics(free, "wrench_frame = \"object\"\ngravity_m_s2 = [0.3, 0, 0]"),
                  "[initial]\nangular_velocity_rad_s = [0, 0, 9]\n" + test::kDeviceContacts));
  auto by_hand = scene;
  by_hand.wrench_frame = WrenchFrame::hand;
  const double hold_s = 0.05;
  const Plan plan = test::plan_of(scene, hold_s);
  ObjectState state = plan.initial_state();
  plan.move(plan.grasp(kPress, state), state);
  EXPECT_FALSE(state.tolerance_exceeded);

  const auto fine = [&](int parts) {
    const Plan part = test::plan_of(by_hand, hold_s / parts);
    const Plan half = test::plan_of(by_hand, hold_s / parts / 2);
    ObjectState at = part.initial_state();
    const Wrench F_O = part.grasp(kPress, at).F_O_W;
    for (int i = 0; i < parts; ++i) {
      // The torque follows the attitude as well: turned at the middle, found by half a step.
      GraspWrench push;
      ObjectState middle = at;
      push.held = {at.X_WO.q * F_O.force, at.X_WO.q * F_O.torque};
      half.move(push, middle);
      push.held = {middle.X_WO.q * F_O.force, middle.X_WO.q * F_O.torque};
      part.move(push, at);
    }
    return at;
  };
  const ObjectState coarse = fine(1000);
  const ObjectState finer = fine(2000);
  const Vec3 p = finer.X_WO.p + (finer.X_WO.p - coarse.X_WO.p) / 3.0;
  const Vec3 v = finer.v_WO_W + (finer.v_WO_W - coarse.v_WO_W) / 3.0;
  EXPECT_GT(std::abs(state.angle_rad) + state.X_WO.q.vec().norm(), 0.1);
  EXPECT_LE((state.X_WO.p - p).norm(), tolerance * p.norm());
  EXPECT_LE((state.v_WO_W - v).norm(), tolerance * v.norm());
}

TEST(Plan, AForceThatTurnsWithinTheHoldIsIntegratedExactly) {
  expect_follows_exactly("\"x\", \"y\", \"rz\"", 1e-11);
}
TEST(Plan, AForceThatTurnsFreelyWithinTheHoldIsIntegratedToTheTolerance) {
  expect_follows_exactly("\"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\"", 1e-9);
}

TEST(Plan, AStiffFollowerFlagsOrAgreesWithTheFixedForceWhenNothingTurns) {
  for (const double k : {1e2, 1e5, 1e9, 1e13}) {
    auto scene =
        test::scene_of(test::block(dynamics("\"x\", \"rz\"", "wrench_frame = \"object\"")));
    scene.stiffness[0] = k;
    auto fixed = scene;
    fixed.wrench_frame = WrenchFrame::hand;
    FingerWrenches push;
    push[0].force.z() = 3.0;  // through the COM: no torque
    const ObjectState a = run(test::plan_of(scene), push, 50);
    const ObjectState b = run(test::plan_of(fixed), push, 50);
    EXPECT_WITHIN(a.X_WO.p.x() / b.X_WO.p.x(), 1.0, k < 1e8 ? 1e-10 : 0.5);
    EXPECT_EQ(a.tolerance_exceeded, k > 1e8);
  }
}

TEST(Plan, TravelLimitsStopTheBlockAndTheKnob) {
  const auto scene = test::scene_of(test::block(dynamics(
      "\"x\", \"rz\"",
      "limits = [{dof = \"x\", min_m = -0.02, max_m = 0.01}, {dof = \"rz\", min_rad = -0.1}]")));
  const Plan plan = test::plan_of(scene);
  ObjectState state = plan.initial_state();
  double most = 0.0;
  double least_angle = 0.0;
  for (int i = 0; i < 300; ++i) {
    plan.move(plan.grasp(press(5, 1, 0, {2, 0, 0}), state), state);
    most = std::max(most, state.X_WO.p.x());
    least_angle = std::min(least_angle, state.angle_rad);
  }
  EXPECT_EQ(most, 0.01);
  EXPECT_EQ(state.v_WO_W.x(), 0.0);
  EXPECT_GE(least_angle, -0.1);
}

TEST(Plan, UnderAForceThatTurnsTheStopIsMetInsideTheHold) {
  // One hold of 50 ms against 64 short ones: the fingers push the same in object axes.
  for (const std::string free : {"\"x\", \"y\", \"rz\"", "\"x\", \"y\", \"rx\", \"ry\", \"rz\""}) {
    const auto scene = test::scene_of(test::block(
        dynamics(free,
                 "wrench_frame = \"object\"\nlimits = [{dof = \"x\", max_m = 0.004}, "
                 "{dof = \"y\", min_m = -0.002, max_m = 0.002}]"),
        "[initial]\nvelocity_m_s = [0.1, 0.05, 0]\nangular_velocity_rad_s = [0, 0, 6]\n" +
            test::kDeviceContacts));
    const double hold_s = 0.05;
    const Plan whole = test::plan_of(scene, hold_s);
    const Plan part = test::plan_of(scene, hold_s / 64);
    ObjectState a = whole.initial_state();
    ObjectState b = a;
    whole.step(kPress, a);
    for (int i = 0; i < 64; ++i) part.step(kPress, b);
    EXPECT_EQ(b.X_WO.p.y(), 0.002);  // it has met this stop, and stays
    EXPECT_EQ(a.X_WO.p.y(), b.X_WO.p.y());
    EXPECT_EQ(a.v_WO_W.y(), 0.0);
    EXPECT_WITHIN(a.X_WO.p.x(), b.X_WO.p.x(), 1e-10);
    EXPECT_WITHIN(a.v_WO_W.x(), b.v_WO_W.x(), 1e-8);
    EXPECT_LE(angle_between(a.X_WO.q, b.X_WO.q), 1e-9);
  }
}

TEST(Plan, GraspRulesDecideWhetherFingersMoveTheBlock) {
  const auto force = [](const std::string& rule, const FingerWrenches& forces) {
    const Plan plan = test::plan_of(test::scene_of(
        test::block(dynamics("\"x\", \"y\", \"rz\"", "grasp_rule = \"" + rule + "\""))));
    ObjectState state = plan.initial_state();
    const GraspWrench wrench = plan.grasp(forces, state);
    EXPECT_EQ(wrench.contact[0], forces[0].force.z() > 0);  // touching is told either way
    return wrench.F_O_W.force.norm();
  };
  EXPECT_GT(force("any", press(3, 0, 0)), 0.0);
  EXPECT_EQ(force("opposition", press(3, 0, 0)), 0.0);
  EXPECT_EQ(force("closure", press(0, 2, 2)), 0.0);
  EXPECT_GT(force("opposition", press(3, 0, 1)), 0.0);
  EXPECT_GT(force("closure", press(3, 1, 1)), 0.0);
}

TEST(Plan, ThreeLeftDigitsPushingToThePatientsRightMoveTheBlockRight) {
  const auto scene = test::scene_of(test::block(dynamics("\"x\", \"y\", \"rz\"")));
  for (const Hand hand : {Hand::right, Hand::left}) {
    const Scene turned = for_hand(scene, hand);
    FingerWrenches forces;
    for (const auto& contact : turned.contacts)
      forces[index_of(contact.finger)].force =
          contact.R_OC.transpose() * Vec3(2.0, 0, 0) + Vec3(0, 0, 5.0);
    const ObjectState state = run(test::plan_of(turned), forces, 20);
    EXPECT_GT(state.X_WO.p.x(), 0.0) << name_of(hand);
  }
  // The thumb of the left hand stands on the right, and pressing with it moves the block left.
  const ObjectState thumb = run(test::plan_of(for_hand(scene, Hand::left)), press(3, 0, 0), 20);
  EXPECT_LT(thumb.X_WO.p.x(), 0.0);
}

TEST(Plan, TurningTheDeviceByPiGivesTheMirroredMotion) {
  const auto scene = test::scene_of(test::block(dynamics("\"x\", \"y\", \"rz\"")));
  const ObjectState right = run(test::plan_of(scene), kPress, 200);
  const ObjectState left = run(test::plan_of(for_hand(scene, Hand::left)), kPress, 200);
  EXPECT_EQ(left.X_WO.p.x(), -right.X_WO.p.x());
  EXPECT_EQ(left.X_WO.p.y(), right.X_WO.p.y());
  EXPECT_EQ(left.angle_rad, -right.angle_rad);
}

TEST(Plan, ScalingForceMassSpringAndDamperByPowersOfTwoChangesNoBit) {
  auto scene = test::scene_of(test::block(dynamics("\"x\", \"y\", \"rz\"")));
  const ObjectState plain = run(test::plan_of(scene), kPress, 200);
  scene.mass_kg *= 4;
  scene.inertia_kg_m2 *= 4;
  scene.stiffness *= 4;
  scene.damping *= 4;
  FingerWrenches forces = kPress;
  for (auto& wrench : forces) wrench.force *= 4;
  const ObjectState scaled = run(test::plan_of(scene), forces, 200);
  EXPECT_EQ(plain.X_WO.p, scaled.X_WO.p);
  EXPECT_EQ(plain.v_WO_W, scaled.v_WO_W);
  EXPECT_EQ(plain.angle_rad, scaled.angle_rad);
}

TEST(Plan, TheSignOfTheQuaternionIsTheFilesAndChangesNoPhysics) {
  for (const std::string free : {"\"rz\"", "\"rx\", \"ry\", \"rz\""}) {
    const auto from = [&](const std::string& q) {
      return test::plan_of(test::scene_of(test::block(
          dynamics(free), "[initial]\nquaternion_wxyz = " + q + "\n" + test::kDeviceContacts)));
    };
    const Plan plus = from("[0.8, 0, 0, 0.6]");
    const Plan minus = from("[-0.8, 0, 0, -0.6]");
    EXPECT_EQ(minus.initial_state().X_WO.q.w(), -0.8);
    const ObjectState a = run(plus, kPress, 300);
    const ObjectState b = run(minus, kPress, 300);
    EXPECT_EQ(a.X_WO.q.coeffs(), Eigen::Vector4d(-b.X_WO.q.coeffs()));
    EXPECT_EQ(a.w_WO_W, b.w_WO_W);
  }
}

TEST(Plan, AKnobTurnedTwiceKeepsAContinuousQuaternion) {
  auto scene = test::scene_of(test::block(dynamics("\"rz\"")));
  scene.stiffness.setZero();
  const Plan plan = test::plan_of(scene);
  ObjectState state = plan.initial_state();
  Eigen::Vector4d last = state.X_WO.q.coeffs();
  for (int i = 0; i < 2000 && std::abs(state.angle_rad) < 14.0; ++i) {
    plan.move(plan.grasp(press(0, 0.5, 0), state), state);
    EXPECT_LT((state.X_WO.q.coeffs() - last).norm(), 0.5);
    last = state.X_WO.q.coeffs();
  }
  EXPECT_GT(std::abs(state.angle_rad), 13.0);
}

TEST(Plan, GravityIsAConstantForceAndNotPartOfTheFingersWrench) {
  auto scene = test::scene_of(test::block(dynamics("\"y\"", "gravity_m_s2 = [0, -9.81, 0]")));
  const Plan plan = test::plan_of(scene);
  ObjectState state = run(plan, press(0, 0, 0), 6000);
  EXPECT_WITHIN(state.X_WO.p.y(), -0.3 * 9.81 / 40.0, 1e-12);
  EXPECT_EQ(plan.grasp(press(0, 0, 0), state).F_O_W.force, Vec3::Zero());
}

TEST(Plan, TwoRotationsAndALimitOnAFreeBodyAreRefused) {
  const auto two = Plan::compile(test::scene_of(test::block(dynamics("\"rx\", \"ry\""))), 0.01);
  ASSERT_FALSE(two.ok());
  EXPECT_EQ(two.error().field, "dynamics.free");
  const auto limit =
      Plan::compile(test::scene_of(test::block(dynamics("\"rx\", \"ry\", \"rz\"",
                                                        "limits = [{dof = \"rx\", max_rad = 1}]"))),
                    0.01);
  ASSERT_FALSE(limit.ok());
  EXPECT_FALSE(Plan::compile(test::scene_of(test::block(dynamics("\"x\""))), 0.0).ok());
}

TEST(Plan, AFrameAllocatesNothing) {
  for (const std::string name : {"planar_block", "knob", "free_block"}) {
    const Scene scene =
        test::scene_file(std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/" + name + ".toml");
    const Plan plan = test::plan_of(scene);
    ObjectState state = plan.initial_state();
    const auto before = test::allocations();
    for (int i = 0; i < 100; ++i) {
      const GraspWrench wrench = plan.grasp(kPress, state);
      plan.move(wrench, state);
      plan.move(wrench, 0.007, state);
    }
    EXPECT_EQ(test::allocations(), before) << name;
  }
  static_assert(noexcept(std::declval<const Plan&>().move(std::declval<const GraspWrench&>(),
                                                          std::declval<ObjectState&>())));
}

TEST(Plan, ShippedScenesRestWhenNobodyTouchesThem) {
  for (const std::string name : {"planar_block", "knob", "free_block"}) {
    const Scene scene =
        test::scene_file(std::string(ISOGRASP_SOURCE_DIR) + "/library/scenes/" + name + ".toml");
    const Plan plan = test::plan_of(scene);
    const ObjectState state = run(plan, {}, 1000);
    EXPECT_LE((state.X_WO.p - scene.initial_X_WO.p).norm(), 1e-12) << name;
  }
}

}  // namespace
}  // namespace isograsp::plan_test
