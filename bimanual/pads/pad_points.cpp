// SPDX-License-Identifier: GPL-3.0-or-later
// Soft pads point by point.
#include "bimanual/pads/friction_block.hpp"
#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

namespace {

struct PointBlock {
  Rows<1> normal;
  Rows<2> across;
  Eigen::Matrix<double, 3, 2> directions;  ///< of `across`
  double stiffness_N_m = 0.0;              ///< of its piece of the bed
  double free_m = 0.0;  ///< penetration if nothing moved but as it does without contact
  double normal_N = 0.0;
  Vec2 friction_N = Vec2::Zero();
};

}  // namespace

PadSolution solve_points(const PadStep& step, const PadSolution* before) {
  Bodies bodies(step);
  PadSolution solution;
  std::vector<std::vector<PointBlock>> blocks;
  for (const PadFace& face : step.faces) {
    auto& of_face = blocks.emplace_back();
    for (const PadPoint& point : face.points) {
      PointBlock block;
      const Tangents t(point.normal);
      block.normal.object = row_of(point.normal, point.p_object);
      block.normal.pad = row_of(point.normal, point.p_pad);
      block.across.object << row_of(t.first, point.p_object), row_of(t.second, point.p_object);
      block.across.pad << row_of(t.first, point.p_pad), row_of(t.second, point.p_pad);
      block.normal.prepare(bodies, face);
      block.across.prepare(bodies, face);
      block.stiffness_N_m = face.stiffness_N_m3 * point.area_m2;
      block.free_m =
          point.penetration_free_m - step.step_s * block.normal.slip(bodies, face).value();
      block.directions << t.first, t.second;
      of_face.push_back(block);
    }
    solution.constraints += 3 * face.points.size();
  }
  if (before != nullptr)
    for (std::size_t f = 0; f < step.faces.size(); ++f)
      for (std::size_t i = 0; i < blocks[f].size(); ++i) {
        PointBlock& block = blocks[f][i];
        block.normal_N = before->memory[f].normal_N[i];
        block.friction_N = block.directions.transpose() * before->memory[f].friction_W_N[i];
        block.normal.push(bodies, step.faces[f], Eigen::Matrix<double, 1, 1>(block.normal_N));
        block.across.push(bodies, step.faces[f], block.friction_N);
      }
  sweep_until_settled(bodies, solution, [&] {
    for (std::size_t f = 0; f < step.faces.size(); ++f) {
      const PadFace& face = step.faces[f];
      for (PointBlock& block : blocks[f]) {
        const double depth_m = block.free_m + step.step_s * block.normal.slip(bodies, face).value();
        const double k = block.stiffness_N_m;
        const double normal_N =
            std::max(0.0, block.normal_N + (k * depth_m - block.normal_N) /
                                               (1.0 + k * step.step_s * block.normal.W.value()));
        block.normal.push(bodies, face, Eigen::Matrix<double, 1, 1>(normal_N - block.normal_N));
        block.normal_N = normal_N;
        const Vec2 slip_free = block.across.slip(bodies, face) + block.across.W * block.friction_N;
        const Vec2 friction_N = friction_in_ellipsoid<2>(block.across.W, slip_free,
                                                         Vec2::Constant(face.friction * normal_N));
        block.across.push(bodies, face, friction_N - block.friction_N);
        block.friction_N = friction_N;
      }
    }
  });
  for (std::size_t f = 0; f < step.faces.size(); ++f) {
    Vec6 wrench = Vec6::Zero();
    PadMemory& memory = solution.memory.emplace_back();
    for (const PointBlock& block : blocks[f]) {
      wrench += block.normal.object * block.normal_N + block.across.object * block.friction_N;
      memory.normal_N.push_back(block.normal_N);
      memory.friction_W_N.push_back(block.directions * block.friction_N);
    }
    solution.wrench_on_object.push_back(wrench);
  }
  solution.velocity = bodies.velocity;
  return solution;
}

}  // namespace isograsp::bimanual
