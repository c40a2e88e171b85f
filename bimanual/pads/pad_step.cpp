// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/pad_step.hpp"

#include <algorithm>
#include <memory>

#include "bimanual/pads/pad_faces.hpp"
#include "bimanual/pads/pad_points.hpp"

namespace isograsp::bimanual {

/// One of the two is used.
struct PadSteps::Solvers {
  explicit Solvers(PadSolver solver) : points(solver == PadSolver::aggregate_exact) {}
  PointSolver points;
  FaceSolver faces;
};

PadSteps::PadSteps(PadSolver solver)
    : solver_(solver), solvers_(std::make_unique<Solvers>(solver)) {}
PadSteps::~PadSteps() = default;
PadSteps::PadSteps(PadSteps&&) noexcept = default;
PadSteps& PadSteps::operator=(PadSteps&&) noexcept = default;

const PadSolution& PadSteps::solve(const PadStep& step) {
  if (solver_ == PadSolver::aggregate)
    solvers_->faces.solve(step, begun_, solution_);
  else
    solvers_->points.solve(step, begun_, solution_);
  begun_ = true;
  return solution_;
}

PadSolution solve(const PadStep& step, PadSolver solver, const PadSolution* before) {
  PadSteps steps(solver);
  if (before != nullptr) steps.go_on_from(*before);
  return steps.solve(step);
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
