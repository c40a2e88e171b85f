// SPDX-License-Identifier: GPL-3.0-or-later
// Moving an object on the screen: a planned path to a target that stands, pursuit of one that
// moves, the forces that its springs need, correction of the seen error, and fingers that share the
// wrench and squeeze enough not to slip. Frames: W world, O object, C contact. SI units.
#pragma once

#include "grasp_model/scene.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// A movement with least jerk from one pose to another (Flash, Hogan 1985).
class PosePlan {
 public:
  struct Point {
    Pose X_WO;
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

/// Smooth pursuit of a target that moves without jumps: its speed is seen and used to predict it
/// one loop delay ahead (people predict a target that they follow). The distance between hand and
/// target at the beginning is made up with least jerk.
class Pursuit {
 public:
  /// The target as perceived at time t_s of the person, `dt_s` after the picture before.
  void see(const Pose& target, double dt_s, double t_s) noexcept;
  /// Faster than a target that stands or creeps.
  [[nodiscard]] bool moves() const noexcept;
  /// The hand is at `from` and catches up in `duration_s`.
  void begin(const Pose& from, double t_s, double duration_s, double delay_s) noexcept;
  /// The target jumped or is new: its speed is not known.
  void forget() noexcept;
  [[nodiscard]] PosePlan::Point at(double t_s) const noexcept;

 private:
  /// Where the target will be when what is wanted at t_s takes effect.
  [[nodiscard]] Pose expected(double t_s) const noexcept;

  Pose target_;
  bool seen_ = false;
  double seen_at_s_ = 0.0;
  Vec3 v_W_ = Vec3::Zero();  ///< [m/s]
  Vec3 w_T_ = Vec3::Zero();  ///< [rad/s], axes of the target
  double delay_s_ = 0.0;
  PosePlan catch_up_;  ///< from the distance to the target to none
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
  [[nodiscard]] PosePlan::Point planned(double t_s) const noexcept;
  void see_target(const Stimulus& picture, double dt_s, double t_s) noexcept;
  void squeeze(Stacked& forces) const noexcept;

  PatientTraits traits_;
  Scene scene_;
  Inverse share_ = Inverse::Zero();             ///< wrench to finger forces, least squares
  Stacked grip_ = Stacked::Zero();              ///< finger forces that balance each other
  std::array<double, kFingerCount> least_N_{};  ///< normal force that keeps the touch
  Vec6 free_ = Vec6::Zero();                    ///< 1: the degree of freedom is free
  Vec6 largest_correction_ = Vec6::Zero();

  PosePlan plan_;
  Pursuit pursuit_;
  bool pursuing_ = false;
  double moving_s_ = 0.0;  ///< since when the target moves without jumps
  bool waiting_ = false;   ///< a new target was perceived; the movement starts at waiting_until_s_
  double waiting_until_s_ = 0.0;
  bool seen_ = false;
  Stimulus picture_;
  double begin_s_ = 0.0;
  Vec6 correction_ = Vec6::Zero();  ///< integral of the seen error [N, N m]
  Vec6 error_ = Vec6::Zero();       ///< seen last [m, rad], world axes
};

}  // namespace isograsp::virtual_patient
