// SPDX-License-Identifier: GPL-3.0-or-later
// A scene compiled to the cheapest exact model, and the step that moves the object.
// Plan: what is constant. ObjectState: what moves. A step is a function of (plan, forces, state).
// Frames: W world, O object, C contact. SI units.
#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "grasp_model/contact.hpp"
#include "grasp_model/coupled.hpp"
#include "grasp_model/follow.hpp"
#include "grasp_model/free_turn.hpp"
#include "grasp_model/plan_lanes.hpp"
#include "grasp_model/rotation.hpp"
#include "grasp_model/scene.hpp"
#include "grasp_model/spin.hpp"
#include "grasp_model/travel.hpp"
#include "grasp_model/zoh.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What moves.
struct ObjectState {
  Pose X_WO;                                 ///< the sign of the quaternion is continuous in time
  Vec3 v_WO_W = Vec3::Zero();                ///< velocity of the COM, world axes [m/s]
  Vec3 w_WO_W = Vec3::Zero();                ///< angular velocity, world axes [rad/s]
  std::array<bool, kFingerCount> contact{};  ///< hysteresis: touching since the last frame
  double angle_rad = 0.0;                    ///< one free rotation: its angle, unwrapped
  /// Three free rotations: estimated error of the attitude made in the last hold [rad].
  double error_rad = 0.0;
  /// The estimate is above the scene's tolerance, or the motion was too stiff to resolve: the state
  /// is finite but not exact (docs/grasp_model.md).
  bool tolerance_exceeded = false;
  /// Three free rotations: how the last hold was taken, and how the next begins. n >= 0: 2^n steps
  /// of order 8; -1: one of order 5; -2: one of order 3.
  int level = 0;
};

/// What the fingers do to the object during one hold.
struct GraspWrench {
  Wrench F_O_W;  ///< on the object about its COM, world axes, at the start of the hold
  /// The same as it stays constant during the hold: in world axes, or in object axes
  /// (wrench_frame = "object").
  Wrench held;
  std::array<bool, kFingerCount> contact{};
  std::array<double, kFingerCount>
      utilisation{};                         ///< |f_t| / (mu f_z) before the clamp; 0 no contact
  std::array<bool, kFingerCount> slip{};     ///< the clamp acted
  std::array<bool, kFingerCount> invalid{};  ///< not finite: had no part in the wrench
};

/// The compiled model; see words_of() in grasp_model/plan_words.hpp for its printed form.
class Plan {
 public:
  /// Compiles for holds of `hold_s`. Refuses what the model cannot do exactly.
  [[nodiscard]] static Result<Plan> compile(const Scene& scene, double hold_s);

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] double hold_s() const noexcept { return hold_s_; }
  [[nodiscard]] ObjectState initial_state() const;
  /// At rest at `X_WO` in the free degrees of freedom; the locked ones stay as they began. A single
  /// free rotation gets its angle within half a turn. Real-time safe.
  [[nodiscard]] ObjectState at_rest(const Pose& X_WO) const noexcept;

  /// One hold, from finger forces to the object's new state: contact hysteresis, friction clamp,
  /// the rows of the grasp map that move something, the exact step. Real-time safe.
  void step(const FingerWrenches& wrench_C, ObjectState& state) const noexcept;
  /// The same as on a processor without AVX2: the same bits, which tests hold it to.
  void step_narrow(const FingerWrenches& wrench_C, ObjectState& state) const noexcept;

  /// The same in two halves with all that is worth recording, bit for bit the same motion.
  /// First the wrench that these forces produce from now on; updates state.contact. Real-time safe.
  GraspWrench grasp(const FingerWrenches& wrench_C, ObjectState& state) const noexcept;
  /// Then the motion over one hold; of the wrench only `held` counts. Real-time safe.
  void move(const GraspWrench& wrench, ObjectState& state) const noexcept;
  /// The same for another hold [s]; computes the coefficients anew, so it costs more. Real-time
  /// safe unless coupled().
  void move(const GraspWrench& wrench, double hold_s, ObjectState& state) const;

  enum class Rotations : std::uint8_t { none, one_axis, three };
  [[nodiscard]] Rotations rotations() const noexcept { return rotations_; }
  /// The force turns with the object while the object moves.
  [[nodiscard]] bool force_follows() const noexcept { return force_follows_; }
  /// Translations are coupled by springs or dampers whose axes are not those of the world.
  [[nodiscard]] bool coupled() const noexcept { return coupled_; }
  [[nodiscard]] const so3::Body& body() const noexcept { return rate_.body(); }
  /// Three free rotations: the level (ObjectState::level) that the scene's tolerance, springs,
  /// dampers and first speed make likely, and the coarsest that a hold may take.
  [[nodiscard]] int likely_level() const noexcept { return likely_level_; }
  [[nodiscard]] int coarsest_level() const noexcept { return coarsest_level_; }
  /// Whether the fingers of `mask` (bit f = finger f) move the object under the scene's grasp rule.
  [[nodiscard]] bool acts(unsigned mask) const noexcept { return acts_[mask]; }

 private:
  /// A contact ready for use, in the order of fingers. Columns of the grasp map for f_x f_y f_z
  /// t_z: all six rows, and only the rows that move something, packed.
  using Columns = Eigen::Matrix<double, 6, 4>;
  struct Pressing {
    std::size_t finger = 0;
    unsigned bit = 0;
    TouchRule rule;
    FrictionLimit limit;
    Columns all = Columns::Zero();
    Columns moving = Columns::Zero();
  };
  /// Everything that depends on the length of the hold.
  struct Coefficients {
    double hold_s = 0.0;
    std::array<LinearStep, 3> linear;
    LinearStep turn;
    CoupledStep coupled;
  };

  Plan() = default;
  void compile_contacts();
  void compile_levels();
  [[nodiscard]] Coefficients coefficients(double hold_s) const;
  template <class Use>
  unsigned touch(const FingerWrenches& wrench_C, ObjectState& state, const Use& use) const noexcept;
  void compile_lanes();
  friend struct LaneKernels;  // axes that move independently: plan_lanes.cpp
  friend struct BatchTerms;   // many states at once: batch/batch.cpp
  void step_any(const FingerWrenches& wrench_C, ObjectState& state) const noexcept;
  [[nodiscard]] std::array<double, 6> rows_of(const Wrench& held) const noexcept;
  // `rows`: what stays constant during the hold, as GraspWrench::held, packed as rows_.
  void move(const Coefficients& steps, const double* rows, ObjectState& state) const noexcept;
  void move_along_axes(const Coefficients& steps, const double* rows,
                       ObjectState& state) const noexcept;
  void move_coupled(const CoupledStep& step, const double* rows, ObjectState& state) const noexcept;
  [[nodiscard]] Motion turn_about_axis(const LinearStep& step, double hold_s, double torque,
                                       const Motion& start) const noexcept;
  void set_turn(const Motion& turn, ObjectState& state) const noexcept {
    state.angle_rad = turn.x;
    state.w_WO_W[axis_] = turn.v;
    set_attitude(turn.x, state);
  }
  [[gnu::always_inline]] void set_attitude(double angle_rad, ObjectState& state) const noexcept {
    if (!(std::abs(angle_rad) <= so3::kNear_rad)) return set_far_attitude(angle_rad, state);
    const Eigen::Array2d q =
        so3::half_turn(angle_rad) * Eigen::Array2d(branch_, branch_ * angle_rad);
    state.X_WO.q.w() = q[0];
    state.X_WO.q.vec()[axis_] = q[1];
  }
  void set_far_attitude(double angle_rad, ObjectState& state) const noexcept;
  /// Three free rotations, or a force that follows one.
  void turn(const Coefficients& steps, const double* rows, ObjectState& state) const noexcept;
  [[nodiscard]] FreeTurn::Terms turn_terms(double hold_s) const noexcept;
  void turn_freely(double hold_s, const Wrench& held, ObjectState& state) const noexcept;
  void follow_about_axis(const Coefficients& steps, const Vec6& held,
                         ObjectState& state) const noexcept;
  /// Translations over one panel of a force that turns; `between(from, to)` gives the forces of a
  /// part of it, which are needed if a travel limit is met inside.
  template <class Between>
  void push_over(const Follower& follower, const QuadraturePanel& panel, const PanelForces& forces,
                 const Between& between, ObjectState& state) const noexcept;

  // What every frame reads comes first.
  std::array<Pressing, kFingerCount> pressing_{};
  std::size_t contacts_ = 0;
  bool torsion_ = false;  ///< of some contact
  std::array<bool, 8> acts_{};
  std::array<Eigen::Index, 6> rows_{};  ///< degrees of freedom of the packed rows
  std::size_t row_count_ = 0;
  std::array<Eigen::Index, 3> axes_{};  ///< free translations
  std::size_t axis_count_ = 0;
  Rotations rotations_ = Rotations::none;
  bool force_follows_ = false;
  bool coupled_ = false;
  Eigen::Index axis_ = 2;  ///< of the one free rotation
  double branch_ = 1.0;    ///< q of the spring's branch = branch_ * pose.q
  double hold_s_ = 0.0;
  Vec3 anchor_m_ = Vec3::Zero();
  Vec3 weight_W_ = Vec3::Zero();  ///< mass times gravity [N]
  std::array<bool, 6> limited_{};
  std::array<Travel, 6> travel_{};  ///< world position [m] or angle [rad]
  Coefficients steps_;
  PlanLanes lanes_;

  FreeAxes linear_;
  CoupledAxes coupling_;
  Oscillator turn_;
  so3::SpinRate rate_;
  int likely_level_ = 0;
  int coarsest_level_ = 0;
  std::array<Follower, 3> followers_;  ///< by so3::Order; about one axis the last
  Scene scene_;
};

}  // namespace isograsp
