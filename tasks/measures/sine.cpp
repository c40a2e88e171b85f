// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/sine.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace isograsp {

std::optional<SineFit> fit_sine(std::span<const double> t_s, std::span<const double> x,
                                double frequency_Hz) {
  assert(t_s.size() == x.size());
  const double omega = 2.0 * std::numbers::pi * frequency_Hz;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Eigen::Vector3d row(1.0, std::sin(omega * t_s[k]), std::cos(omega * t_s[k]));
    normal += row * row.transpose();
    right += row * x[k];
  }
  constexpr double kLeastCondition = 1e-6;  // below: a short piece of a cycle is all there is
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success || solver.rcond() < kLeastCondition) return std::nullopt;
  const Eigen::Vector3d fitted = solver.solve(right);
  return SineFit{fitted[0], std::hypot(fitted[1], fitted[2]), std::atan2(fitted[2], fitted[1])};
}

Computed gain(std::span<const double> t_s, std::span<const double> target,
              std::span<const double> actual, double frequency_Hz) {
  constexpr double kRoundingSlack = 1e-6;
  const double step_s = t_s.size() < 2 ? 0.0 : t_s[1] - t_s[0];
  if (t_s.size() < 3 || (t_s.back() - t_s.front() + step_s) * frequency_Hz < 1.0 - kRoundingSlack)
    return "less than one whole cycle";
  const auto of_target = fit_sine(t_s, target, frequency_Hz);
  const auto of_actual = fit_sine(t_s, actual, frequency_Hz);
  if (!of_target || !of_actual) return "too few samples for a sine";
  constexpr double kNoSine = 1e-12;
  if (of_target->amplitude <= kNoSine * std::abs(of_target->offset))
    return "the target has no component at its frequency";
  return of_actual->amplitude / of_target->amplitude;
}

}  // namespace isograsp
