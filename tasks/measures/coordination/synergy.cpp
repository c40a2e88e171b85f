// SPDX-License-Identifier: GPL-3.0-or-later
// N trials of n elements, f a trial about the mean of all, u the jacobian at length 1:
//   v_ort = sum (f . u)^2 / (N - 1),  v_ucm = sum |f - (f . u) u|^2 / ((n - 1) (N - 1))
//   v_tot = sum |f|^2 / (n (N - 1)),  delta_v = (v_ucm - v_ort) / v_tot
//   delta_v_z = ln((n - 1) v_ucm / v_ort) / 2
#include "tasks/measures/coordination/synergy.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp::tasks {

std::optional<Synergy> synergy(const Eigen::MatrixXd& trials, const Eigen::VectorXd& jacobian,
                               Text& reason) {
  assert(jacobian.size() == trials.cols() && trials.cols() >= 2 && jacobian.norm() > 0.0);
  constexpr Eigen::Index kLeastTrials = 15;  // below, Delta V depends on the number of trials
  if (trials.rows() < kLeastTrials) {
    reason = "fewer than 15 trials"_text;
    return std::nullopt;
  }
  const double n = static_cast<double>(trials.cols());
  const double degrees = static_cast<double>(trials.rows() - 1);
  const Eigen::MatrixXd about_mean = trials.rowwise() - trials.colwise().mean();
  const double all = about_mean.squaredNorm() / degrees;
  // Rounding of a mean leaves about eps of it in each element.
  constexpr double kConstant = 1e-26;
  if (!(all > kConstant * trials.squaredNorm() / degrees)) {
    reason = "the forces do not vary"_text;
    return std::nullopt;
  }
  const Eigen::VectorXd across = about_mean * jacobian.normalized();
  Synergy found;
  found.v_ort = across.squaredNorm() / degrees;
  // Summed from its own part: in a difference of sums a small v_ucm would be lost by rounding.
  const Eigen::MatrixXd within = about_mean - across * jacobian.normalized().transpose();
  found.v_ucm = within.squaredNorm() / degrees / (n - 1.0);
  found.v_tot = all / n;
  found.delta_v = (found.v_ucm - found.v_ort) / found.v_tot;
  // n + Delta V and n / (n - 1) - Delta V are multiples of the two variances.
  found.delta_v_z = 0.5 * std::log((n - 1.0) * found.v_ucm / found.v_ort);
  return found;
}

namespace {

double at_time(std::span<const double> t_s, std::span<const double> x, double when_s) {
  const auto after = std::upper_bound(t_s.begin(), t_s.end(), when_s);
  if (after == t_s.begin()) return x.front();
  const auto k = static_cast<std::size_t>(after - t_s.begin());
  if (k == t_s.size()) return x.back();
  return std::lerp(x[k - 1], x[k], (when_s - t_s[k - 1]) / (t_s[k] - t_s[k - 1]));
}

}  // namespace

CycleSynergy synergy_over_cycles(std::span<const double> t_s,
                                 std::span<const std::vector<double>> force_N,
                                 std::span<const double> starts_s) {
  assert(!t_s.empty() && force_N.size() >= 2);
  constexpr int kPhases = 100;
  const std::size_t cycles = starts_s.empty() ? 0 : starts_s.size() - 1;
  const auto elements = static_cast<Eigen::Index>(force_N.size());
  const Eigen::VectorXd sum_of_all = Eigen::VectorXd::Ones(elements);
  Eigen::MatrixXd trials = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cycles), elements);
  Synergy sum;
  for (int phase = 0; phase < kPhases; ++phase) {
    for (std::size_t c = 0; c < cycles; ++c) {
      const double when_s =
          std::lerp(starts_s[c], starts_s[c + 1], static_cast<double>(phase) / kPhases);
      for (std::size_t e = 0; e < force_N.size(); ++e)
        trials(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(e)) =
            at_time(t_s, force_N[e], when_s);
    }
    Text reason;
    const auto found = synergy(trials, sum_of_all, reason);
    if (!found) return {reason, reason, reason, reason};
    sum.delta_v += found->delta_v;
    sum.delta_v_z += found->delta_v_z;
    sum.v_ucm += found->v_ucm;
    sum.v_ort += found->v_ort;
  }
  return {sum.delta_v / kPhases, sum.delta_v_z / kPhases, sum.v_ucm / kPhases, sum.v_ort / kPhases};
}

}  // namespace isograsp::tasks
