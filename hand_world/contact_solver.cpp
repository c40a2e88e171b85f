// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/contact_solver.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "hand_world/disk_limit.hpp"

namespace isograsp::hand_world {

namespace {

/// A torque turns a contact as fast as a force moves the rim of its disk; of points as fast as
/// this.
constexpr double kPoint_m = 1e-3;

double speed_of(const Eigen::Vector4d& velocity, double radius_m) noexcept {
  return std::max(velocity.head<3>().cwiseAbs().maxCoeff(),
                  std::abs(velocity[3]) * std::max(radius_m, kPoint_m));
}

/// Within the limit as it is; else the nearest of the limit. Returns whether it was within.
bool keep_within(const DiskLimit& limit, Eigen::Vector4d& force, double per_force,
                 double per_torque, double& slip_angle) noexcept {
  const double tangential = std::hypot(force[1], force[2]);
  const DiskLoad trial{tangential, std::abs(force[3])};
  if (limit.bears(trial)) return true;
  const DiskLoad kept = limit.nearest(trial, per_force, per_torque, slip_angle);
  const double share = tangential > 0.0 ? kept.force / tangential : 0.0;
  force[1] *= share;
  force[2] *= share;
  force[3] = std::copysign(kept.torque, force[3]);
  return false;
}

}  // namespace

void ContactSolver::prepare(std::size_t i) noexcept {
  const ContactBlock& block = blocks_[i];
  if (block.law == ContactBlock::Law::rest) return;
  Local& local = locals_[i];
  const Eigen::Matrix4d& own = compliance_[i][i];
  // An isotropic majorant: with it a step of the projected iteration never overshoots.
  const double mean = 0.5 * (own(1, 1) + own(2, 2));
  const double spread = std::hypot(0.5 * (own(1, 1) - own(2, 2)), own(1, 2));
  const double tangential = mean + spread;
  const bool turns = block.radius_m > 0.0;
  const double across =
      turns ? std::hypot(own(1, 3), own(2, 3)) / std::sqrt(tangential * own(3, 3)) : 0.0;
  local.per_force = (1.0 + across) * tangential;
  local.per_torque = (1.0 + across) * own(3, 3);

  Eigen::Matrix4d matrix = own;
  if (!turns) {
    matrix.row(3).setZero();
    matrix.col(3).setZero();
    matrix(3, 3) = 1.0;
  }
  if (block.law == ContactBlock::Law::touch) {
    matrix(0, 0) += block.softness;
  } else {
    matrix.row(0).setZero();
    matrix.col(0).setZero();
    matrix(0, 0) = 1.0;
  }
  local.sticks = matrix.inverse();
}

double ContactSolver::normal_load(const ContactBlock& block) const noexcept {
  if (block.law == ContactBlock::Law::press) return block.given_N;
  double load_N = 0.0;
  for (std::size_t k = block.first; k < block.last; ++k) load_N += blocks_[k].force[0];
  return load_N;
}

/// Projected iteration: every fixed point is the friction of maximum dissipation.
void ContactSolver::rub(std::size_t i, double load_N, const Eigen::Vector4d& without,
                        Eigen::Vector4d& force) noexcept {
  ContactBlock& block = blocks_[i];
  const Local& local = locals_[i];
  const DiskLimit limit{block.friction * load_N, block.radius_m};
  const Eigen::Vector4d velocity = without + compliance_[i][i] * force;
  force[1] -= velocity[1] / local.per_force;
  force[2] -= velocity[2] / local.per_force;
  force[3] = block.radius_m > 0.0 ? force[3] - velocity[3] / local.per_torque : 0.0;
  keep_within(limit, force, local.per_force, local.per_torque, block.slip_angle);
}

Eigen::Vector4d ContactSolver::solve_block(std::size_t i, const Eigen::Vector4d& without) noexcept {
  using Law = ContactBlock::Law;
  ContactBlock& block = blocks_[i];
  const Local& local = locals_[i];
  const Eigen::Matrix4d& own = compliance_[i][i];
  Eigen::Vector4d force = Eigen::Vector4d::Zero();
  if (block.law == Law::rest) {
    force[0] = std::max(0.0, -(without[0] + block.bias_m_s) / (own(0, 0) + block.softness));
    return force;
  }
  const bool touch = block.law == Law::touch;
  double load_N = 0.0;
  if (touch) {
    if (without[0] + block.bias_m_s >= 0.0) return force;
  } else {
    load_N = normal_load(block);
    force[0] = block.law == Law::press ? load_N : 0.0;
  }

  // All of it at once, if nothing slips.
  Eigen::Vector4d target = without;
  if (touch)
    target[0] += block.bias_m_s;
  else
    target += own.col(0) * force[0];
  if (!touch) target[0] = 0.0;
  if (!(block.radius_m > 0.0)) target[3] = 0.0;
  Eigen::Vector4d sticks = -(local.sticks * target);
  if (!touch) sticks[0] = force[0];
  const double pressed_N = touch ? sticks[0] : load_N;
  const DiskLoad asked{std::hypot(sticks[1], sticks[2]), std::abs(sticks[3])};
  if (pressed_N > 0.0 && DiskLimit{block.friction * pressed_N, block.radius_m}.bears(asked))
    return sticks;

  // It slips: normal force and friction by turns, from where the last sweep ended.
  constexpr int kTurns = 2;
  force.tail<3>() = block.force.tail<3>();
  for (int turn = 0; turn < kTurns; ++turn) {
    const Eigen::Vector4d before = force;
    if (touch) {
      const double coupled = own.row(0).tail<3>().dot(force.tail<3>());
      load_N =
          std::max(0.0, -(without[0] + block.bias_m_s + coupled) / (own(0, 0) + block.softness));
      force[0] = load_N;
    }
    rub(i, load_N, without, force);
    if (speed_of(own * (force - before), block.radius_m) <= 0.1 * kSettled_m_s) break;
  }
  return force;
}

SolverReport ContactSolver::solve(const FactoredArrow& matrix, const ArrowVector& free,
                                  double step_s) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    const ContactBlock& block = blocks_[i];
    reduced_[i] = matrix.reduced(block.rows);
    locals_[i].velocity = block.rows.times(free);
    for (std::size_t j = 0; j <= i; ++j) {
      compliance_[i][j] =
          step_s * FactoredArrow::compliance(block.rows, reduced_[i], blocks_[j].rows, reduced_[j]);
      if (j < i) compliance_[j][i] = compliance_[i][j].transpose();
    }
    prepare(i);
  }
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t j = 0; j < count_; ++j)
      locals_[i].velocity += compliance_[i][j] * blocks_[j].force;

  SolverReport report;
  for (; report.sweeps < kSweeps; ++report.sweeps) {
    report.residual_m_s = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      ContactBlock& block = blocks_[i];
      const Eigen::Matrix4d& own = compliance_[i][i];
      const Eigen::Vector4d force = solve_block(i, locals_[i].velocity - own * block.force);
      const Eigen::Vector4d change = force - block.force;
      if (change.isZero(0.0)) continue;
      block.force = force;
      for (std::size_t j = 0; j < count_; ++j) locals_[j].velocity += compliance_[j][i] * change;
      report.residual_m_s = std::max(report.residual_m_s, speed_of(own * change, block.radius_m));
    }
    if (report.residual_m_s <= kSettled_m_s) break;
  }
  return report;
}

void ContactSolver::add_forces(ArrowVector& to) const noexcept {
  for (std::size_t i = 0; i < count_; ++i) blocks_[i].rows.add_transposed(blocks_[i].force, to);
}

}  // namespace isograsp::hand_world
