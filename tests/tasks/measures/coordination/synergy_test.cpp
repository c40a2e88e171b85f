// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/synergy.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::synergy_test {
namespace {

constexpr double kRounding = 1e-12;

/// Trials that vary by `along` in the direction of the result and by `within` across it.
Eigen::MatrixXd trials_of(double along, double within, const Eigen::Vector3d& jacobian) {
  Random random(6);
  const Eigen::Vector3d j = jacobian.normalized();
  const Eigen::Vector3d u = j.unitOrthogonal();
  const Eigen::Vector3d v = j.cross(u);
  Eigen::MatrixXd trials(20, 3);
  for (int k = 0; k < trials.rows(); ++k) {
    const Eigen::Vector3d force = Eigen::Vector3d(8.0, 5.0, 3.0) + along * random.gaussian() * j +
                                  within * (random.gaussian() * u + random.gaussian() * v);
    trials.row(k) = force.transpose();
  }
  return trials;
}
Synergy of(const Eigen::MatrixXd& trials, const Eigen::VectorXd& jacobian) {
  Text reason;
  const auto found = synergy(trials, jacobian, reason);
  EXPECT_TRUE(found) << english(reason);
  return found.value_or(Synergy{});
}

TEST(Synergy, ThreeDigitsReachFromMinusThreeToOneAndAHalf) {
  for (const Eigen::Vector3d& jacobian :
       {Eigen::Vector3d(1.0, 1.0, 1.0), Eigen::Vector3d(0.03, -0.02, 0.05)}) {
    EXPECT_WITHIN(of(trials_of(1.0, 0.0, jacobian), jacobian).delta_v, -3.0, kRounding);
    EXPECT_WITHIN(of(trials_of(0.0, 1.0, jacobian), jacobian).delta_v, 1.5, kRounding);
  }
}

TEST(Synergy, TheTransformIsThatOfTheRange) {
  const Eigen::Vector3d sum = Eigen::Vector3d::Ones();
  for (const double within : {0.2, 1.0, 3.0}) {
    const Synergy found = of(trials_of(1.0, within, sum), sum);
    EXPECT_WITHIN(found.delta_v_z, 0.5 * std::log((3.0 + found.delta_v) / (1.5 - found.delta_v)),
                  kRounding);
  }
}

TEST(Synergy, VariancesAddUpAndOfTheResultIsThatOfTheSum) {
  const Eigen::Vector3d sum = Eigen::Vector3d::Ones();
  const Eigen::MatrixXd trials = trials_of(1.0, 2.0, sum);
  const Synergy found = of(trials, sum);
  EXPECT_WITHIN(2.0 * found.v_ucm + found.v_ort, 3.0 * found.v_tot, kRounding);
  const Eigen::VectorXd total = trials.rowwise().sum();
  const double variance = (total.array() - total.mean()).square().sum() / 19.0;
  EXPECT_WITHIN(found.v_ort, variance / 3.0, kRounding);
}

TEST(Synergy, FourFingersByHand) {
  // Deviations (1, -1, 0, 0) and (0, 0, 1, 1), each in both signs and four times: 16 trials.
  Eigen::MatrixXd trials(16, 4);
  for (int k = 0; k < 16; k += 4) {
    trials.row(k) << 1, -1, 0, 0;
    trials.row(k + 1) << -1, 1, 0, 0;
    trials.row(k + 2) << 0, 0, 1, 1;
    trials.row(k + 3) << 0, 0, -1, -1;
  }
  // Along (1, 1, 1, 1) / 2: +-1 in half of the trials, 8; all squares are 32; the rest is 24.
  const Synergy found = of(trials, Eigen::Vector4d::Ones());
  EXPECT_WITHIN(found.v_ort, 8.0 / 15.0, kRounding);
  EXPECT_WITHIN(found.v_ucm, 24.0 / 15.0 / 3.0, kRounding);
  EXPECT_WITHIN(found.delta_v, 0.0, kRounding);
}

TEST(Synergy, NeitherTheMeanNorTheUnitNorTheScaleOfTheJacobianMatters) {
  const Eigen::Vector3d jacobian(1.0, 0.5, 2.0);
  const Eigen::MatrixXd trials = trials_of(1.0, 2.0, jacobian);
  const Eigen::MatrixXd moved = (1000.0 * trials).rowwise() + Eigen::RowVector3d(40.0, 0.0, -7.0);
  EXPECT_WITHIN(of(moved, -5.0 * jacobian).delta_v, of(trials, jacobian).delta_v, 1e-9);
}

TEST(Synergy, FewTrialsOrConstantForcesHaveAReason) {
  Text reason;
  const Eigen::Vector3d sum = Eigen::Vector3d::Ones();
  EXPECT_FALSE(synergy(trials_of(1.0, 1.0, sum).topRows(14), sum, reason));
  EXPECT_EQ(english(reason), "fewer than 15 trials");
  EXPECT_TRUE(synergy(trials_of(1.0, 1.0, sum).topRows(15), sum, reason));
  EXPECT_FALSE(synergy(Eigen::MatrixXd::Constant(20, 3, 0.1), sum, reason));
  EXPECT_EQ(english(reason), "the forces do not vary");
}

}  // namespace
}  // namespace isograsp::tasks::synergy_test
