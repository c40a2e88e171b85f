// SPDX-License-Identifier: GPL-3.0-or-later
// Uncontrolled manifold: do the digits correct each other, so that what they produce together
// varies less than they do?
#pragma once

#include <Eigen/Core>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Variance of repeated trials per degree of freedom, unit of force^2, and the index from it.
struct Synergy {
  double v_ucm = 0.0;      ///< within the manifold that leaves the result alone, / (n - 1)
  double v_ort = 0.0;      ///< across it, / 1
  double v_tot = 0.0;      ///< of all, / n
  double delta_v = 0.0;    ///< (v_ucm - v_ort) / v_tot
  double delta_v_z = 0.0;  ///< its Fisher transform, for statistics
};

/// Synergy index of n elements and one result J f, version 1 (Scholz & Schöner 1999; Latash et al.
/// 2002). Delta V is divided by v_tot, not by v_ort: it lies in [-n, n / (n - 1)], for three digits
/// [-3, 1.5]; positive: a synergy. z = ln((n + Delta V) / (n / (n - 1) - Delta V)) / 2, infinite at
/// the ends of the range. Variance with T - 1 of T trials.
/// @param trials    one row per trial or cycle, one column per element: forces at the same phase
/// @param jacobian  effect of each element on the result; all ones: the sum of forces
/// @param reason    says why if there is no value: fewer than 15 trials, nothing varies
/// @pre jacobian is not zero, jacobian.size() == trials.cols() >= 2
[[nodiscard]] std::optional<Synergy> synergy(const Eigen::MatrixXd& trials,
                                             const Eigen::VectorXd& jacobian, Text& reason);

/// The same at 100 phases of a movement that repeats, over its cycles, version 1: means over the
/// phases. The elements act alike: their sum is the result.
struct CycleSynergy {
  statistics::Computed delta_v;
  statistics::Computed delta_v_z;  ///< mean of the transforms
  statistics::Computed v_ucm;      ///< unit of force^2
  statistics::Computed v_ort;      ///< unit of force^2
};
/// Forces between samples are interpolated linearly.
/// @param force_N   one signal per element, at t_s
/// @param starts_s  where cycles begin, and where the last one ends: one more than there are cycles
/// @pre at least two elements of the length of t_s, not empty; t_s and starts_s increase
[[nodiscard]] CycleSynergy synergy_over_cycles(std::span<const double> t_s,
                                               std::span<const std::vector<double>> force_N,
                                               std::span<const double> starts_s);

}  // namespace isograsp::tasks
