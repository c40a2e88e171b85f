// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/pad_step.hpp"

#include <algorithm>

#include <Eigen/LU>

#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

Bodies::Bodies(const PadStep& step) : step_s(step.step_s), velocity(step.velocity_free) {
  for (const Mat6& inertia : step.inertia) inverse.push_back(inertia.inverse());
}

PadSolution solve(const PadStep& step, PadSolver solver, const PadSolution* before) {
  switch (solver) {
    case PadSolver::pointwise: return solve_points(step, before);
    case PadSolver::aggregate: return solve_faces(step, false, before);
    case PadSolver::aggregate_exact: break;
  }
  return solve_faces(step, true, before);
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
