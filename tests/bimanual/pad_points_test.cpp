// SPDX-License-Identifier: GPL-3.0-or-later
// Soft pads point by point, by Newton: the answer is that of the problem (impulses, pressure,
// Coulomb), and that of a plain Gauss-Seidel that knows nothing of Newton.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "bimanual/pads/friction_block.hpp"
#include "bimanual/pads/pad_scenes.hpp"
#include "bimanual/pads/pad_step.hpp"
#include "core/random.hpp"
#include "tests/bimanual/any_step.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"

namespace isograsp::bimanual::pad_points_test {
namespace {

constexpr std::array kScenes{PadScene::ball, PadScene::dumbbell, PadScene::pencil, PadScene::edge};
constexpr std::array kCounts{12, 24, 48, 96, 176, 200};
/// Of the largest velocity: what a solution may leave (pad_step.hpp).
constexpr double kLeft = 1e-10;

using test::pads::any_step;
using test::pads::largest;
using test::pads::slip_at;

/// By how much a solution misses the problem: impulses of the bodies [m/s], [rad/s] that they would
/// move by; pressure of the bed [N]; Coulomb's law [m/s].
struct Missed {
  double impulse = 0.0, pressure = 0.0, coulomb = 0.0;
};
Missed missed_by(const PadStep& step, const PadSolution& solution) {
  Missed missed;
  std::vector<Vec6> impulse;
  for (std::size_t b = 0; b < step.inertia.size(); ++b)
    impulse.emplace_back(step.inertia[b] * (solution.velocity[b] - step.velocity_free[b]));
  for (std::size_t f = 0; f < step.faces.size(); ++f) {
    const PadFace& face = step.faces[f];
    for (std::size_t i = 0; i < face.points.size(); ++i) {
      const PadPoint& point = face.points[i];
      const double normal_N = solution.memory[f].normal_N[i];
      const Vec3& friction_N = solution.memory[f].friction_W_N[i];
      const Vec3 slip = slip_at(face, point, solution.velocity);
      const double depth_m =
          point.penetration_free_m +
          step.step_s * point.normal.dot(slip - slip_at(face, point, step.velocity_free));
      const double pressed_N = face.stiffness_N_m3 * point.area_m2 * std::max(0.0, depth_m);
      missed.pressure = std::max(missed.pressure, std::abs(normal_N - pressed_N));
      const Vec3 across = slip - point.normal.dot(slip) * point.normal;
      const double limit_N = face.friction * normal_N;
      // In units of velocity: f is the nearest of its disk to f + firm times the slip.
      const double firm = 1.0 + 1e3 * limit_N;
      Vec3 asked_N = friction_N + firm * across;
      if (asked_N.norm() > limit_N) asked_N *= limit_N / asked_N.norm();
      missed.coulomb = std::max(missed.coulomb, (asked_N - friction_N).norm() / firm);
      const Vec3 force = step.step_s * (normal_N * point.normal + friction_N);
      impulse[face.object].head<3>() -= force;
      impulse[face.object].tail<3>() -= point.p_object.cross(force);
      impulse[face.pad].head<3>() += force;
      impulse[face.pad].tail<3>() += point.p_pad.cross(force);
    }
  }
  for (std::size_t b = 0; b < impulse.size(); ++b)
    missed.impulse =
        std::max(missed.impulse, (step.inertia[b].inverse() * impulse[b]).cwiseAbs().maxCoeff());
  return missed;
}
void expect_solved(const PadStep& step, const PadSolution& solution) {
  EXPECT_TRUE(solution.settled);
  const Missed missed = missed_by(step, solution);
  constexpr double kPressure_N = 1e-9;
  constexpr double kCreep_m_s = 2e-9;
  constexpr double kOnceMore = 2.0;  // the test puts velocities together in another way
  const double left = kOnceMore * kLeft * largest(solution.velocity);
  EXPECT_WITHIN(missed.impulse, 0.0, left);
  EXPECT_WITHIN(missed.pressure, 0.0, kPressure_N);
  EXPECT_WITHIN(missed.coulomb, 0.0, std::max(left, kOnceMore * kCreep_m_s));
}

TEST(PadPoints, SolveTheProblemInAnyGrasp) {
  Random random(31, 1);
  constexpr int kMostSweeps = 200;  // 10,000 others needed 7 in the middle, 121 at most
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(k);
    const PadStep step = any_step(random, k, 40);
    const PadSolution solution = solve(step, PadSolver::pointwise);
    expect_solved(step, solution);
    EXPECT_LE(solution.sweeps, kMostSweeps);
  }
}

TEST(PadPoints, SolveAllScenesFromFewToManyPoints) {
  for (const PadScene scene : test::every(kScenes))
    for (const int count : test::every(kCounts)) {
      SCOPED_TRACE(std::string(kPadSceneNames[static_cast<std::size_t>(scene)]) + " " +
                   std::to_string(count));
      const PadStep step = step_under_way(test::must(pad_grasp(scene, count)));
      const PadSolution solution = solve(step, PadSolver::pointwise);
      expect_solved(step, solution);
      constexpr int kMostSweeps = 150;
      EXPECT_LE(solution.sweeps, kMostSweeps);
    }
}

/// Velocities by sweeps over the points, each solved exactly with all others held still; nothing in
/// common with Newton but the problem.
std::vector<Vec6> by_gauss_seidel(const PadStep& step) {
  constexpr int kMost = 200'000;
  constexpr double kStands = 1e-13;
  std::vector<Vec6> v = step.velocity_free;
  std::vector<Mat6> inverse;
  for (const Mat6& inertia : step.inertia) inverse.emplace_back(inertia.inverse());
  struct Block {
    const PadFace* face;
    const PadPoint* point;
    Eigen::Matrix<double, 3, 6> object, pad;
    Mat3 W;                     // slip for a unit of force
    Vec3 force = Vec3::Zero();  // normal, and two across
    double at_rest_m = 0.0;
  };
  std::vector<Block> blocks;
  for (const PadFace& face : step.faces)
    for (const PadPoint& point : face.points) {
      Block block{&face, &point, {}, {}, {}};
      Mat3 axes;
      axes << point.normal, point.normal.unitOrthogonal(),
          point.normal.cross(point.normal.unitOrthogonal());
      block.object << axes.transpose(), -axes.transpose() * skew(point.p_object);
      block.pad << axes.transpose(), -axes.transpose() * skew(point.p_pad);
      block.W = step.step_s * (block.object * inverse[face.object] * block.object.transpose() +
                               block.pad * inverse[face.pad] * block.pad.transpose());
      block.at_rest_m = point.penetration_free_m -
                        step.step_s * point.normal.dot(slip_at(face, point, step.velocity_free));
      blocks.push_back(block);
    }
  for (int sweep = 0; sweep < kMost; ++sweep) {
    const std::vector<Vec6> before = v;
    for (Block& block : blocks) {
      const auto slip = [&] {
        return Vec3(block.pad * v[block.face->pad] - block.object * v[block.face->object]);
      };
      const auto push = [&](const Vec3& force) {
        const Vec3 more = step.step_s * (force - block.force);
        v[block.face->object] += inverse[block.face->object] * block.object.transpose() * more;
        v[block.face->pad] -= inverse[block.face->pad] * block.pad.transpose() * more;
        block.force = force;
      };
      const double k = block.face->stiffness_N_m3 * block.point->area_m2;
      Vec3 next = block.force;
      const double depth_m = block.at_rest_m + step.step_s * slip().x();
      next.x() = std::max(
          0.0, next.x() + (k * depth_m - next.x()) / (1.0 + k * step.step_s * block.W(0, 0)));
      push(next);
      // A third row that nothing moves: the ellipsoid is the disk.
      Mat3 W = Mat3::Identity();
      W.topLeftCorner<2, 2>() = block.W.bottomRightCorner<2, 2>();
      Vec3 free = Vec3::Zero();
      free.head<2>() = slip().tail<2>() + W.topLeftCorner<2, 2>() * block.force.tail<2>();
      next.tail<2>() =
          friction_in_ellipsoid(W, free, Vec3::Constant(block.face->friction * next.x())).head<2>();
      push(next);
    }
    double change = 0.0;
    for (std::size_t b = 0; b < v.size(); ++b)
      change = std::max(change, (v[b] - before[b]).cwiseAbs().maxCoeff());
    if (change <= kStands * largest(v)) return v;
  }
  ADD_FAILURE() << "has not come to rest";
  return v;
}

TEST(PadPoints, AreThoseOfGaussSeidelWhereItIsFewPointsAndManySweeps) {
  Random random(32, 1);
  constexpr double kSame = 1e-6;  // Gauss-Seidel stops a little before its end
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    const PadStep step = any_step(random, k, 6);
    const PadSolution solution = solve(step, PadSolver::pointwise);
    const std::vector<Vec6> other = by_gauss_seidel(step);
    for (std::size_t b = 0; b < other.size(); ++b)
      EXPECT_WITHIN((solution.velocity[b] - other[b]).norm() / largest(other), 0.0, kSame);
  }
}

TEST(PadPoints, DoNotKnowWhereTheWorldIs) {
  Random random(33, 1);
  // Both solutions leave kLeft; what sticks magnifies that little.
  constexpr double kSame = 1e-7;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const PadStep step = any_step(random, k, 20);
    const Mat3 R = test::random_attitude(random).toRotationMatrix();
    Mat6 turn = Mat6::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R;
    PadStep turned = step;
    for (Mat6& inertia : turned.inertia) inertia = turn * inertia * turn.transpose();
    for (Vec6& v : turned.velocity_free) v = turn * v;
    for (PadFace& face : turned.faces)
      for (PadPoint& point : face.points) {
        point.p_object = R * point.p_object;
        point.p_pad = R * point.p_pad;
        point.normal = R * point.normal;
      }
    const PadSolution here = solve(step, PadSolver::pointwise);
    const PadSolution there = solve(turned, PadSolver::pointwise);
    for (std::size_t b = 0; b < here.velocity.size(); ++b)
      EXPECT_WITHIN((turn * here.velocity[b] - there.velocity[b]).norm() / largest(here.velocity),
                    0.0, kSame);
  }
}

TEST(PadPoints, RubbingTakesEnergyAndGivesNone) {
  Random random(34, 1);
  for (int k = 0; k < 300; ++k) {
    const PadStep step = any_step(random, k, 20);
    const PadSolution solution = solve(step, PadSolver::pointwise);
    double power_W = 0.0, force_N = 0.0;
    for (std::size_t f = 0; f < step.faces.size(); ++f)
      for (std::size_t i = 0; i < step.faces[f].points.size(); ++i) {
        const Vec3& friction_N = solution.memory[f].friction_W_N[i];
        power_W +=
            friction_N.dot(slip_at(step.faces[f], step.faces[f].points[i], solution.velocity));
        force_N += friction_N.norm();
      }
    EXPECT_GE(power_W, -kLeft * largest(solution.velocity) * force_N) << k;
  }
}

/// A block between two pads of n points each, that is pulled down.
PadStep squeezed(int n, double left_friction, double right_friction, double pull_m_s) {
  PadStep step;
  step.inertia.assign(3, Mat6::Identity());
  step.inertia[0].diagonal() << 0.3, 0.3, 0.3, 2.5e-4, 2.5e-4, 2.5e-4;
  step.velocity_free.assign(3, Vec6::Zero());
  step.velocity_free[0][1] = -pull_m_s;
  for (const double side : {-1.0, 1.0}) {
    PadFace& face = step.faces.emplace_back();
    face.pad = side < 0 ? 1 : 2;
    step.inertia[face.pad].diagonal() << Vec3::Constant(0.006), Vec3::Constant(9e-7);
    face.friction = side < 0 ? left_friction : right_friction;
    face.stiffness_N_m3 = 4e7;
    for (int i = 0; i < n; ++i) {
      const double r_m = 0.006 * std::sqrt((i + 0.5) / n), angle_rad = 2.4 * i;
      const Vec3 across(0.0, r_m * std::sin(angle_rad), r_m * std::cos(angle_rad));
      face.points.push_back(
          {Vec3(0.0325 * side, 0, 0) + across, across, -side * Vec3::UnitX(), 1e-4 / n, 1e-3});
    }
  }
  return step;
}

TEST(PadPoints, TwoHundredThatStickDoNotCreepAndAreSolvedInAFewSweeps) {
  const PadStep step = squeezed(100, 0.8, 0.8, 0.00981);
  const PadSolution solution = solve(step, PadSolver::pointwise);
  expect_solved(step, solution);
  constexpr double kCreep_m_s = 1e-14;  // rounding of velocities of 0.01 m/s
  for (const PadFace& face : test::every(step.faces))
    for (const PadPoint& point : face.points)
      EXPECT_WITHIN(slip_at(face, point, solution.velocity).tail<2>().norm(), 0.0, kCreep_m_s);
  constexpr int kFewSweeps = 20;
  EXPECT_LE(solution.sweeps, kFewSweeps);
}

TEST(PadPoints, OnePadSlidesWithAllItsFrictionWhileTheOtherSticks) {
  const PadStep step = squeezed(50, 0.01, 0.8, 0.3);
  const PadSolution solution = solve(step, PadSolver::pointwise);
  expect_solved(step, solution);
  const auto utilisation = [&](std::size_t f, std::size_t i) {
    return solution.memory[f].friction_W_N[i].norm() /
           (step.faces[f].friction * solution.memory[f].normal_N[i]);
  };
  for (std::size_t i = 0; i < step.faces[0].points.size(); ++i) {
    EXPECT_WITHIN(utilisation(0, i), 1.0, 1e-9);
    EXPECT_LT(utilisation(1, i), 1.0 - 1e-3);
  }
}

TEST(PadPoints, GoOnFromTheStepBeforeToTheSameAnswerInLessSweeps) {
  for (const PadScene scene : test::every(kScenes)) {
    const PadGrasp grasp = test::must(pad_grasp(scene, 96));
    HeldByPads held(grasp.object, grasp.pads, grasp.step_s, PadSolver::pointwise,
                    grasp.proxies(0.0));
    long warm = 0, cold = 0;
    for (int k = 1; k <= 200; ++k) {
      const double t_s = k * grasp.step_s;
      const PadStep step = held.next(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      held.step(grasp.proxies(t_s), grasp.gravity_m_s2(t_s));
      if (k % 10 != 0) continue;
      const PadSolution alone = solve(step, PadSolver::pointwise);
      warm += held.sweeps();
      cold += alone.sweeps;
      constexpr double kSame_N = 1e-5;
      for (std::size_t pad = 0; pad < step.faces.size(); ++pad)
        EXPECT_WITHIN((held.wrenches()[pad].force - alone.wrench_on_object[pad].head<3>()).norm(),
                      0.0, kSame_N)
            << k;
    }
    EXPECT_TRUE(held.settled());
    EXPECT_LT(warm, cold) << kPadSceneNames[static_cast<std::size_t>(scene)];
  }
}

}  // namespace
}  // namespace isograsp::bimanual::pad_points_test
