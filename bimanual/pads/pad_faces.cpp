// SPDX-License-Identifier: GPL-3.0-or-later
// Soft pads as one block of rows each.
#include "bimanual/pads/friction_block.hpp"
#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

namespace {

/// Of the shares of aggregate_exact, which sum up to 1.
constexpr double kSharesSettled = 1e-11;
constexpr int kMostRounds = 500;

struct FaceBlock {
  std::vector<double> share;  ///< of the pressure, by point
  Vec3 normal;                ///< mean
  Rows<1> pressure;           ///< along the normals, as the points share it
  Rows<1> volume;             ///< m³ of penetration for each m, over the points that touch
  double volume_free_m3 = 0.0;
  Rows<3> friction;        ///< two directions at the centroid of pressure, turning about the normal
  std::vector<Vec2> arms;  ///< of the points, from the centroid, in these directions
  double torsion_m = 0.0;  ///< mean distance from it
  Eigen::Matrix<double, 3, 2> directions = Eigen::Matrix<double, 3, 2>::Zero();
  double normal_N = 0.0;
  Vec3 friction_N = Vec3::Zero();      ///< force, force, torque
  std::vector<Vec2> point_friction_N;  ///< of aggregate_exact: what each point gives
};

/// The points of a face by where they are with the velocities `v`.
void aggregate(const PadStep& step, const Bodies& bodies, const std::vector<Vec6>& v,
               const PadFace& face, FaceBlock& block) {
  const std::size_t count = face.points.size();
  block.share.assign(count, 0.0);
  block.arms.assign(count, Vec2::Zero());
  block.point_friction_N.resize(count, Vec2::Zero());
  block.normal.setZero();
  block.volume.object.setZero();
  block.volume.pad.setZero();
  block.pressure.object.setZero();
  block.pressure.pad.setZero();
  block.volume_free_m3 = 0.0;
  double volume_m3 = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const PadPoint& point = face.points[i];
    const Vec6 object = row_of(point.normal, point.p_object);
    const Vec6 pad = row_of(point.normal, point.p_pad);
    const auto slip = [&](const std::vector<Vec6>& u) {
      return pad.dot(u[face.pad]) - object.dot(u[face.object]);
    };
    const double at_rest_m = point.penetration_free_m - step.step_s * slip(step.velocity_free);
    const double depth_m = at_rest_m + step.step_s * slip(v);
    if (!(depth_m > 0.0)) continue;
    block.share[i] = point.area_m2 * depth_m;
    volume_m3 += block.share[i];
    block.volume.object += point.area_m2 * object;
    block.volume.pad += point.area_m2 * pad;
    block.volume_free_m3 += point.area_m2 * at_rest_m;
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
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 arm = face.points[i].p_object - p_object;
    block.arms[i] = {arm.dot(t.first), arm.dot(t.second)};
    block.torsion_m += block.share[i] * block.arms[i].norm();
  }
  Vec6 turn;
  turn << Vec3::Zero(), block.normal;
  block.friction.object << row_of(t.first, p_object), row_of(t.second, p_object), turn;
  block.friction.pad << row_of(t.first, p_pad), row_of(t.second, p_pad), turn;
  block.pressure.prepare(bodies, face);
  block.friction.prepare(bodies, face);
}

/// Slip at a point from that of its face.
Eigen::Matrix<double, 2, 3> at_point(const Vec2& arm) {
  Eigen::Matrix<double, 2, 3> P;
  P << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
  return P;
}

/// Friction of all points of a face while nothing else moves: each in its own disk.
Vec3 friction_of_points(const Eigen::Matrix3d& W, const Vec3& slip_free, FaceBlock& block,
                        double limit_N) {
  constexpr int kMostInner = 200;
  constexpr double kInnerSettled = 1e-13;
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < block.arms.size(); ++i) {
    if (block.share[i] == 0.0) block.point_friction_N[i].setZero();
    sum += at_point(block.arms[i]).transpose() * block.point_friction_N[i];
  }
  for (int k = 0; k < kMostInner; ++k) {
    double change_N = 0.0;
    for (std::size_t i = 0; i < block.arms.size(); ++i) {
      if (block.share[i] == 0.0) continue;
      const auto P = at_point(block.arms[i]);
      const Eigen::Matrix2d at = P * W * P.transpose();
      Vec2& force = block.point_friction_N[i];
      const Vec2 free = P * (slip_free - W * sum) + at * force;
      const Vec2 next =
          friction_in_ellipsoid<2>(at, free, Vec2::Constant(limit_N * block.share[i]));
      change_N = std::max(change_N, (next - force).norm());
      sum += P.transpose() * (next - force);
      force = next;
    }
    if (change_N <= kInnerSettled * limit_N) break;
  }
  return sum;
}

void sweep_faces(const PadStep& step, Bodies& bodies, std::vector<FaceBlock>& blocks, bool exact) {
  for (std::size_t f = 0; f < step.faces.size(); ++f) {
    const PadFace& face = step.faces[f];
    FaceBlock& block = blocks[f];
    if (block.normal.isZero()) continue;  // nothing touches
    const double volume_m3 =
        block.volume_free_m3 + step.step_s * block.volume.slip(bodies, face).value();
    const double give = step.step_s * (block.volume.object.dot(block.pressure.by_object) +
                                       block.volume.pad.dot(block.pressure.by_pad));
    const double k = face.stiffness_N_m3;
    const double normal_N = std::max(
        0.0, block.normal_N + (k * volume_m3 - block.normal_N) / (1.0 + k * step.step_s * give));
    block.pressure.push(bodies, face, Eigen::Matrix<double, 1, 1>(normal_N - block.normal_N));
    block.normal_N = normal_N;
    const Vec3 slip_free = block.friction.slip(bodies, face) + block.friction.W * block.friction_N;
    const double limit_N = face.friction * normal_N;
    const Vec3 friction =
        exact ? friction_of_points(block.friction.W, slip_free, block, limit_N)
              : friction_in_ellipsoid<3>(block.friction.W, slip_free,
                                         Vec3(limit_N, limit_N, limit_N * block.torsion_m));
    block.friction.push(bodies, face, friction - block.friction_N);
    block.friction_N = friction;
  }
}

/// Begins with the forces of the step before.
void recall(const PadMemory& memory, const PadFace& face, Bodies& bodies, FaceBlock& block) {
  if (block.normal.isZero()) return;
  block.normal_N = memory.normal_N.front();
  block.friction_N << block.directions.transpose() * memory.friction_W_N.front(), memory.torque_Nm;
  for (std::size_t i = 0; i < memory.point_friction_W_N.size(); ++i)
    block.point_friction_N[i] = block.directions.transpose() * memory.point_friction_W_N[i];
  block.pressure.push(bodies, face, Eigen::Matrix<double, 1, 1>(block.normal_N));
  block.friction.push(bodies, face, block.friction_N);
}
PadMemory memory_of(const FaceBlock& block) {
  PadMemory memory;
  memory.normal_N = {block.normal_N};
  memory.friction_W_N = {block.directions * block.friction_N.head<2>()};
  memory.torque_Nm = block.friction_N[2];
  for (const Vec2& force : block.point_friction_N)
    memory.point_friction_W_N.push_back(block.directions * force);
  return memory;
}

}  // namespace

PadSolution solve_faces(const PadStep& step, bool exact, const PadSolution* before) {
  Bodies bodies(step);
  PadSolution solution;
  solution.constraints = 4 * step.faces.size();
  std::vector<FaceBlock> blocks(step.faces.size());
  for (std::size_t f = 0; f < step.faces.size(); ++f)
    aggregate(step, bodies, step.velocity_free, step.faces[f], blocks[f]);
  if (before != nullptr)
    for (std::size_t f = 0; f < step.faces.size(); ++f)
      recall(before->memory[f], step.faces[f], bodies, blocks[f]);
  for (int round = 0; round < kMostRounds; ++round) {
    sweep_until_settled(bodies, solution, [&] { sweep_faces(step, bodies, blocks, exact); });
    if (!exact) break;
    double change = 0.0;
    const std::vector<Vec6> reached = bodies.velocity;
    for (std::size_t f = 0; f < step.faces.size(); ++f) {
      const PadFace& face = step.faces[f];
      FaceBlock& block = blocks[f];
      const std::vector<double> former = block.share;
      // Forces go on from where they are, by rows that stand where the pressure is now.
      block.pressure.push(bodies, face, Eigen::Matrix<double, 1, 1>(-block.normal_N));
      block.friction.push(bodies, face, -block.friction_N);
      aggregate(step, bodies, reached, face, block);
      block.pressure.push(bodies, face, Eigen::Matrix<double, 1, 1>(block.normal_N));
      block.friction.push(bodies, face, block.friction_N);
      for (std::size_t i = 0; i < former.size(); ++i)
        change = std::max(change, std::abs(block.share[i] - former[i]));
    }
    if (change <= kSharesSettled) break;
  }
  for (const FaceBlock& block : blocks) {
    const bool touched = !block.normal.isZero();
    solution.wrench_on_object.push_back(touched ? Vec6(block.pressure.object * block.normal_N +
                                                       block.friction.object * block.friction_N)
                                                : Vec6(Vec6::Zero()));
    solution.memory.push_back(memory_of(block));
  }
  solution.velocity = bodies.velocity;
  return solution;
}

}  // namespace isograsp::bimanual
