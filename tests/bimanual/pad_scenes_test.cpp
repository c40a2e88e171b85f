// SPDX-License-Identifier: GPL-3.0-or-later
// The four scenes of soft pads: points are shared alike, pads touch, solvers agree as far as they
// say, and what is held stays where it is.
#include "bimanual/pads/pad_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::pad_scenes_test {
namespace {

constexpr std::array kScenes{PadScene::ball, PadScene::dumbbell, PadScene::pencil, PadScene::edge};

TEST(PadScenes, SharePointsAlikeAndEveryPadPresses) {
  for (const PadScene scene : test::every(kScenes))
    for (const int points : {12, 24, 48, 96, 176, 200}) {
      const auto grasp = test::must(pad_grasp(scene, points));
      const PadStep step = step_under_way(grasp);
      std::size_t all = 0;
      for (const PadFace& face : test::every(step.faces)) {
        EXPECT_EQ(face.points.size() * step.faces.size(), static_cast<std::size_t>(points));
        all += face.points.size();
      }
      EXPECT_EQ(all, static_cast<std::size_t>(points));
      const PadSolution solution = solve(step, PadSolver::aggregate);
      EXPECT_TRUE(solution.settled);
      constexpr double kPresses_N = 0.1;
      for (const Vec6& wrench : test::every(solution.wrench_on_object))
        EXPECT_GT(wrench.head<3>().norm(), kPresses_N)
            << kPadSceneNames[static_cast<std::size_t>(scene)] << " " << points;
    }
}

TEST(PadScenes, OnFlatFacesAnAggregateIsWithinFivePercentAndOnCurvedOnesWithinTen) {
  constexpr double kFlat = 0.05, kCurved = 0.10;
  for (const PadScene scene : test::every(kScenes))
    for (const int points : {48, 96}) {
      const PadStep step = step_under_way(test::must(pad_grasp(scene, points)));
      const PadSolution exact = solve(step, PadSolver::pointwise);
      const PadSolution aggregate = solve(step, PadSolver::aggregate);
      const bool flat = scene == PadScene::edge;
      EXPECT_EQ(aggregate.constraints, 4 * step.faces.size());
      EXPECT_LE(wrench_error(aggregate, exact), flat ? kFlat : kCurved)
          << kPadSceneNames[static_cast<std::size_t>(scene)] << " " << points;
    }
}

TEST(PadScenes, PointsThatCannotBeSharedAreRefusedWithTheOptionAndWhatCan) {
  for (const int points : {0, 8, 13, 402, 1'000'000}) {
    const auto grasp = pad_grasp(PadScene::ball, points);
    ASSERT_FALSE(grasp) << points;
    EXPECT_EQ(grasp.error().field, "--points");
    EXPECT_NE(grasp.error().message().find("multiple of 4 from 12 to 400"), std::string::npos);
  }
  EXPECT_TRUE(pad_grasp(PadScene::pencil, 6).ok());
}

TEST(HeldByPads, ABlockThatSticksDoesNotCreepWithAnySolver) {
  // What is left of closing after a second of damping, and of solving to 1e-10: ten micrometres
  // would be a creep of a micrometre a second.
  constexpr double kStill_m = 1e-9;
  for (const PadSolver solver : test::every(
           std::array{PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact})) {
    PadGrasp grasp = test::must(pad_grasp(PadScene::edge, 48));
    grasp.hand_m.y() = 0.0;
    grasp.pull_m_s2.setZero();
    grasp.turn_rad_s2 = 0.0;
    HeldByPads held(grasp.object, grasp.pads, grasp.step_s, solver, grasp.proxies(0.0));
    const auto hold_until = [&](double from_s, double to_s) {
      const auto first = std::lround(from_s / grasp.step_s) + 1;
      for (auto k = first; k <= std::lround(to_s / grasp.step_s); ++k) {
        const double t_s = static_cast<double>(k) * grasp.step_s;
        held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      }
      return held.X_WO().p;
    };
    const Vec3 early = hold_until(0.0, 1.0);
    const Vec3 late = hold_until(1.0, 2.0);
    EXPECT_LE((late - early).norm(), kStill_m) << kPadSolverNames[static_cast<std::size_t>(solver)];
  }
}

TEST(HeldByPads, APadBesideItsHandIsAPadWhoseHandIsThere) {
  PadGrasp grasp = test::must(pad_grasp(PadScene::edge, 24));
  PadGrasp beside = grasp;
  const Vec3 aside(0.0, 0.01, -0.02);
  beside.hand_m -= aside;
  for (PadSpec& pad : beside.pads) pad.from_hand_m = aside;
  grasp.turn_rad_s2 = beside.turn_rad_s2 = 0.0;  // a hand turns about itself
  const PadStep one = step_under_way(grasp), other = step_under_way(beside);
  constexpr double kRounding_m_s = 1e-9;  // of 200 steps
  for (std::size_t body = 0; body < one.velocity_free.size(); ++body)
    EXPECT_LE((one.velocity_free[body] - other.velocity_free[body]).norm(), kRounding_m_s);
  EXPECT_EQ(one.velocity_free.size(), 3U);
}

}  // namespace
}  // namespace isograsp::bimanual::pad_scenes_test
