// SPDX-License-Identifier: GPL-3.0-or-later
// An object without a hand: in the air, on springs, on a table.
#include <gtest/gtest.h>

#include "grasp_model/rotation.hpp"
#include "hand_world/experiments.hpp"
#include "tests/hand_world/support.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::object_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::hand_world;
using virtual_hand::ObjectShape;

ObjectBody slim() {
  return solid_object({ObjectShape::Kind::box, {0.01, 0.01, 0.075}}, 1000.0);
}
ObjectBody flat() {
  return solid_object({ObjectShape::Kind::cylinder, {0.04, 0.04, 0.005}}, 1000.0);
}

double energy_J(const World& world) {
  return world.object().kinetic_J() +
         world.object().body().mass_kg * 9.81 * world.object().motion().X_WO.p.y();
}

TEST(FreeObject, KeepsItsEnergyWhileItTumblesAndFalls) {
  constexpr double kRounding = 1e-11;  // of 2000 steps
  Random random(3);
  for (const ObjectBody& body : {slim(), flat()}) {
    World world(body, {});
    ObjectMotion motion;
    motion.X_WO = random_pose(random);
    motion.v_WO_W = {0.3, 1.0, -0.2};
    motion.w_WO_O = {20.0, 3.0, 9.0};
    world.place_object(motion);
    const double before_J = energy_J(world);
    for (int k = 0; k < 2000; ++k) world.step(kStep_s);
    EXPECT_WITHIN(energy_J(world), before_J, kRounding * before_J);
  }
}

TEST(FreeObject, MassAndInertiaOfASolidAreThoseOfItsPoints) {
  Random random(4);
  for (const ObjectBody& body : {slim(), flat()}) {
    const Vec3& half = body.shape.half_m;
    Vec3 squares = Vec3::Zero();
    int inside = 0;
    constexpr int kPoints = 200000;
    for (int k = 0; k < kPoints; ++k) {
      const Vec3 p = half.cwiseProduct(random_vector(random, 1.0));
      if (body.shape.kind == ObjectShape::Kind::cylinder && p.head<2>().norm() > half.x()) continue;
      squares += p.cwiseProduct(p);
      ++inside;
    }
    constexpr double kSampled = 0.01;
    const double mass_kg = 1000.0 * 8.0 * half.prod() * inside / kPoints;
    EXPECT_WITHIN(mass_kg, body.mass_kg, kSampled * body.mass_kg);
    const Vec3 mean = squares / inside;
    const Vec3 inertia = body.mass_kg * (mean.sum() * Vec3::Ones() - mean);
    for (Eigen::Index a = 0; a < 3; ++a)
      EXPECT_WITHIN(inertia[a], body.inertia_kg_m2[a], kSampled * body.inertia_kg_m2[a]);
  }
}

/// Three springs, the object pushed off its rest; where it is after a tenth of a second.
Vec3 swung(double step_s) {
  World world(slim(), {});
  for (const Vec3& p : {Vec3(-0.01, 0.0, 0.05), Vec3(0.01, 0.01, 0.0), Vec3(0.0, -0.01, -0.06)}) {
    const std::size_t number = world.hang(p, 200.0, 1.0);
    world.lead(number, p + Vec3(0.004, 0.002, -0.003), Vec3::Zero());
  }
  for (int k = 0; k < static_cast<int>(std::lround(0.1 / step_s)); ++k) world.step(step_s);
  const Pose& X_WO = world.object().motion().X_WO;
  return X_WO.p + X_WO.q * Vec3(0.01, 0.01, 0.075);
}

TEST(HangingObject, AHalfStepQuartersTheError) {
  const Vec3 truth = swung(0.001 / 64.0);
  const double coarse_m = (swung(0.001) - truth).norm();
  const double fine_m = (swung(0.0005) - truth).norm();
  constexpr double kSecondOrder = 4.0;
  EXPECT_WITHIN(coarse_m / fine_m, kSecondOrder, 0.3);
  constexpr double kMillisecond_m = 2e-5;  // what the reference cases allow
  EXPECT_LT(coarse_m, kMillisecond_m);
}

TEST(ObjectOnTable, FallsTumblesAndComesToRestWithoutGainingEnergy) {
  Random random(5);
  for (int fall = 0; fall < 12; ++fall) {
    const ObjectBody body = fall % 2 == 0 ? slim() : flat();
    World world(body, {});
    world.place_ground({});
    ObjectMotion motion;
    motion.X_WO = {{0.0, 0.15, 0.0}, random_attitude(random)};
    motion.w_WO_O = random_vector(random, 10.0);
    world.place_object(motion);
    double least_J = energy_J(world);
    // What its pads can have stored: forces of a hard landing, F^2 / (2 k) with k = 20 kN/m.
    constexpr double kPads_J = 2e-3;
    for (int k = 0; k < 6000; ++k) {
      world.step(kStep_s);
      const double now_J = energy_J(world);
      ASSERT_LT(now_J, least_J + kPads_J) << fall << " at " << k;
      least_J = std::min(least_J, now_J);
    }
    EXPECT_TRUE(world.supported()) << fall;
    constexpr double kStill_m_s = 0.1;  // a disk may still roll on its rim
    EXPECT_LT(std::abs(world.object().motion().v_WO_W.y()), kStill_m_s) << fall;
    constexpr double kSunk_m = 0.0005;
    EXPECT_GT(world.object().motion().X_WO.p.y(), body.shape.half_m.minCoeff() - kSunk_m);
  }
}

TEST(ObjectOnTable, StandsForAMinuteWithoutCreepingOnASlopeOfGravity) {
  for (const ObjectBody& body : {slim(), flat()}) {
    WorldRules rules;
    rules.ground_friction = 0.5;
    rules.gravity_W = {3.0, -9.81, 0.0};  // as on a slope of 17 degrees; friction holds 26
    World world(body, rules);
    world.place_ground({});
    ObjectMotion motion;
    const bool cylinder = body.shape.kind == ObjectShape::Kind::cylinder;
    motion.X_WO.p.y() = cylinder ? body.shape.half_m.z() : body.shape.half_m.y();
    if (cylinder) motion.X_WO.q = so3::shortest(Vec3::UnitZ(), Vec3::UnitY());
    world.place_object(motion);
    for (int k = 0; k < 1000; ++k) world.step(kStep_s);
    const Vec3 settled = world.object().motion().X_WO.p;
    for (int k = 0; k < 60000; ++k) world.step(kStep_s);
    constexpr double kCreep_m = 1e-9;
    EXPECT_WITHIN((world.object().motion().X_WO.p - settled).norm(), 0.0, kCreep_m);
  }
}

TEST(ObjectOnTable, StandsOnABlockAndOnTheTableBesideIt) {
  WorldRules rules;
  const Ground ground{0.1, SupportBlock{0.0, 0.0, 0.03, 0.03, 0.12}};
  for (const double x_m : {0.0, 0.2}) {
    World world(solid_object({ObjectShape::Kind::box, {0.005, 0.005, 0.01}}, 1000.0), rules);
    world.place_ground(ground);
    ObjectMotion motion;
    motion.X_WO.p = {x_m, 0.14, 0.0};
    world.place_object(motion);
    for (int k = 0; k < 2000; ++k) world.step(kStep_s);
    constexpr double kSunk_m = 1e-5;
    EXPECT_TRUE(world.supported());
    EXPECT_WITHIN(world.object().motion().X_WO.p.y(), (x_m == 0.0 ? 0.12 : 0.1) + 0.005, kSunk_m);
  }
}

TEST(Sliding, ADiskStopsWhereTheExactFrictionStopsIt) {
  constexpr double kMillisecond = 0.01;
  constexpr double kTiny_m = 1e-9;
  for (const Fields& row : every(golden_table(hand_data("slide_spin.csv")))) {
    const Slide setup{number_in(row, "friction"), number_in(row, "gravity_m_s2"),
                      number_in(row, "radius_m"), number_in(row, "v0_mps"),
                      number_in(row, "w0_radps")};
    const SlideResult result = slide(setup);
    ASSERT_TRUE(result.stopped);
    const double stop_s = number_in(row, "stop_s");
    const double distance_m = number_in(row, "distance_m");
    const double angle_rad = number_in(row, "angle_rad");
    EXPECT_WITHIN(result.stop_s, stop_s, 2.0 * setup.step_s);
    EXPECT_WITHIN(result.distance_m, distance_m, kMillisecond * distance_m + kTiny_m);
    EXPECT_WITHIN(result.angle_rad, angle_rad, kMillisecond * angle_rad);
  }
}

TEST(Sliding, AtTheEndEveryDiskSlidesAndTurnsInOneRatio) {
  constexpr double kRatio = 0.653;  // v / (w R) of a disk of uniform pressure
  constexpr double kNear = 0.01;    // a thousandth of the speed is left
  for (const double w0_rad_s : {10.0, 40.0}) {
    Slide setup{0.4, 9.81, 0.03, 0.5, w0_rad_s};
    setup.step_s = 1e-5;
    EXPECT_WITHIN(slide(setup).last_slip, kRatio, kNear) << w0_rad_s;
  }
}

TEST(Squeezing, TwoPadsHoldFromTheLeastForceOnAndSlipBelowIt) {
  constexpr double kAbove = 1.01;
  constexpr double kBelow = 0.97;
  AtLeast seen(10);
  for (const Fields& row : golden_table(hand_data("pinch_threshold.csv"))) {
    Squeeze setup;
    setup.mass_kg = number_in(row, "mass_kg");
    if (setup.mass_kg > 0.1) continue;
    ++seen;
    setup.gravity_m_s2 = number_in(row, "gravity_m_s2");
    setup.pad = {number_in(row, "friction"), number_in(row, "patch_radius_m")};
    setup.offset_m = number_in(row, "offset_m");
    const double least_N = number_in(row, "least_normal_force_exact_N");
    setup.force_N = kAbove * least_N;
    SqueezeResult result = squeeze(setup);
    constexpr double kHeld_m = 1e-6;
    EXPECT_LT(result.slip_m, kHeld_m) << row.at("id");
    EXPECT_LT(result.turn_rad, kHeld_m / setup.pad.patch_radius_m) << row.at("id");
    setup.force_N = kBelow * least_N;
    result = squeeze(setup);
    EXPECT_TRUE(result.slip_m > 1e-3 || result.turn_rad > 1e-2) << row.at("id");
  }
}

TEST(ObjectOnTable, AStepAllocatesNothing) {
  World world(flat(), {});
  world.place_ground({});
  const auto before = allocations();
  for (int k = 0; k < 100; ++k) world.step(kStep_s);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace isograsp::object_test
