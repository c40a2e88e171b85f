// SPDX-License-Identifier: GPL-3.0-or-later
// Moving an object on the screen: a planned path, the forces that its springs need, correction of
// the seen error, and fingers that share the wrench and squeeze enough not to slip. Frames: W
// world, O object, C contact. SI units.
#pragma once

#include "core/stimulus.hpp"
#include "grasp_model/scene.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp {

/// A movement with least jerk from one pose to another (Flash, Hogan 1985).
class PosePlan {
 public:
  struct Point {
    Pose pose;
    Vec3 v_WO_W = Vec3::Zero();  ///< [m/s]
    Vec3 w_WO_O = Vec3::Zero();  ///< [rad/s], object axes
  };
  PosePlan() = default;
  /// The object stays at `pose`.
  explicit PosePlan(const Pose& pose) : from_(pose), to_(pose) {}
  PosePlan(const Pose& from, const Pose& to, double start_s, double duration_s) noexcept;

  [[nodiscard]] Point at(double t_s) const noexcept;
  [[nodiscard]] const Pose& end() const noexcept { return to_; }

 private:
  Pose from_, to_;
  Vec3 turn_ = Vec3::Zero();  ///< rotation vector from `from` to `to`, object axes [rad]
  double start_s_ = 0.0;
  double duration_s_ = 1.0;
};

class ObjectSkill {
 public:
  /// Learns the object. Allocates nothing later.
  ObjectSkill(const PatientTraits& traits, const Scene& scene);

  /// The task begins at time t_s, with the object as it was perceived last.
  void begin(double t_s) noexcept;
  /// A perceived picture, in the order of time, at time t_s of the person.
  void perceive(const Stimulus& picture, double t_s) noexcept;
  /// The forces wanted at time t_s. Real-time safe.
  [[nodiscard]] FingerForces wanted(double t_s) noexcept;

 private:
  static constexpr Eigen::Index kAxes = 3 * static_cast<Eigen::Index>(kFingerCount);
  using Map = Eigen::Matrix<double, 6, kAxes>;
  using Inverse = Eigen::Matrix<double, kAxes, 6>;
  using Stacked = Eigen::Matrix<double, kAxes, 1>;

  void learn_grasp();
  [[nodiscard]] Vec6 error(const Pose& wanted, const Pose& seen) const noexcept;
  [[nodiscard]] Vec6 wrench_W(double t_s) noexcept;
  void squeeze(Stacked& forces) const noexcept;

  PatientTraits traits_;
  Scene scene_;
  Inverse share_ = Inverse::Zero();             ///< wrench to finger forces, least squares
  Stacked grip_ = Stacked::Zero();              ///< finger forces that balance each other
  std::array<double, kFingerCount> least_N_{};  ///< normal force that keeps the touch
  Vec6 free_ = Vec6::Zero();                    ///< 1: the degree of freedom is free
  Vec6 largest_correction_ = Vec6::Zero();

  PosePlan plan_;
  bool waiting_ = false;  ///< a new target was perceived; the movement starts at waiting_until_s_
  double waiting_until_s_ = 0.0;
  bool seen_ = false;
  Stimulus picture_;
  double begin_s_ = 0.0;
  Vec6 correction_ = Vec6::Zero();  ///< integral of the seen error [N, N m]
  Vec6 error_ = Vec6::Zero();       ///< seen last [m, rad], world axes
};

}  // namespace isograsp
