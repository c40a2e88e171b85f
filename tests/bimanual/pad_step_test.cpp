// SPDX-License-Identifier: GPL-3.0-or-later
// One step of soft pads: against values made independently (tests/data/bimanual), and laws.
#include "bimanual/pads/pad_step.hpp"

#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "bimanual/pads/friction_block.hpp"
#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::pad_step_test {
namespace {

using Json = nlohmann::json;

template <int kRows>
Eigen::Matrix<double, kRows, 1> numbers(const Json& array) {
  Eigen::Matrix<double, kRows, 1> out;
  for (int i = 0; i < kRows; ++i) out[i] = array[static_cast<std::size_t>(i)].get<double>();
  return out;
}

PadStep step_of(const Json& one) {
  PadStep step;
  step.step_s = one["step_s"];
  for (const Json& rows : one["inertia_kg"]) {
    Mat6& inertia = step.inertia.emplace_back();
    for (int i = 0; i < 6; ++i)
      inertia.row(i) = numbers<6>(rows[static_cast<std::size_t>(i)]).transpose();
  }
  for (const Json& v : one["velocity_free"]) step.velocity_free.push_back(numbers<6>(v));
  for (const Json& pad : one["pads"]) {
    PadFace& face = step.faces.emplace_back();
    face.object = pad["object"];
    face.pad = pad["pad"];
    face.friction = pad["friction"];
    face.stiffness_N_m3 = pad["stiffness_N_m3"];
    for (std::size_t i = 0; i < pad["p_object_m"].size(); ++i)
      face.points.push_back({numbers<3>(pad["p_object_m"][i]), numbers<3>(pad["p_pad_m"][i]),
                             numbers<3>(pad["normal"][i]), pad["area_m2"][i],
                             pad["penetration_free_m"][i]});
  }
  return step;
}

Json golden_steps() {
  std::ifstream in(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/bimanual/pad_steps.json");
  return Json::parse(in)["cases"];
}

TEST(PadStep, EveryPointIsThatOfTheGoldenCasesAndPadsAsOneBlockAreNear) {
  constexpr double kForces = 1e-6, kVelocity = 1e-6;
  constexpr double kFlat = 0.05, kCurved = 0.10, kExactFlat = 1e-5;
  for (const Json& one : test::every(golden_steps())) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const PadStep step = step_of(one);
    const bool flat = one["flat"];
    PadSolution golden;
    for (const Json& pad : one["expected"]["pads"])
      golden.wrench_on_object.push_back(numbers<6>(pad["wrench_on_object"]));
    const PadSolution points = solve(step, PadSolver::pointwise);
    EXPECT_TRUE(points.settled);
    EXPECT_WITHIN(wrench_error(points, golden), 0.0, kForces);
    for (std::size_t b = 0; b < step.inertia.size(); ++b)
      EXPECT_WITHIN((points.velocity[b] - numbers<6>(one["expected"]["velocity"][b])).norm(), 0.0,
                    kVelocity);
    EXPECT_EQ(points.constraints, one["expected"]["constraints_pointwise"].get<std::size_t>());
    const PadSolution rough = solve(step, PadSolver::aggregate);
    const PadSolution exact = solve(step, PadSolver::aggregate_exact);
    EXPECT_WITHIN(wrench_error(rough, golden), 0.0, flat ? kFlat : kCurved);
    EXPECT_WITHIN(wrench_error(exact, golden), 0.0, flat ? kExactFlat : kCurved);
    for (const PadSolution* solution : {&rough, &exact}) {
      EXPECT_TRUE(solution->settled);
      EXPECT_EQ(solution->constraints, one["expected"]["constraints_aggregate"].get<std::size_t>());
    }
  }
}

/// Two square pads of n x n points squeeze a block of 65 mm that is pulled down.
PadStep squeezed(int n, double pull_mps, double spin_radps, double friction) {
  PadStep step;
  step.inertia.assign(3, Mat6::Identity());
  step.inertia[0].diagonal() << 0.3, 0.3, 0.3, 2.5e-4, 2.5e-4, 2.5e-4;
  for (int pad : {1, 2})
    step.inertia[static_cast<std::size_t>(pad)].diagonal() << 5, 5, 5, .01, .01, .01;
  step.velocity_free.assign(3, Vec6::Zero());
  step.velocity_free[0] << 0, -pull_mps, 0, spin_radps, 0, 0;
  for (const double side : {-1.0, 1.0}) {
    PadFace& face = step.faces.emplace_back();
    face.pad = side < 0 ? 1 : 2;
    face.friction = friction;
    face.stiffness_N_m3 = 4e7;
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const double width_m = 0.01 / n;
        const Vec3 across(0, width_m * (i + 0.5) - 0.005, width_m * (k + 0.5) - 0.005);
        face.points.push_back({Vec3(0.0325 * side, 0, 0) + across, across, -side * Vec3::UnitX(),
                               width_m * width_m, 1e-3});
      }
  }
  return step;
}

TEST(PadStep, WhatSticksDoesNotCreep) {
  for (const PadSolver solver :
       {PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact}) {
    const PadStep step = squeezed(4, 0.00981, 0.0, 0.8);
    const PadSolution solution = solve(step, solver);
    for (const PadFace& face : test::every(step.faces)) {
      const Vec6 slip = solution.velocity[face.pad] - solution.velocity[0];
      constexpr double kCreep_mps = 1e-14;  // rounding of velocities of 0.01 m/s
      EXPECT_WITHIN(slip[1], 0.0, kCreep_mps);
      EXPECT_WITHIN(slip[2], 0.0, kCreep_mps);
    }
  }
}

TEST(PadStep, ForcesStayInTheConeAndTakeNoEnergyFromNothing) {
  Random random(5, 5);
  for (int k = 0; k < 60; ++k) {
    const double friction = k % 6 == 0 ? 0.0 : random.uniform();
    const PadStep step = squeezed(3, 0.3 * random.uniform(), 20 * random.uniform(), friction);
    for (const PadSolver solver :
         {PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact}) {
      const PadSolution solution = solve(step, solver);
      ASSERT_TRUE(solution.settled) << k;
      for (std::size_t f = 0; f < step.faces.size(); ++f) {
        const Vec6& wrench = solution.wrench_on_object[f];
        const double normal_N = std::abs(wrench[0]);
        EXPECT_LE(std::hypot(wrench[1], wrench[2]), friction * normal_N * (1.0 + 1e-9) + 1e-12);
      }
      // Friction on the object is along the slip of the pad over it: its power there is positive.
      double power = 0.0;
      for (std::size_t f = 0; f < step.faces.size(); ++f) {
        Vec6 slip = solution.velocity[step.faces[f].pad] - solution.velocity[0];
        slip[0] = 0.0;
        power += slip.head<3>().dot(solution.wrench_on_object[f].head<3>()) +
                 slip[3] * solution.wrench_on_object[f][3];
      }
      EXPECT_GE(power, -1e-9);
    }
  }
}

TEST(PadStep, TheVelocityOfTheObjectIsWhatTheForcesMadeAlsoWhereAPadLetsGo) {
  Random random(7, 5);
  int let_go = 0;
  for (int k = 0; k < 200; ++k) {
    PadStep step = squeezed(3, 0.3 * random.uniform(), 20 * random.uniform(), random.uniform());
    // One pad is pulled off, or comes only because the other one pushes.
    step.velocity_free[2][0] = 2.0 * random.uniform() - 0.5;
    step.velocity_free[0][0] = random.uniform() - 0.5;
    for (PadPoint& point : step.faces[1].points)
      point.penetration_free_m = 2e-3 * random.uniform() - 1.2e-3;
    for (const PadSolver solver :
         {PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact}) {
      const PadSolution solution = solve(step, solver);
      Vec6 sum = Vec6::Zero();
      for (const Vec6& wrench : test::every(solution.wrench_on_object)) sum += wrench;
      const Vec6 made =
          step.inertia[0] * (solution.velocity[0] - step.velocity_free[0]) / step.step_s;
      EXPECT_WITHIN((made - sum).norm(), 0.0, 1e-9 * (1.0 + sum.norm())) << k;
      let_go += solution.wrench_on_object[1].isZero() ? 1 : 0;
      // The next step begins with these forces and ends where it would have without.
      const PadSolution again = solve(step, solver, &solution);
      EXPECT_WITHIN((again.velocity[0] - solution.velocity[0]).norm(), 0.0, 1e-7) << k;
    }
  }
  EXPECT_GT(let_go, 0);
}

TEST(PadStep, NothingActsWhereNothingTouches) {
  PadStep step = squeezed(3, 0.1, 1.0, 0.8);
  for (PadFace& face : step.faces)
    for (PadPoint& point : face.points) point.penetration_free_m = -1e-3;
  for (const PadSolver solver :
       {PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact}) {
    const PadSolution solution = solve(step, solver);
    for (const Vec6& wrench : test::every(solution.wrench_on_object)) EXPECT_TRUE(wrench.isZero());
    EXPECT_EQ(solution.velocity[0], step.velocity_free[0]);
  }
}

TEST(FrictionBlock, IsInsideAndLetsNothingSlipOrOnTheSurfaceAlongItsNormal) {
  Random random(6, 6);
  for (int k = 0; k < 20000; ++k) {
    const Eigen::Matrix3d root =
        Eigen::Matrix3d::NullaryExpr([&] { return random.uniform() - 0.5; });
    const Eigen::Matrix3d W = root * root.transpose() + 1e-3 * Eigen::Matrix3d::Identity();
    const Vec3 slip_free = 10.0 * test::random_vector(random, 1.0);
    const Vec3 limits(random.uniform(), random.uniform(), k % 7 == 0 ? 0.0 : random.uniform());
    const Vec3 f = friction_in_ellipsoid(W, slip_free, limits);
    const Vec3 slip = slip_free - W * f;
    const Vec3 y =
        Vec3::NullaryExpr([&](Eigen::Index i) { return limits[i] > 0 ? f[i] / limits[i] : 0.0; });
    ASSERT_LE(y.norm(), 1.0 + 1e-12);
    const Vec3 scaled = limits.cwiseProduct(slip);
    if (y.norm() < 1.0 - 1e-9) {
      ASSERT_LT(scaled.norm(), 1e-9 * slip_free.norm()) << k;
    } else {
      ASSERT_LT((scaled - scaled.norm() * y).norm(), 1e-9 * slip_free.norm()) << k;
    }
  }
}

}  // namespace
}  // namespace isograsp::bimanual::pad_step_test
