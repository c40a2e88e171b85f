// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/pad_step.hpp"

#include <algorithm>
#include <memory>

#include <Eigen/LU>

#include "bimanual/pads/pad_points.hpp"
#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

Bodies::Bodies(const PadStep& step) : step_s(step.step_s), velocity(step.velocity_free) {
  for (const Mat6& inertia : step.inertia) inverse.push_back(inertia.inverse());
}

PadSolution solve(const PadStep& step, PadSolver solver, const PadSolution* before) {
  switch (solver) {
    case PadSolver::pointwise: {
      PointSolver points;
      PadSolution solution;
      if (before != nullptr) solution = *before;
      points.solve(step, before != nullptr, solution);
      return solution;
    }
    case PadSolver::aggregate: return solve_faces(step, false, before);
    case PadSolver::aggregate_exact: break;
  }
  return solve_faces(step, true, before);
}

PadSteps::PadSteps(PadSolver solver) : solver_(solver), points_(std::make_unique<PointSolver>()) {}
PadSteps::~PadSteps() = default;
PadSteps::PadSteps(PadSteps&&) noexcept = default;
PadSteps& PadSteps::operator=(PadSteps&&) noexcept = default;

const PadSolution& PadSteps::solve(const PadStep& step) {
  if (solver_ == PadSolver::pointwise)
    points_->solve(step, begun_, solution_);
  else
    solution_ = bimanual::solve(step, solver_, begun_ ? &solution_ : nullptr);
  begun_ = true;
  return solution_;
}

double wrench_error(const PadSolution& solution, const PadSolution& exact) {
  double largest_N = 0.0;
  for (const Vec6& wrench : exact.wrench_on_object)
    largest_N = std::max(largest_N, wrench.head<3>().norm());
  if (largest_N == 0.0) return 0.0;
  double error = 0.0;
  for (std::size_t f = 0; f < exact.wrench_on_object.size(); ++f) {
    const Vec6 off = solution.wrench_on_object[f] - exact.wrench_on_object[f];
    error = std::max({error, off.head<3>().cwiseAbs().maxCoeff() / largest_N,
                      off.tail<3>().cwiseAbs().maxCoeff() / (largest_N * kArm_m)});
  }
  return error;
}

}  // namespace isograsp::bimanual
