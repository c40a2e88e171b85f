// SPDX-License-Identifier: GPL-3.0-or-later
// One backward-Euler step of an object that soft pads hold: a pad is a rigid face of points on a
// bed of springs, k [N/m^3], with Coulomb friction, on springs and dampers of its own (Talvas et
// al., aggregate constraints; docs/bimanual.md, "Pads"). Geometry is that of the begin of the step.
// Three ways to solve it: every point (3 rows each), or one normal, two tangential and one
// torsional row for each pad, with the friction of an ellipsoid or that of its points. SI units,
// world axes.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/spatial.hpp"

namespace isograsp::bimanual {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// A point of a pad, and the place of the object beside it.
struct PadPoint {
  Vec3 p_object = Vec3::Zero();  ///< from the object's origin
  Vec3 p_pad = Vec3::Zero();     ///< from the pad's origin
  Vec3 normal = Vec3::UnitZ();   ///< into the object
  double area_m2 = 0.0;
  double penetration_free_m = 0.0;  ///< at the end of the step if nothing touched
};

struct PadFace {
  std::size_t object = 0;  ///< which of the bodies
  std::size_t pad = 1;
  double friction = 0.8;
  double stiffness_N_m3 = 0.0;  ///< of the bed
  std::vector<PadPoint> points;
};

/// A (v - v_free) = h J^T f; velocities are (linear, angular) of the body's origin.
struct PadStep {
  double step_s = 1e-3;
  std::vector<Mat6> inertia;  ///< A of each body; a pad without mass: h (C + h K)
  std::vector<Vec6> velocity_free;
  std::vector<PadFace> faces;
};

enum class PadSolver : std::uint8_t { pointwise, aggregate, aggregate_exact };
inline constexpr std::array<std::string_view, 3> kPadSolverNames{"pointwise", "aggregate",
                                                                 "aggregate_exact"};

/// Forces of a face that the next step may begin with: of each point, or (`aggregate`) of the face
/// as one block.
struct PadMemory {
  std::vector<double> normal_N;
  std::vector<Vec3> friction_W_N;
  double torque_Nm = 0.0;
};

struct PadSolution {
  std::vector<Vec6> velocity;          ///< of each body
  std::vector<Vec6> wrench_on_object;  ///< of each face, about the object's origin
  std::size_t constraints = 0;         ///< rows, whether they act or not
  int sweeps = 0;                      ///< passes over all faces and their points
  bool settled = true;                 ///< false: the sweeps ended before it did
  std::vector<PadMemory> memory;       ///< of each face
};

/// Until velocities are within 1e-10 of the largest one: `pointwise` and `aggregate_exact` by
/// Newton (impulses are missed by no more, and nothing that sticks slips by more, or by more than 2
/// nm/s), `aggregate` by block Gauss-Seidel (no sweep changes more). `before`: the step before, of
/// the same faces and by the same solver, where it begins; null: at the free motion. The answer is
/// the same within that. Where several points of a pad stick, their forces are one choice of many
/// that give the same velocities and the same wrench.
/// @pre a pad belongs to one face, and the places of a point from the two origins differ by the
/// same for all points of a face.
[[nodiscard]] PadSolution solve(const PadStep& step, PadSolver solver,
                                const PadSolution* before = nullptr);

/// The same for one step after the other, each begun where the last one ended. Does not allocate
/// once it has seen as many bodies and points.
class PadSteps {
 public:
  explicit PadSteps(PadSolver solver);
  ~PadSteps();
  PadSteps(PadSteps&&) noexcept;
  PadSteps& operator=(PadSteps&&) noexcept;
  /// As if `before`, by the same solver, had been the last one.
  void go_on_from(const PadSolution& before) {
    solution_ = before;
    begun_ = true;
  }
  const PadSolution& solve(const PadStep& step);
  [[nodiscard]] const PadSolution& last() const noexcept { return solution_; }

 private:
  struct Solvers;
  PadSolver solver_;
  bool begun_ = false;
  PadSolution solution_;
  std::unique_ptr<Solvers> solvers_;
};

/// Largest difference of two solutions: of forces over `largest_N`, of torques over
/// `largest_N` times kArm_m.
inline constexpr double kArm_m = 0.04;
[[nodiscard]] double wrench_error(const PadSolution& solution, const PadSolution& exact);

}  // namespace isograsp::bimanual
