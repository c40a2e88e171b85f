// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares of a rigid motion (Kabsch 1976): minimise sum |R q_k + p - x_k|^2 with det R = +1.
// With the means taken off both sides the attitude is the unit quaternion that maximises r^T N r
// (Horn 1987):
//   H = sum q_k x_k^T,   d = (H23 - H32, H31 - H13, H12 - H21)
//   N = [ tr H   d^T                      ]
//       [ d      H + H^T - (tr H) I       ]
// and p = mean x - R mean q. A mirrored body is never fitted: N knows rotations alone.
// On a line: of the spreads s1 >= s2 >= s3 of the template points that are seen (singular values),
// s2 < 0.05 s1; the squares s^2 are the eigenvalues of sum q q^T.
// Four markers or fewer that do not fit: nothing is left out, since three left would fit nearly
// always.
#include "kinematics/rigid_body.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

namespace isograsp {

namespace {

constexpr double kLeastSpread = 0.05;  // s2 / s1
constexpr int kFewestToReject = 5;

/// Indices of the markers in a fit.
struct Chosen {
  std::array<std::uint8_t, RigidBody::kMostMarkers> index{};
  int count = 0;

  [[nodiscard]] Chosen without(int left_out) const noexcept {
    Chosen rest;
    for (int i = 0; i < count; ++i)
      if (i != left_out) rest.index[static_cast<std::size_t>(rest.count++)] = at(i);
    return rest;
  }
  [[nodiscard]] std::uint8_t at(int i) const noexcept { return index[static_cast<std::size_t>(i)]; }
};

Vec3 mean_of(std::span<const Vec3> points, const Chosen& chosen) noexcept {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < chosen.count; ++i) sum += points[chosen.at(i)];
  return sum / chosen.count;
}

bool on_a_line(std::span<const Vec3> points, const Chosen& chosen) noexcept {
  const Vec3 mean = mean_of(points, chosen);
  Mat3 spread = Mat3::Zero();
  for (int i = 0; i < chosen.count; ++i) {
    const Vec3 q = points[chosen.at(i)] - mean;
    spread.noalias() += q * q.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(spread, Eigen::EigenvaluesOnly);
  const Vec3 squares = solver.eigenvalues();  // the smallest first
  return !(squares[1] >= kLeastSpread * kLeastSpread * squares[2]) || !(squares[2] > 0.0);
}

struct Fitted {
  Pose X_WB;
  double rms_m = 0.0;
};

Fitted fit_chosen(std::span<const Vec3> template_m, std::span<const Vec3> p_W,
                  const Chosen& chosen) noexcept {
  const Vec3 mean_q = mean_of(template_m, chosen);
  const Vec3 mean_x = mean_of(p_W, chosen);
  Mat3 h = Mat3::Zero();
  for (int i = 0; i < chosen.count; ++i)
    h.noalias() += (template_m[chosen.at(i)] - mean_q) * (p_W[chosen.at(i)] - mean_x).transpose();
  Mat4 n;
  const double trace = h.trace();
  n(0, 0) = trace;
  n.block<3, 1>(1, 0) = Vec3(h(1, 2) - h(2, 1), h(2, 0) - h(0, 2), h(0, 1) - h(1, 0));
  n.block<1, 3>(0, 1) = n.block<3, 1>(1, 0).transpose();
  n.block<3, 3>(1, 1) = h + h.transpose() - trace * Mat3::Identity();
  const Vec4 v = largest_eigenvector(n);
  Fitted fitted;
  fitted.X_WB.q = canonical(Quat(v[0], v[1], v[2], v[3]));
  const Mat3 R = fitted.X_WB.q.toRotationMatrix();
  fitted.X_WB.p = mean_x - R * mean_q;
  double squares = 0.0;
  for (int i = 0; i < chosen.count; ++i)
    squares +=
        (R * (template_m[chosen.at(i)] - mean_q) - (p_W[chosen.at(i)] - mean_x)).squaredNorm();
  fitted.rms_m = std::sqrt(squares / chosen.count);
  return fitted;
}

}  // namespace

RigidBody::RigidBody(std::vector<Vec3> template_m, double max_residual_m)
    : template_m_(std::move(template_m)), max_residual_m_(max_residual_m) {
  assert(template_m_.size() <= kMostMarkers);
  Chosen all;
  for (std::size_t k = 0; k < template_m_.size(); ++k)
    all.index[static_cast<std::size_t>(all.count++)] = static_cast<std::uint8_t>(k);
  all_on_a_line_ = on_a_line(template_m_, all);
}

BodyFit RigidBody::fit(std::span<const Vec3> p_W) const noexcept {
  assert(p_W.size() == template_m_.size());
  Chosen seen;
  for (std::size_t k = 0; k < p_W.size(); ++k)
    if (!is_missing(p_W[k]))
      seen.index[static_cast<std::size_t>(seen.count++)] = static_cast<std::uint8_t>(k);
  BodyFit result;
  result.used = seen.count;
  if (seen.count < 3) return result;
  result.state = FrameState::collinear;
  const bool whole = static_cast<std::size_t>(seen.count) == template_m_.size();
  if (whole ? all_on_a_line_ : on_a_line(template_m_, seen)) return result;
  const Fitted all = fit_chosen(template_m_, p_W, seen);
  result.residual_m = all.rms_m;
  result.state = FrameState::residual;
  if (all.rms_m <= max_residual_m_) {
    result.state = FrameState::ok;
    result.X_WB = all.X_WB;
    return result;
  }
  if (seen.count < kFewestToReject) return result;
  std::optional<std::size_t> astray;
  Fitted best;
  for (int k = 0; k < seen.count; ++k) {
    const Chosen rest = seen.without(k);
    if (on_a_line(template_m_, rest)) continue;
    const Fitted fitted = fit_chosen(template_m_, p_W, rest);
    if (astray && !(fitted.rms_m < best.rms_m)) continue;
    best = fitted;
    astray = seen.at(k);
  }
  if (!astray || !(best.rms_m <= max_residual_m_)) return result;
  result.state = FrameState::rejected;
  result.used = seen.count - 1;
  result.rejected = astray;
  result.residual_m = best.rms_m;
  result.X_WB = best.X_WB;
  return result;
}

}  // namespace isograsp
