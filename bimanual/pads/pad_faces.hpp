// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: each pad as one block of rows, by block Gauss-Seidel in the
// velocities of the bodies: pressure shared as in the free motion, friction within an ellipsoid.
#pragma once

#include <vector>

#include "bimanual/pads/pad_step.hpp"

namespace isograsp::bimanual {

/// The bodies, moved by forces between two of them at a time.
struct FaceBodies {
  double step_s = 0.0;
  std::vector<Vec6> velocity;
  std::vector<Mat6> inverse;
};

/// Rows between an object and a pad: the velocity of the pad along them less that of the object.
/// A force along them acts on the object, and against it on the pad.
template <int N>
struct Rows {
  using Columns = Eigen::Matrix<double, 6, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  Columns object, pad;            ///< a row each
  Columns by_object, by_pad;      ///< velocity for a unit of impulse
  Eigen::Matrix<double, N, N> W;  ///< slip for a unit of force, over one step

  void prepare(const FaceBodies& bodies, const PadFace& face) {
    by_object = bodies.inverse[face.object] * object;
    by_pad = bodies.inverse[face.pad] * pad;
    W = bodies.step_s * (object.transpose() * by_object + pad.transpose() * by_pad);
    W = 0.5 * (W + W.transpose()).eval();
  }
  [[nodiscard]] Vector slip(const FaceBodies& bodies, const PadFace& face) const {
    return pad.transpose() * bodies.velocity[face.pad] -
           object.transpose() * bodies.velocity[face.object];
  }
  void push(FaceBodies& bodies, const PadFace& face, const Vector& force) const {
    bodies.velocity[face.object] += bodies.step_s * (by_object * force);
    bodies.velocity[face.pad] -= bodies.step_s * (by_pad * force);
  }
};

/// One pad.
struct FaceBlock {
  std::vector<double> share;  ///< of the pressure, by point
  Vec3 normal;                ///< mean; zero: nothing touches
  Rows<1> pressure;           ///< along the normals, as the points share it
  Rows<1> volume;             ///< m³ of penetration for each m, over the points that touch
  double volume_free_m3 = 0.0;
  Rows<3> friction;  ///< two directions at the centroid of pressure, turning about the normal
  Eigen::Matrix<double, 3, 2> directions;
  double torsion_m = 0.0;  ///< mean distance from the centroid
  double normal_N = 0.0;
  Vec3 friction_N = Vec3::Zero();  ///< force, force, torque
};

/// Solves step after step. Does not allocate once it has seen as many bodies and points.
class FaceSolver {
 public:
  /// `go_on`: from the forces of `solution`, of the step before; else from none.
  void solve(const PadStep& step, bool go_on, PadSolution& solution);

 private:
  void begin(const PadStep& step);
  void sweep(const PadStep& step);
  [[nodiscard]] bool stands() const;
  void recall(const PadMemory& memory, const PadFace& face, FaceBlock& block);

  FaceBodies bodies_;
  std::vector<Vec6> before_;  ///< velocities before the sweep
  std::vector<FaceBlock> blocks_;
};

}  // namespace isograsp::bimanual
