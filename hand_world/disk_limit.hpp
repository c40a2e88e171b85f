// SPDX-License-Identifier: GPL-3.0-or-later
// What a disk with uniform pressure can bear by friction, tangential force and torque about its
// normal together: the exact Coulomb-Contensou set (grasp_model/limit_surface.hpp), and the point
// of it at which a trial ends that asks for more. Real-time safe.
#pragma once

namespace isograsp::hand_world {

/// Size of the tangential force [N] and torque about the normal [N m]; the signs are the caller's.
struct DiskLoad {
  double force = 0.0;
  double torque = 0.0;
};

/// The set of one disk at one normal force.
struct DiskLimit {
  double most_N = 0.0;    ///< mu times the normal force
  double radius_m = 0.0;  ///< 0: a point, which bears no torque

  /// @pre load.force >= 0, load.torque >= 0
  [[nodiscard]] bool bears(const DiskLoad& load) const noexcept;
  /// The load of the set that is nearest to `trial` where a difference of forces counts
  /// `per_force` (1/kg) and one of torques `per_torque` (1/(kg m2)): then the slip that is left,
  /// per_force (trial - load), is along the outward normal of the set, as friction of maximum
  /// dissipation asks. `angle`: of the slip, atan(|v| / (|w| R)); in: a guess.
  /// @pre the set does not bear `trial`; trial.force >= 0, trial.torque >= 0
  [[nodiscard]] DiskLoad nearest(const DiskLoad& trial, double per_force, double per_torque,
                                 double& angle) const noexcept;
};

}  // namespace isograsp::hand_world
