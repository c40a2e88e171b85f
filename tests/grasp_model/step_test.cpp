// SPDX-License-Identifier: GPL-3.0-or-later
// One hold from finger forces to the new state: both ways of asking for it, and hard cases.
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "grasp_model/grasp.hpp"
#include "grasp_model/plan.hpp"
#include "tests/grasp_model/presses.hpp"
#include "tests/grasp_model/support.hpp"
#include "tests/support/within.hpp"

namespace isograsp::step_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const std::string kPlanar = "\"x\", \"y\", \"rz\"";
const std::string kTurning = "\"rx\", \"ry\", \"rz\"";
const std::string kAll = "\"x\", \"y\", \"z\", \"rx\", \"ry\", \"rz\"";

std::string dynamics(const std::string& free, const std::string& more = "") {
  return "free = [" + free +
         "]\nstiffness = [30, 40, 50, 0.2, 0.3, 0.2]\n"
         "damping = [1, 1, 1, 0.001, 0.002, 0.001]\n" +
         more;
}

Scene scene_with(const std::string& free, const std::string& more = "") {
  return test::scene_of(test::block(dynamics(free, more)));
}

void expect_same(const ObjectState& a, const ObjectState& b) {
  EXPECT_EQ(a.X_WO.p, b.X_WO.p);
  EXPECT_EQ(a.X_WO.q.coeffs(), b.X_WO.q.coeffs());
  EXPECT_EQ(a.v_WO_W, b.v_WO_W);
  EXPECT_EQ(a.w_WO_W, b.w_WO_W);
  EXPECT_EQ(a.contact, b.contact);
}

bool finite(const ObjectState& state) {
  return state.X_WO.p.allFinite() && state.X_WO.q.coeffs().allFinite() &&
         state.v_WO_W.allFinite() && state.w_WO_W.allFinite();
}

TEST(Step, WithAndWithoutTheRecordIsTheSameMotionBitForBit) {
  for (const char* frame : {"hand", "object"})
    for (const std::string& free : {std::string("\"rz\""), std::string("\"x\""), kPlanar, kAll,
                                    kTurning, "\"y\", " + kTurning, "\"x\", \"z\", " + kTurning})
      for (const ContactModel model :
           {ContactModel::frictionless, ContactModel::point, ContactModel::soft}) {
        Scene scene = scene_with(free, std::string("wrench_frame = \"") + frame + "\"");
        scene.contacts[1].model = model;
        scene.contacts[1].torsion_m = 0.004;
        for (auto& contact : scene.contacts) contact.threshold_N = 0.3;
        const Plan plan = test::plan_of(scene);
        ObjectState a = plan.initial_state();
        ObjectState b = a;
        test::Presses presses;
        for (int i = 0; i < 400; ++i) {
          const FingerWrenches forces = presses.next();
          plan.step(forces, a);
          plan.move(plan.grasp(forces, b), b);
        }
        expect_same(a, b);
        EXPECT_NE(a.X_WO.p.norm() + a.X_WO.q.vec().norm(), 0.0);
      }
}

TEST(Step, EveryKernelGivesTheBitsOfTheTwoHalvesOnEveryProcessor) {
  constexpr std::array<const char*, 3> kAxes{"\"x\"", "\"y\"", "\"z\""};
  for (unsigned along = 0; along < 8; ++along)
    for (const std::string& turning :
         {std::string(), std::string("\"rx\""), std::string("\"rz\""), kTurning})
      for (const bool stiff : {false, true}) {
        std::string free;
        for (unsigned axis = 0; axis < 3; ++axis)
          if ((along >> axis & 1) != 0)
            free += (free.empty() ? "" : ", ") + std::string(kAxes[axis]);
        if (!turning.empty()) free += (free.empty() ? "" : ", ") + turning;
        if (free.empty()) continue;
        Scene scene = scene_with(free);
        if (stiff) scene.stiffness.head<3>() *= 1e4;
        scene.gravity_m_s2 = {0.3, -9.81, 0.1};
        scene.anchor_m = {0.02, -0.01, 0.03};
        scene.initial_X_WO.p = {0.025, -0.01, 0.02};
        for (auto& contact : scene.contacts) contact.threshold_N = 0.3;
        const Plan plan = test::plan_of(scene);
        ObjectState whole = plan.initial_state();
        ObjectState halves = whole;
        ObjectState narrow = whole;
        test::HardPresses grasps;
        int held = 0;
        for (int i = 0; i < 600; ++i) {
          const FingerWrenches forces = grasps.next();
          plan.step(forces, whole);
          plan.step_narrow(forces, narrow);
          plan.move(plan.grasp(forces, halves), halves);
          held += whole.contact[0] && whole.contact[1] && whole.contact[2] ? 1 : 0;
          ASSERT_EQ(whole.contact, halves.contact) << free << ", frame " << i;
          ASSERT_EQ(whole.X_WO.p, halves.X_WO.p) << free << ", frame " << i;
        }
        SCOPED_TRACE(free);
        expect_same(whole, halves);
        expect_same(whole, narrow);
        EXPECT_GT(held, 100);
        EXPECT_LT(held, 500);
      }
}

TEST(Step, AForceThatIsNoNumberNeverEntersTheStateAndIsFlagged) {
  for (const std::string& free : {kPlanar, kAll})
    for (const double bad : {kNaN, kInf, -kInf})
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const Plan plan = test::plan_of(scene_with(free));
        ObjectState state = plan.initial_state();
        FingerWrenches forces;
        for (auto& wrench : forces) wrench.force.z() = 2.0;
        plan.step(forces, state);
        ASSERT_TRUE(state.contact[1]);
        forces[1].force[axis] = bad;
        ObjectState without = state;
        const GraspWrench wrench = plan.grasp(forces, state);
        EXPECT_TRUE(wrench.invalid[1]);
        EXPECT_FALSE(wrench.invalid[0]);
        EXPECT_TRUE(state.contact[1]) << "no sample is no release";
        EXPECT_EQ(wrench.utilisation[1], 0.0);
        plan.move(wrench, state);
        EXPECT_TRUE(finite(state));
        plan.step(forces, without);
        expect_same(state, without);
        // The others act as if alone.
        FingerWrenches others = forces;
        others[1] = {};
        ObjectState lone = plan.initial_state();
        EXPECT_EQ(plan.grasp(others, lone).held.force, wrench.held.force);
      }
}

TEST(Step, ForcesNearTheEndsOfTheNumbersStayNumbers) {
  for (const double size : {5e-324, 1e-300, 1e-160, 1e-100, 1e10, 1e50}) {
    for (const std::string& free : {std::string("\"x\""), kPlanar}) {
      const Plan plan = test::plan_of(scene_with(free));
      ObjectState state = plan.initial_state();
      FingerWrenches forces;
      for (auto& wrench : forces) wrench.force = Vec3(0.5, 0.9, 1.0) * size;
      forces[0].force.z() = 3.0 * size;
      for (int i = 0; i < 20; ++i) plan.step(forces, state);
      EXPECT_TRUE(finite(state)) << size;
      EXPECT_EQ(state.X_WO.p.x() != 0.0, size > 1e-320) << size;
    }
  }
}

TEST(Step, FingersThatPullDoNothing) {
  const Plan plan = test::plan_of(scene_with(kAll));
  ObjectState state = plan.initial_state();
  FingerWrenches forces;
  for (auto& wrench : forces) wrench.force = Vec3(3, -4, -5);
  const GraspWrench wrench = plan.grasp(forces, state);
  EXPECT_EQ(wrench.held.force, Vec3::Zero());
  plan.move(wrench, state);
  expect_same(state, plan.initial_state());
}

TEST(Step, OneFingerAloneTurnsAndPushes) {
  const Plan plan = test::plan_of(scene_with(kPlanar));
  ObjectState state = plan.initial_state();
  FingerWrenches forces;
  forces[2].force.z() = 2.0;  // middle: above the COM's line by -12.5 mm, pushes -x
  plan.step(forces, state);
  EXPECT_LT(state.X_WO.p.x(), 0.0);
  EXPECT_LT(state.angle_rad, 0.0);
}

TEST(Step, FrictionOfZeroAndOfAMillionAreLimitsOfTheSameModel) {
  for (const double mu : {0.0, 1e6, 1e12}) {
    Scene scene = scene_with(kPlanar);
    for (auto& contact : scene.contacts) contact.friction = mu;
    const Plan plan = test::plan_of(scene);
    ObjectState state = plan.initial_state();
    FingerWrenches forces;
    for (auto& wrench : forces) wrench.force = Vec3(1.0, 0.5, 2.0);
    const GraspWrench wrench = plan.grasp(forces, state);
    EXPECT_EQ(wrench.slip[0], mu == 0.0);
    EXPECT_WITHIN(wrench.held.force.y(), mu == 0.0 ? 0.0 : 3.0, 1e-15);
  }
}

TEST(Step, CoincidentAndCollinearContactsMoveTheObjectLikeOne) {
  Scene scene = scene_with(kPlanar);
  for (auto& contact : scene.contacts) {
    contact.p_OC = scene.contacts[0].p_OC;
    contact.R_OC = scene.contacts[0].R_OC;
  }
  const Plan plan = test::plan_of(scene);
  ObjectState together = plan.initial_state();
  ObjectState alone = together;
  FingerWrenches thirds;
  for (auto& wrench : thirds) wrench.force = Vec3(0.5, 0, 1.0);
  FingerWrenches whole;
  whole[0].force = 3.0 * thirds[0].force;
  plan.step(thirds, together);
  plan.step(whole, alone);
  EXPECT_LE((together.X_WO.p - alone.X_WO.p).norm(), 1e-18);
}

TEST(Step, PowerThatTheFingersGiveIsPowerThatTheObjectTakes) {
  // Duality of the grasp map: f . (G^T v) = (G f) . v for any motion.
  const Scene scene = scene_with(kAll);
  const Plan plan = test::plan_of(scene);
  test::Presses presses;
  for (int i = 0; i < 100; ++i) {
    ObjectState state = plan.initial_state();
    const GraspWrench wrench = plan.grasp(presses.next(), state);
    const Vec3 v(0.3, -0.2, 0.1 * i);
    const Vec3 w(0.5, 1.0, -0.4);
    double at_fingers = 0.0;
    double size = 0.0;
    test::Presses again;
    FingerWrenches forces;
    for (int j = 0; j <= i; ++j) forces = again.next();
    for (const auto& contact : scene.contacts) {
      const std::size_t f = index_of(contact.finger);
      if (!wrench.contact[f]) continue;
      const ContactForce force = clamp_to_friction(FrictionLimit(contact), forces[f]);
      const Vec3 v_C = contact.R_OC.transpose() * (v + w.cross(contact.p_OC));
      at_fingers += v_C.dot(Vec3(force.fx, force.fy, force.fz));
      size += v_C.norm() * Vec3(force.fx, force.fy, force.fz).norm();
    }
    EXPECT_WITHIN(at_fingers, wrench.held.force.dot(v) + wrench.held.torque.dot(w), 1e-15 * size);
  }
}

TEST(Step, AnyRateFrom50To1000HzTracesTheSameMotion) {
  // The same forces held for 20 ms in 1 to 20 holds: the exact step knows no rate.
  for (const std::string& free : {kPlanar, kAll}) {
    const auto after = [&](int per_20_ms) {
      const Plan plan = test::plan_of(scene_with(free), 0.02 / per_20_ms);
      ObjectState state = plan.initial_state();
      FingerWrenches forces;
      for (int i = 0; i < 50; ++i) {
        for (std::size_t f = 0; f < kFingerCount; ++f)
          forces[f].force = Vec3(0.2 * std::sin(0.3 * i), 0.1, 1.0 + 0.3 * static_cast<double>(f));
        for (int j = 0; j < per_20_ms; ++j) plan.step(forces, state);
      }
      return state;
    };
    const ObjectState coarse = after(1);
    for (const int per_20_ms : {2, 5, 20}) {
      const ObjectState fine = after(per_20_ms);
      const double tolerance = free == kAll ? 1e-9 : 1e-13;
      EXPECT_LE((coarse.X_WO.p - fine.X_WO.p).norm(), tolerance);
      EXPECT_LE(angle_between(coarse.X_WO.q, fine.X_WO.q), tolerance);
    }
  }
}

}  // namespace
}  // namespace isograsp::step_test
