// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of pads over time: pressing gives way and never digs in, half the step is half the error, a
// second run is the same bits.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "bimanual/pads/pad_scenes.hpp"
#include "bimanual/pads/pad_step.hpp"
#include "core/random.hpp"
#include "tests/bimanual/any_step.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"

namespace isograsp::bimanual::pad_laws_test {
namespace {

constexpr std::array kSolvers{PadSolver::pointwise, PadSolver::aggregate,
                              PadSolver::aggregate_exact};

/// What the beds of all pads have stored at the end of a step [J].
double stored_J(const PadStep& step, const std::vector<Vec6>& velocity) {
  double energy = 0.0;
  for (const PadFace& face : step.faces)
    for (const PadPoint& point : face.points) {
      const Vec3 more = test::pads::slip_at(face, point, velocity) -
                        test::pads::slip_at(face, point, step.velocity_free);
      const double depth_m =
          std::max(0.0, point.penetration_free_m + step.step_s * point.normal.dot(more));
      energy += 0.5 * face.stiffness_N_m3 * point.area_m2 * depth_m * depth_m;
    }
  return energy;
}

/// A step without friction is the least of that energy and of what it costs to leave the free
/// motion: forces make pads dig in less, never more.
TEST(PadLaws, ForcesWithoutFrictionStoreLessThanTheFreeMotionWould) {
  Random random(51, 1);
  test::AtLeast pressing(200);
  for (int k = 0; k < 400; ++k) {
    PadStep step = test::pads::any_step(random, k, 30);
    for (PadFace& face : step.faces) face.friction = 0.0;
    const double free_J = stored_J(step, step.velocity_free);
    if (free_J == 0.0) continue;
    ++pressing;
    for (const PadSolver solver : {PadSolver::pointwise, PadSolver::aggregate_exact}) {
      const PadSolution solution = solve(step, solver);
      ASSERT_TRUE(solution.settled) << k;
      EXPECT_LE(stored_J(step, solution.velocity), free_J) << k;
    }
  }
}

/// How deep the deepest point is when a step begins [m].
double deepest_m(const PadStep& step) {
  double deepest = 0.0;
  for (const PadFace& face : step.faces)
    for (const PadPoint& point : face.points)
      deepest = std::max(
          deepest, point.penetration_free_m - step.step_s * point.normal.dot(test::pads::slip_at(
                                                                face, point, step.velocity_free)));
  return deepest;
}

TEST(PadLaws, WhatIsHeldStillIsNotEnteredFurther) {
  for (const PadScene scene : {PadScene::ball, PadScene::edge})
    for (const PadSolver solver : test::every(kSolvers)) {
      PadGrasp grasp = test::must(pad_grasp(scene, 24));
      grasp.pull_m_s2.setZero();
      grasp.turn_rad_s2 = 0.0;
      HeldByPads held(grasp.object, grasp.pads, grasp.step_s, solver, grasp.proxies(0.0));
      double at_rest_m = 0.0;
      for (int k = 1; k <= 1500; ++k) {
        const double t_s = k * grasp.step_s;
        if (k == 1000)
          at_rest_m = deepest_m(held.next(grasp.proxies(t_s), grasp.gravity_m_s2(t_s)));
        held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      }
      const double after_m = deepest_m(held.next(grasp.proxies(1.5), grasp.gravity_m_s2(1.5)));
      EXPECT_GT(at_rest_m, 1e-5) << "it is pressed";
      constexpr double kStill_m = 1e-10;  // what a second has left of the closing
      EXPECT_LE(after_m, at_rest_m + kStill_m)
          << kPadSceneNames[static_cast<std::size_t>(scene)] << " "
          << kPadSolverNames[static_cast<std::size_t>(solver)];
    }
}

Vec3 place_after(PadGrasp grasp, PadSolver solver, double step_s, double end_s) {
  grasp.step_s = step_s;
  HeldByPads held(grasp.object, grasp.pads, step_s, solver, grasp.proxies(0.0));
  const auto steps = std::lround(end_s / step_s);
  for (long k = 1; k <= steps; ++k) {
    const double t_s = static_cast<double>(k) * step_s;
    held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
  }
  return held.X_WO().p;
}

TEST(PadLaws, HalfTheStepIsHalfTheError) {
  for (const PadSolver solver : test::every(kSolvers)) {
    const PadGrasp grasp = test::must(pad_grasp(PadScene::edge, 24));
    constexpr double kStep_s = 5e-4, kEnd_s = 0.15;
    const auto place = [&](double step_s) { return place_after(grasp, solver, step_s, kEnd_s); };
    const Vec3 whole = place(kStep_s), half = place(kStep_s / 2.0), quarter = place(kStep_s / 4.0);
    const double ratio = (whole - half).norm() / (half - quarter).norm();
    // Of a first order method: 2, but for what is left of higher orders.
    EXPECT_GT(ratio, 1.8) << kPadSolverNames[static_cast<std::size_t>(solver)];
    EXPECT_LT(ratio, 2.2) << kPadSolverNames[static_cast<std::size_t>(solver)];
  }
}

TEST(PadLaws, ASecondRunIsTheSameBits) {
  for (const PadSolver solver : test::every(kSolvers)) {
    const PadGrasp grasp = test::must(pad_grasp(PadScene::pencil, 24));
    const auto place = [&] { return place_after(grasp, solver, grasp.step_s, 0.2); };
    EXPECT_EQ(place(), place()) << kPadSolverNames[static_cast<std::size_t>(solver)];
  }
}

}  // namespace
}  // namespace isograsp::bimanual::pad_laws_test
