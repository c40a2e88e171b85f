// SPDX-License-Identifier: GPL-3.0-or-later
// Soft pads as one block of rows each.
#include "bimanual/pads/pad_faces.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "bimanual/pads/friction_block.hpp"
#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

namespace {

constexpr int kMostSweeps = 20000;

/// Two directions across a normal.
struct Tangents {
  explicit Tangents(const Vec3& normal) {
    const Vec3 aside = std::abs(normal.x()) < 0.5 ? Vec3::UnitX() : Vec3::UnitY();
    first = normal.cross(aside).normalized();
    second = normal.cross(first);
  }
  Vec3 first, second;
};

/// The points of a face by where they are after the free motion.
void aggregate(const PadStep& step, const FaceBodies& bodies, const PadFace& face,
               FaceBlock& block) {
  const std::size_t count = face.points.size();
  block.share.assign(count, 0.0);
  block.normal.setZero();
  block.volume.object.setZero();
  block.volume.pad.setZero();
  block.pressure.object.setZero();
  block.pressure.pad.setZero();
  block.friction.object.setZero();
  block.directions.setZero();
  block.normal_N = 0.0;
  block.friction_N.setZero();
  block.volume_free_m3 = 0.0;
  double volume_m3 = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const PadPoint& point = face.points[i];
    const double depth_m = point.penetration_free_m;
    if (!(depth_m > 0.0)) continue;
    const Vec6 object = row_of(point.normal, point.p_object);
    const Vec6 pad = row_of(point.normal, point.p_pad);
    const double slip =
        pad.dot(step.velocity_free[face.pad]) - object.dot(step.velocity_free[face.object]);
    block.share[i] = point.area_m2 * depth_m;
    volume_m3 += block.share[i];
    block.volume.object += point.area_m2 * object;
    block.volume.pad += point.area_m2 * pad;
    block.volume_free_m3 += point.area_m2 * (depth_m - step.step_s * slip);
  }
  if (!(volume_m3 > 0.0)) return;
  Vec3 p_object = Vec3::Zero(), p_pad = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const PadPoint& point = face.points[i];
    block.share[i] /= volume_m3;
    block.normal += block.share[i] * point.normal;
    p_object += block.share[i] * point.p_object;
    p_pad += block.share[i] * point.p_pad;
    block.pressure.object += block.share[i] * row_of(point.normal, point.p_object);
    block.pressure.pad += block.share[i] * row_of(point.normal, point.p_pad);
  }
  block.normal.normalize();
  const Tangents t(block.normal);
  block.directions << t.first, t.second;
  block.torsion_m = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    block.torsion_m +=
        block.share[i] * across(face.points[i].p_object - p_object, block.normal).norm();
  Vec6 turn;
  turn << Vec3::Zero(), block.normal;
  block.friction.object << row_of(t.first, p_object), row_of(t.second, p_object), turn;
  block.friction.pad << row_of(t.first, p_pad), row_of(t.second, p_pad), turn;
  block.pressure.prepare(bodies, face);
  block.friction.prepare(bodies, face);
}

void put_memory(const FaceBlock& block, PadMemory& memory) {
  memory.normal_N.assign(1, block.normal_N);
  memory.friction_W_N.assign(1, block.directions * block.friction_N.head<2>());
  memory.torque_Nm = block.friction_N[2];
}

}  // namespace

void FaceSolver::begin(const PadStep& step) {
  bodies_.step_s = step.step_s;
  bodies_.velocity = step.velocity_free;
  bodies_.inverse.resize(step.inertia.size());
  for (std::size_t b = 0; b < step.inertia.size(); ++b)
    bodies_.inverse[b] = step.inertia[b].inverse();
  blocks_.resize(step.faces.size());
  for (std::size_t f = 0; f < step.faces.size(); ++f)
    aggregate(step, bodies_, step.faces[f], blocks_[f]);
}

/// Begins with the forces of the step before.
void FaceSolver::recall(const PadMemory& memory, const PadFace& face, FaceBlock& block) {
  if (block.normal.isZero()) return;
  block.normal_N = memory.normal_N.front();
  block.friction_N << block.directions.transpose() * memory.friction_W_N.front(), memory.torque_Nm;
  block.pressure.push(bodies_, face, Eigen::Matrix<double, 1, 1>(block.normal_N));
  block.friction.push(bodies_, face, block.friction_N);
}

void FaceSolver::sweep(const PadStep& step) {
  for (std::size_t f = 0; f < step.faces.size(); ++f) {
    const PadFace& face = step.faces[f];
    FaceBlock& block = blocks_[f];
    if (block.normal.isZero()) continue;  // nothing touches
    const double volume_m3 =
        block.volume_free_m3 + step.step_s * block.volume.slip(bodies_, face).value();
    const double give = step.step_s * (block.volume.object.dot(block.pressure.by_object) +
                                       block.volume.pad.dot(block.pressure.by_pad));
    const double k = face.stiffness_N_m3;
    const double normal_N = std::max(
        0.0, block.normal_N + (k * volume_m3 - block.normal_N) / (1.0 + k * step.step_s * give));
    block.pressure.push(bodies_, face, Eigen::Matrix<double, 1, 1>(normal_N - block.normal_N));
    block.normal_N = normal_N;
    const Vec3 slip_free = block.friction.slip(bodies_, face) + block.friction.W * block.friction_N;
    const double limit_N = face.friction * normal_N;
    const Vec3 friction = friction_in_ellipsoid(block.friction.W, slip_free,
                                                {limit_N, limit_N, limit_N * block.torsion_m});
    block.friction.push(bodies_, face, friction - block.friction_N);
    block.friction_N = friction;
  }
}

/// No velocity has changed any more.
bool FaceSolver::stands() const {
  double change = 0.0, size = kStill;
  for (std::size_t b = 0; b < before_.size(); ++b) {
    change = std::max(change, (bodies_.velocity[b] - before_[b]).cwiseAbs().maxCoeff());
    size = std::max(size, bodies_.velocity[b].cwiseAbs().maxCoeff());
  }
  return change <= kSettled * size;
}

void FaceSolver::solve(const PadStep& step, bool go_on, PadSolution& solution) {
  begin(step);
  if (go_on)
    for (std::size_t f = 0; f < step.faces.size(); ++f)
      recall(solution.memory[f], step.faces[f], blocks_[f]);
  solution.constraints = 4 * step.faces.size();
  solution.sweeps = 0;
  solution.settled = false;
  while (solution.sweeps < kMostSweeps && !solution.settled) {
    before_ = bodies_.velocity;
    sweep(step);
    ++solution.sweeps;
    solution.settled = stands();
  }
  solution.velocity = bodies_.velocity;
  solution.wrench_on_object.resize(blocks_.size());
  solution.memory.resize(blocks_.size());
  for (std::size_t f = 0; f < blocks_.size(); ++f) {
    const FaceBlock& block = blocks_[f];
    solution.wrench_on_object[f] =
        block.pressure.object * block.normal_N + block.friction.object * block.friction_N;
    put_memory(block, solution.memory[f]);
  }
}

}  // namespace isograsp::bimanual
