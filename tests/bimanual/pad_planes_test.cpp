// SPDX-License-Identifier: GPL-3.0-or-later
// Pads that rub in one plane (aggregate_exact): shares, plane and centroid are those of the end of
// the step, and friction is the one of greatest dissipation that all points together can give.
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
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::pad_planes_test {
namespace {

constexpr std::array kScenes{PadScene::ball, PadScene::dumbbell, PadScene::pencil, PadScene::edge};

TEST(PadPlanes, AreAllPointsOnFlatFaces) {
  constexpr double kFlat = 1e-8;
  for (const int count : test::every(std::array{12, 24, 48, 96, 176, 200})) {
    const PadStep step = step_under_way(test::must(pad_grasp(PadScene::edge, count)));
    const PadSolution points = solve(step, PadSolver::pointwise);
    EXPECT_WITHIN(wrench_error(solve(step, PadSolver::aggregate_exact), points), 0.0, kFlat)
        << count;
  }
}

/// What a face does at the end of a step, put together here once more from its velocities alone.
struct Plane {
  double pressure_N = 0.0;
  Vec6 pressure = Vec6::Zero();  ///< about the object's origin
  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
  std::vector<double> share;
};
Plane plane_at_end(const PadStep& step, const PadFace& face, const std::vector<Vec6>& velocity) {
  Plane plane;
  for (const PadPoint& point : face.points) {
    const Vec3 more = test::pads::slip_at(face, point, velocity) -
                      test::pads::slip_at(face, point, step.velocity_free);
    const double depth_m = point.penetration_free_m + step.step_s * point.normal.dot(more);
    const double N = face.stiffness_N_m3 * point.area_m2 * std::max(0.0, depth_m);
    plane.share.push_back(N);
    plane.pressure_N += N;
    plane.pressure.head<3>() += N * point.normal;
    plane.pressure.tail<3>() += point.p_object.cross(N * point.normal);
    plane.normal += N * point.normal;
    plane.middle += N * point.p_object;
  }
  if (plane.pressure_N == 0.0) return plane;
  for (double& share : plane.share) share /= plane.pressure_N;
  plane.normal.normalize();
  plane.middle /= plane.pressure_N;
  return plane;
}

/// Power that friction takes at most from a slip of the face (v, w): the support function.
double most_power(const PadFace& face, const Plane& plane, const Vec3& v, const Vec3& w) {
  double sum = 0.0;
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    Vec3 arm = face.points[i].p_object - plane.middle;
    arm -= plane.normal.dot(arm) * plane.normal;
    Vec3 u = v + w.cross(arm);
    u -= plane.normal.dot(u) * plane.normal;
    sum += plane.share[i] * u.norm();
  }
  return face.friction * plane.pressure_N * sum;
}

void expect_greatest_dissipation(const PadStep& step, const PadSolution& solution, Random& random) {
  ASSERT_TRUE(solution.settled);
  for (std::size_t f = 0; f < step.faces.size(); ++f) {
    const PadFace& face = step.faces[f];
    const Plane plane = plane_at_end(step, face, solution.velocity);
    const Vec6 friction = solution.wrench_on_object[f] - plane.pressure;
    const Vec3 force = friction.head<3>();
    const Vec3 torque = friction.tail<3>() - plane.middle.cross(force);
    const double N = plane.pressure_N;
    if (N == 0.0) {
      EXPECT_TRUE(solution.wrench_on_object[f].isZero());
      continue;
    }
    constexpr double kRounding = 1e-8;  // of the pressure; torques over 6 mm
    EXPECT_WITHIN(plane.normal.dot(force) / N, 0.0, kRounding);
    EXPECT_WITHIN((torque - plane.normal.dot(torque) * plane.normal).norm() / N, 0.0,
                  0.006 * kRounding);
    const auto power = [&](const Vec3& v, const Vec3& w) { return force.dot(v) + torque.dot(w); };
    // What all points can give together: no slip takes more than the support function says.
    for (int k = 0; k < 20; ++k) {
      const Vec3 v = test::random_vector(random, 1.0);
      const Vec3 w = 100.0 * test::random_vector(random, 1.0);
      EXPECT_LE(power(v, w), most_power(face, plane, v, w) + kRounding * N);
    }
    // And of the slip that there is it takes all that.
    const Vec6& pad = solution.velocity[face.pad];
    const Vec6& object = solution.velocity[face.object];
    const Vec3 from_pad = plane.middle - face.points.front().p_object + face.points.front().p_pad;
    const Vec3 w = pad.tail<3>() - object.tail<3>();
    const Vec3 v =
        test::pads::velocity_at(pad, from_pad) - test::pads::velocity_at(object, plane.middle);
    const double taken = power(v, w);
    EXPECT_WITHIN(taken, most_power(face, plane, v, w),
                  kRounding * N * test::pads::largest(solution.velocity));
  }
}

TEST(PadPlanes, FrictionIsThatOfGreatestDissipationInAllScenes) {
  Random random(41, 1);
  for (const PadScene scene : test::every(kScenes))
    for (const int count : {12, 48, 200}) {
      SCOPED_TRACE(std::string(kPadSceneNames[static_cast<std::size_t>(scene)]) + " " +
                   std::to_string(count));
      const PadStep step = step_under_way(test::must(pad_grasp(scene, count)));
      expect_greatest_dissipation(step, solve(step, PadSolver::aggregate_exact), random);
    }
}

TEST(PadPlanes, FrictionIsThatOfGreatestDissipationInAnyGrasp) {
  Random random(42, 1);
  constexpr int kMostSweeps = 400;
  for (int k = 0; k < 600; ++k) {
    SCOPED_TRACE(k);
    const PadStep step = test::pads::any_step(random, k, 40);
    const PadSolution solution = solve(step, PadSolver::aggregate_exact);
    expect_greatest_dissipation(step, solution, random);
    EXPECT_LE(solution.sweeps, kMostSweeps);
    EXPECT_EQ(solution.constraints, 4 * step.faces.size());
  }
}

TEST(PadPlanes, GoOnFromTheStepBeforeToTheSameAnswer) {
  for (const PadScene scene : test::every(kScenes)) {
    const PadGrasp grasp = test::must(pad_grasp(scene, 48));
    HeldByPads held(grasp.object, grasp.pads, grasp.step_s, PadSolver::aggregate_exact,
                    grasp.proxies(0.0));
    for (int k = 1; k <= 200; ++k) {
      const double t_s = k * grasp.step_s;
      const PadStep step = held.next(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      if (k % 20 != 0) continue;
      const PadSolution alone = solve(step, PadSolver::aggregate_exact);
      constexpr double kSame_N = 1e-5;
      for (std::size_t pad = 0; pad < step.faces.size(); ++pad)
        EXPECT_WITHIN((held.wrenches()[pad].force - alone.wrench_on_object[pad].head<3>()).norm(),
                      0.0, kSame_N)
            << kPadSceneNames[static_cast<std::size_t>(scene)] << " " << k;
    }
    EXPECT_TRUE(held.settled());
  }
}

TEST(HeldByPads, AreHeldStepByStepWithoutAllocatingByAnySolver) {
  for (const PadSolver solver : test::every(
           std::array{PadSolver::pointwise, PadSolver::aggregate, PadSolver::aggregate_exact})) {
    const PadGrasp grasp = test::must(pad_grasp(PadScene::ball, 200));
    HeldByPads held(grasp.object, grasp.pads, grasp.step_s, solver, grasp.proxies(0.0));
    held.step(grasp.proxies(grasp.step_s), grasp.gravity_m_s2(grasp.step_s));
    const auto before = test::allocations();
    for (int k = 2; k <= 50; ++k)
      held.step(grasp.proxies(k * grasp.step_s), grasp.gravity_m_s2(k * grasp.step_s));
    EXPECT_EQ(test::allocations(), before) << kPadSolverNames[static_cast<std::size_t>(solver)];
  }
}

}  // namespace
}  // namespace isograsp::bimanual::pad_planes_test
