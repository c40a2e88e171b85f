// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares: x = offset + a sin(w t) + b cos(w t), w = 2 pi frequency:
//   amplitude = sqrt(a^2 + b^2),  phase = atan2(b, a),  gain = amplitude of actual / of target
#include "tasks/measures/sine.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace isograsp::tasks {

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

statistics::Computed gain(std::span<const double> t_s, std::span<const double> target,
                          std::span<const double> actual, double frequency_Hz) {
  constexpr double kRoundingSlack = 1e-6;
  const double step_s = t_s.size() < 2 ? 0.0 : t_s[1] - t_s[0];
  if (t_s.size() < 3 || (t_s.back() - t_s.front() + step_s) * frequency_Hz < 1.0 - kRoundingSlack)
    return "less than one whole cycle"_text;
  const auto of_target = fit_sine(t_s, target, frequency_Hz);
  const auto of_actual = fit_sine(t_s, actual, frequency_Hz);
  if (!of_target || !of_actual) return "too few samples for a sine"_text;
  constexpr double kNoSine = 1e-12;
  if (of_target->amplitude <= kNoSine * std::abs(of_target->offset))
    return "the target has no component at its frequency"_text;
  return of_actual->amplitude / of_target->amplitude;
}

namespace {

/// Smallest distance between two of 0 (the offset) and the frequencies.
double smallest_difference(std::span<const double> frequencies_Hz) {
  std::vector<double> sorted(frequencies_Hz.begin(), frequencies_Hz.end());
  sorted.push_back(0.0);
  std::sort(sorted.begin(), sorted.end());
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < sorted.size(); ++k)
    smallest = std::min(smallest, sorted[k + 1] - sorted[k]);
  return smallest;
}

/// Columns 1, sin(w_1 t), cos(w_1 t), sin(w_2 t), ...
Eigen::MatrixXd design(std::span<const double> t_s, std::span<const double> frequencies_Hz) {
  // On a regular grid each angle is the one before turned by a constant; a fresh start now and then
  // keeps the rounding of the turns near that of sin() itself.
  const std::size_t fresh = statistics::is_regular(t_s) ? 32 : 1;
  const auto n = static_cast<Eigen::Index>(t_s.size());
  const auto columns = 1 + 2 * static_cast<Eigen::Index>(frequencies_Hz.size());
  Eigen::MatrixXd matrix(n, columns);
  matrix.col(0).setOnes();
  Eigen::Index column = 1;
  for (const double frequency_Hz : frequencies_Hz) {
    const double omega = 2.0 * std::numbers::pi * frequency_Hz;
    const double step_rad = omega * (t_s[1] - t_s[0]);
    const double turn_sin = std::sin(step_rad);
    const double turn_cos = std::cos(step_rad);
    double sin = 0.0;
    double cos = 1.0;
    for (std::size_t k = 0; k < t_s.size(); ++k) {
      if (k % fresh == 0) {
        sin = std::sin(omega * t_s[k]);
        cos = std::cos(omega * t_s[k]);
      } else {
        const double turned = sin * turn_cos + cos * turn_sin;
        cos = cos * turn_cos - sin * turn_sin;
        sin = turned;
      }
      matrix(static_cast<Eigen::Index>(k), column) = sin;
      matrix(static_cast<Eigen::Index>(k), column + 1) = cos;
    }
    column += 2;
  }
  return matrix;
}

/// Solves for several signals with one design.
class JointSines {
 public:
  JointSines(std::span<const double> t_s, std::span<const double> frequencies_Hz)
      : sines_(frequencies_Hz.size()) {
    constexpr double kRoundingSlack = 1e-6;
    const double length_s =
        t_s.size() < 2 ? 0.0 : t_s.back() - t_s.front() + statistics::median_step(t_s);
    if (length_s * smallest_difference(frequencies_Hz) < 1.0 - kRoundingSlack) {
      reason_ = "less than one whole cycle of the smallest frequency or difference"_text;
      return;
    }
    design_ = design(t_s, frequencies_Hz);
    // Column by column: the order of the sums, and so the last bit, is the same on every machine.
    const Eigen::Index size = design_.cols();
    Eigen::MatrixXd normal(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        normal(i, j) = normal(j, i) = design_.col(i).dot(design_.col(j));
    constexpr double kLeastCondition = 1e-6;  // as of fit_sine()
    solver_.compute(normal);
    if (solver_.info() != Eigen::Success || solver_.rcond() < kLeastCondition)
      reason_ = "too few samples for these sines"_text;
  }

  [[nodiscard]] SinesFit fit(std::span<const double> x) const {
    SinesFit result;
    result.reason = reason_;
    if (!reason_.empty()) return result;
    const Eigen::Map<const Eigen::VectorXd> signal(x.data(), static_cast<Eigen::Index>(x.size()));
    Eigen::VectorXd right(design_.cols());
    for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = design_.col(i).dot(signal);
    const Eigen::VectorXd fitted = solver_.solve(right);
    result.offset = fitted[0];
    for (std::size_t i = 0; i < sines_; ++i) {
      const double a = fitted[static_cast<Eigen::Index>(2 * i + 1)];
      const double b = fitted[static_cast<Eigen::Index>(2 * i + 2)];
      result.sines.push_back({0.0, std::hypot(a, b), std::atan2(b, a)});
    }
    return result;
  }

 private:
  std::size_t sines_;
  Eigen::MatrixXd design_;
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  Text reason_;
};

double largest_of(std::span<const double> x) {
  double largest = 0.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Into (-pi, pi].
double wrapped(double angle_rad) {
  const double wrapped_rad = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return wrapped_rad <= -std::numbers::pi ? std::numbers::pi : wrapped_rad;
}

}  // namespace

SinesFit fit_sines(std::span<const double> t_s, std::span<const double> x,
                   std::span<const double> frequencies_Hz) {
  assert(t_s.size() == x.size());
  return JointSines(t_s, frequencies_Hz).fit(x);
}

std::vector<SineAnswer> sine_answers(std::span<const double> t_s, std::span<const double> target,
                                     std::span<const double> actual,
                                     std::span<const double> frequencies_Hz) {
  assert(t_s.size() == target.size() && t_s.size() == actual.size());
  const JointSines joint(t_s, frequencies_Hz);
  const SinesFit of_target = joint.fit(target);
  const SinesFit of_actual = joint.fit(actual);
  constexpr double kNoSine = 1e-12;  // of the signal: rounding
  const double least_target = kNoSine * largest_of(target);
  const double least_actual = kNoSine * largest_of(actual);
  std::vector<SineAnswer> answers;
  for (std::size_t i = 0; i < frequencies_Hz.size(); ++i) {
    const double frequency_Hz = frequencies_Hz[i];
    const auto none = [&](const Text& why) { answers.push_back({frequency_Hz, why, why, why}); };
    if (!of_target.reason.empty()) {
      none(of_target.reason);
      continue;
    }
    const SineFit& asked = of_target.sines[i];
    const SineFit& given = of_actual.sines[i];
    if (asked.amplitude <= least_target) {
      none("the target has no component at this frequency"_text);
      continue;
    }
    const double gain = given.amplitude / asked.amplitude;
    if (given.amplitude <= least_actual) {
      constexpr Words why = "nothing is answered at this frequency"_text;
      answers.push_back({frequency_Hz, gain, why, why});
      continue;
    }
    const double phase_rad = wrapped(given.phase_rad - asked.phase_rad);
    const double omega = 2.0 * std::numbers::pi * frequency_Hz;
    answers.push_back({frequency_Hz, gain, phase_rad, -phase_rad / omega});
  }
  return answers;
}

}  // namespace isograsp::tasks
