// SPDX-License-Identifier: GPL-3.0-or-later
// A reference that moves as an arm would: from posture to posture of a library, every link with
// least jerk, adapted to the size of this arm (kinematics/postures.hpp). With
// s(u) = u^3 (10 - 15 u + 6 u^2), u the share of the leg that is over, and M_L the change of link L
// from the initial posture, between the postures a and b
//   M_L = (p_a + s (p_b - p_a), q_a exp(s log(q_a^-1 q_b)))
#pragma once

#include <span>
#include <vector>

#include "kinematics/postures.hpp"

namespace isograsp {

class ReferencePath {
 public:
  /// One round goes through `round`, places in the library, and back to the first; each leg takes
  /// leg_s. @pre round is not empty, start has the links of the library, leg_s > 0
  ReferencePath(const Postures& library, std::span<const std::size_t> round,
                const StartPosture& start, SizeScale scale, double leg_s);

  /// Where the object is to be, t_s after the first leg began; round after round. Before: where it
  /// begins. Real-time safe.
  [[nodiscard]] Pose at(double t_s) const noexcept;
  /// Which leg that is, from 0.
  [[nodiscard]] int leg(double t_s) const noexcept;

 private:
  /// What one link does from one posture to the next.
  struct Change {
    Pose from;
    Vec3 way = Vec3::Zero();
    Vec3 turn = Vec3::Zero();  ///< rotation vector
  };

  double leg_s_;
  std::size_t links_;
  std::size_t legs_;
  Pose X_W_;                     ///< of the first frame of the chain
  std::vector<Pose> X_L_;        ///< of each link at the start, as far as the patient's size goes
  std::vector<Change> changes_;  ///< of leg k, link l: k links_ + l
};

}  // namespace isograsp
