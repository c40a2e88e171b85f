// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/two_hands.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/QR>

namespace isograsp::tasks {

namespace {

constexpr Words kNeitherPresses = "neither hand presses"_text;

/// Moves the values to mean 0 and largest size 1; a constant becomes 0.
Eigen::VectorXd scaled(const Eigen::VectorXd& x) {
  const Eigen::VectorXd centred = x.array() - x.mean();
  const double most = centred.cwiseAbs().maxCoeff();
  // The rounding of a mean is all that is left of a constant.
  constexpr double kConstant = 1e-13;
  if (most <= kConstant * x.cwiseAbs().maxCoeff()) return Eigen::VectorXd::Zero(x.size());
  return centred / most;
}

/// Central differences, one-sided at the ends.
Eigen::VectorXd slopes(const Eigen::VectorXd& x, double step_s) {
  const Eigen::Index n = x.size();
  Eigen::VectorXd slope(n);
  slope[0] = (x[1] - x[0]) / step_s;
  slope[n - 1] = (x[n - 1] - x[n - 2]) / step_s;
  if (n > 2) slope.segment(1, n - 2) = (x.tail(n - 2) - x.head(n - 2)) / (2.0 * step_s);
  return slope;
}

Eigen::Map<const Eigen::VectorXd> as_vector(const statistics::UniformSamples& samples) {
  return {samples.values.data(), static_cast<Eigen::Index>(samples.values.size())};
}

double mean_square(const Eigen::VectorXd& x) {
  return x.squaredNorm() / static_cast<double>(x.size());
}

}  // namespace

HandShare hand_share(double affected_N, double other_N) {
  const double affected = std::max(0.0, affected_N);
  const double other = std::max(0.0, other_N);
  if (!(affected + other > 0.0)) return {kNeitherPresses, kNeitherPresses};
  return {100.0 * affected / (affected + other), 100.0 * (other - affected) / (affected + other)};
}

statistics::Computed effort_share(double affected_N, double other_N, double maximum_affected_N,
                                  double maximum_other_N) {
  return hand_share(affected_N / maximum_affected_N, other_N / maximum_other_N).affected_percent;
}

statistics::Computed hand_synergy(const statistics::UniformSamples& left_N,
                                  const statistics::UniformSamples& right_N,
                                  const statistics::UniformSamples* target_N) {
  const auto n = static_cast<Eigen::Index>(left_N.values.size());
  assert(n == static_cast<Eigen::Index>(right_N.values.size()));
  const Eigen::Index known = target_N == nullptr ? 2 : 4;
  if (n <= known) return "too few samples"_text;
  Eigen::MatrixXd common(n, known);
  common.col(0).setOnes();
  common.col(1) = Eigen::VectorXd::LinSpaced(n, -1.0, 1.0);
  if (target_N != nullptr) {
    const Eigen::VectorXd target = as_vector(*target_N);
    common.col(2) = scaled(target);
    common.col(3) = scaled(slopes(target, target_N->step_s));
  }
  Eigen::MatrixXd forces(n, 2);
  forces << as_vector(left_N), as_vector(right_N);
  // A target that is constant, or a line, adds nothing: what depends on the others is left out.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(common);
  const Eigen::MatrixXd rest = forces - common * fit.solve(forces);
  const double apart = 0.5 * mean_square(rest.col(0) - rest.col(1));
  const double together = 0.5 * mean_square(rest.col(0) + rest.col(1));
  // Below, what is left is the rounding of what was stored.
  constexpr double kNothing = 1e-10;
  const double most = forces.cwiseAbs().maxCoeff();
  if (!(apart + together > kNothing * most * most))
    return "the hands do not vary beside the target"_text;
  return 2.0 * (apart - together) / (apart + together);
}

statistics::Computed cancelled_share(std::span<const Vec3> left_N, std::span<const Vec3> right_N,
                                     std::span<const double> weight) {
  // Hands that grip and do not push: what is left is the noise of six sensors.
  constexpr double kLeastPush_N = 0.5;
  double together = 0.0;
  double each = 0.0;
  double whole = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    together += weight[k] * (left_N[k] + right_N[k]).norm();
    each += weight[k] * (left_N[k].norm() + right_N[k].norm());
    whole += weight[k];
  }
  if (!(each > kLeastPush_N * whole)) return "the hands do not push"_text;
  return 100.0 * (1.0 - together / each);
}

}  // namespace isograsp::tasks
