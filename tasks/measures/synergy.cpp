// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/synergy.hpp"

#include <cassert>
#include <cmath>

namespace isograsp {

std::optional<Synergy> synergy(const Eigen::MatrixXd& trials, const Eigen::VectorXd& jacobian,
                               std::string& reason) {
  assert(jacobian.size() == trials.cols() && trials.cols() >= 2 && jacobian.norm() > 0.0);
  constexpr Eigen::Index kLeastTrials = 15;  // below, Delta V depends on the number of trials
  if (trials.rows() < kLeastTrials) {
    reason = "fewer than 15 trials";
    return std::nullopt;
  }
  const double n = static_cast<double>(trials.cols());
  const double degrees = static_cast<double>(trials.rows() - 1);
  const Eigen::MatrixXd about_mean = trials.rowwise() - trials.colwise().mean();
  const double all = about_mean.squaredNorm() / degrees;
  // Rounding of a mean leaves about eps of it in each element.
  constexpr double kConstant = 1e-26;
  if (!(all > kConstant * trials.squaredNorm() / degrees)) {
    reason = "the forces do not vary";
    return std::nullopt;
  }
  const Eigen::VectorXd across = about_mean * jacobian.normalized();
  Synergy found;
  found.v_ort = across.squaredNorm() / degrees;
  // Summed from its own part: a difference of sums would lose a small v_ucm.
  const Eigen::MatrixXd within = about_mean - across * jacobian.normalized().transpose();
  found.v_ucm = within.squaredNorm() / degrees / (n - 1.0);
  found.v_tot = all / n;
  found.delta_v = (found.v_ucm - found.v_ort) / found.v_tot;
  // n + Delta V and n / (n - 1) - Delta V are multiples of the two variances.
  found.delta_v_z = 0.5 * std::log((n - 1.0) * found.v_ucm / found.v_ort);
  return found;
}

}  // namespace isograsp
