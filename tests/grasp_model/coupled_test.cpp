// SPDX-License-Identifier: GPL-3.0-or-later
// Springs and dampers at an angle to the world's axes: one matrix exponential.
#include "grasp_model/coupled.hpp"

#include <cmath>

#include "grasp_model/zoh.hpp"
#include "tests/grasp_model/support.hpp"

namespace isograsp::coupled_test {
namespace {

const Quat kTilt = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, -2).normalized()));
const Vec3 kStiffness(30, 400, 5);
const Vec3 kDamping(1, 0.2, 3);
const Vec3 kForce(0.7, -0.4, 1.1);
const Vec3 kStart_m(0.02, -0.01, 0.03);
const Vec3 kSpeed_m_s(0.1, 0.3, -0.2);
/// Rounding of two rotations and of sums over three axes.
constexpr double kRounding = 20 * test::kEpsilon;

CoupledAxes tilted(double mass_kg, const std::array<bool, 3>& free = {true, true, true}) {
  const Mat3 R = kTilt.toRotationMatrix();
  return {mass_kg, R * kDamping.asDiagonal() * R.transpose(),
          R * kStiffness.asDiagonal() * R.transpose(), free};
}

TEST(CoupledStep, IsTheStepOfThreeAxesSeenFromATiltedFrame) {
  for (const double mass_kg : {0.3, 1e-3, 0.0}) {
    for (const double hold_s : {1e-3, 0.01, 0.1}) {
      const CoupledAxes axes = tilted(mass_kg);
      EXPECT_TRUE(axes.coupled());
      Vec3 x = kTilt * kStart_m;
      Vec3 v = mass_kg == 0.0 ? Vec3(Vec3::Zero()) : Vec3(kTilt * kSpeed_m_s);
      CoupledStep(axes, hold_s).advance(kTilt * kForce, x, v);
      Vec3 expected_x;
      Vec3 expected_v;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Motion end =
            LinearStep({mass_kg, kDamping[i], kStiffness[i]}, hold_s)
                .advance({kStart_m[i], mass_kg == 0.0 ? 0.0 : kSpeed_m_s[i]}, kForce[i]);
        expected_x[i] = end.x;
        expected_v[i] = end.v;
      }
      EXPECT_LE((x - kTilt * expected_x).norm(), kRounding * expected_x.norm());
      // The fastest rate of all, sqrt(k/m) or k/c, turns an error of position into one of speed.
      const double rate = mass_kg == 0.0 ? 2000.0 : std::sqrt(400.0 / mass_kg) + 3.0 / mass_kg;
      EXPECT_LE((v - kTilt * expected_v).norm(),
                kRounding * (expected_v.norm() + rate * expected_x.norm()));
    }
  }
}

TEST(CoupledStep, TwoHalvesMakeAWholeOnTwoFreeAxes) {
  const CoupledAxes axes = tilted(0.3, {true, false, true});
  const CoupledStep half(axes, 0.005);
  const CoupledStep whole(axes, 0.01);
  Vec3 x(0.02, 0.0, 0.03);
  Vec3 v(0.1, 0.0, -0.2);
  Vec3 x_halves = x;
  Vec3 v_halves = v;
  whole.advance(kForce, x, v);
  half.advance(kForce, x_halves, v_halves);
  half.advance(kForce, x_halves, v_halves);
  EXPECT_LE((x - x_halves).norm(), kRounding * x.norm());
  EXPECT_LE((v - v_halves).norm(), kRounding * v.norm() * 10);
  EXPECT_EQ(x.y(), 0.0);
}

TEST(CoupledStep, EnergyNeverGrowsWithoutForce) {
  const CoupledAxes axes = tilted(0.3);
  Vec3 x = kStart_m;
  Vec3 v = kSpeed_m_s;
  const CoupledStep step(axes, 0.02);
  double before = 0.5 * (0.3 * v.squaredNorm() + x.dot(axes.stiffness * x));
  for (int i = 0; i < 200; ++i) {
    step.advance(Vec3::Zero(), x, v);
    const double energy = 0.5 * (0.3 * v.squaredNorm() + x.dot(axes.stiffness * x));
    EXPECT_LE(energy, before * (1.0 + kRounding));
    before = energy;
  }
}

TEST(CoupledStep, APlanUsesItForTiltedSpringsAndOnlyThere) {
  const auto plan = [](const std::string& more) {
    return test::plan_of(
        test::scene_of(test::block("free = [\"x\", \"y\"]\nstiffness = [30, 400, 5, 0, 0, 0]\n"
                                   "damping = [1, 1, 1, 1, 1, 1]\n" +
                                   more)));
  };
  EXPECT_FALSE(plan("").coupled());
  EXPECT_FALSE(plan("damper_quaternion_wxyz = [0.8, 0, 0, 0.6]").coupled());  // the same all round
  EXPECT_FALSE(plan("spring_quaternion_wxyz = [0, 0, 0, 1]").coupled());      // half a turn
  const Plan tilted_plan = plan("spring_quaternion_wxyz = [0.9, 0, 0, 0.4358898943540674]");
  EXPECT_TRUE(tilted_plan.coupled());
  FingerWrenches forces;
  forces[0].force = Vec3(0, 0, 2);  // along x alone
  ObjectState state = tilted_plan.initial_state();
  for (int i = 0; i < 3000; ++i) tilted_plan.step(forces, state);
  EXPECT_GT(std::abs(state.X_WO.p.y()), 1e-3);  // and yet it moves along y
  const Mat3 R = Quat(0.9, 0, 0, 0.4358898943540674).normalized().toRotationMatrix();
  const Vec3 rest =
      R * Vec3(30, 400, 5).cwiseInverse().asDiagonal() * R.transpose() * Vec3(2, 0, 0);
  EXPECT_LE((state.X_WO.p.head<2>() - rest.head<2>()).norm(), 1e-12 * rest.norm());
}

TEST(CoupledStep, RefusesWhatItCannotDoExactly) {
  const auto refused = [](const std::string& more) {
    const auto scene =
        parse_scene(test::block("free = [\"x\", \"y\", \"rz\"]\nstiffness = [30, 400, 5, 0, 0, 0]\n"
                                "damping = [1, 1, 1, 1, 1, 1]\n"
                                "spring_quaternion_wxyz = [0.9, 0, 0, 0.4358898943540674]\n" +
                                more),
                    "test.toml");
    return !Plan::compile(*scene, 0.01).ok();
  };
  EXPECT_FALSE(refused(""));
  EXPECT_TRUE(refused("wrench_frame = \"object\""));
  EXPECT_TRUE(refused("limits = [{dof = \"x\", min_m = -0.1}]"));
}

}  // namespace
}  // namespace isograsp::coupled_test
