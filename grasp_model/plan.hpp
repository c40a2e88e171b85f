// SPDX-License-Identifier: GPL-3.0-or-later
// A scene compiled to the cheapest exact model, and the step that moves the object.
// Plan: what is constant. ObjectState: what moves. step() is a function of (plan, wrenches, state).
// Frames: W world, O object, C contact. SI units.
#pragma once

#include <array>
#include <string>

#include "core/finger.hpp"
#include "core/result.hpp"
#include "core/spatial.hpp"
#include "grasp_model/rotation.hpp"
#include "grasp_model/scene.hpp"
#include "grasp_model/zoh.hpp"

namespace isograsp {

/// What moves.
struct ObjectState {
  Pose pose;                   ///< p_WO [m], q_WO; the sign of q is continuous in time
  Vec3 v_WO_W = Vec3::Zero();  ///< velocity of the COM, world axes [m/s]
  Vec3 w_WO_W = Vec3::Zero();  ///< angular velocity, world axes [rad/s]
  std::array<bool, kFingerCount> contact{};  ///< hysteresis: touching since the last frame
  double angle_rad = 0.0;                    ///< one free rotation: its angle, unwrapped
  /// The last hold was too stiff for the stated tolerance (docs/grasp_model.md): finite, not exact.
  bool tolerance_exceeded = false;
};

/// What the fingers do to the object during one hold.
struct GraspWrench {
  Wrench F_O_W;  ///< on the object about its COM, world axes, at the start of the hold
  std::array<bool, kFingerCount> contact{};
  std::array<double, kFingerCount>
      utilisation{};                      ///< |f_t| / (mu f_z) before the clamp; 0 no contact
  std::array<bool, kFingerCount> slip{};  ///< the clamp acted
};

/// The compiled model; see describe() in grasp_model/grasp.hpp for its printed form.
class Plan {
 public:
  /// Compiles for holds of `hold_s`. Refuses what the model cannot do exactly.
  [[nodiscard]] static Result<Plan> compile(const Scene& scene, double hold_s);

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] double hold_s() const noexcept { return hold_s_; }
  [[nodiscard]] ObjectState initial_state() const;

  /// Contact hysteresis, friction clamp and grasp map: the wrench that these finger wrenches
  /// produce from now on. Updates state.contact. Real-time safe.
  GraspWrench grasp(const FingerWrenches& wrench_C, ObjectState& state) const noexcept;

  /// Moves the object over one hold with the wrench constant as scene.wrench_frame says. Real-time
  /// safe.
  void move(const GraspWrench& wrench, ObjectState& state) const noexcept;
  /// The same for another hold [s]; recomputes the coefficients, so it costs more.
  void move(const GraspWrench& wrench, double hold_s, ObjectState& state) const noexcept;

  /// What was chosen for the rotations.
  enum class Rotations : std::uint8_t { none, one_axis, three };
  [[nodiscard]] Rotations rotations() const noexcept { return rotations_; }
  /// The force turns with the object while the object moves: translation by quadrature.
  [[nodiscard]] bool force_follows() const noexcept { return force_follows_; }
  /// Substeps of a hold at rest; 0: closed form without substeps.
  [[nodiscard]] int substeps() const noexcept;
  /// Whether the fingers of `mask` (bit f = finger f) move the object under the scene's grasp rule.
  [[nodiscard]] bool acts(unsigned mask) const noexcept { return acts_[mask]; }

 private:
  /// Everything that depends on the length of the hold.
  struct Coefficients {
    double hold_s = 0.0;
    std::array<LinearStep, 3> linear;
    LinearStep turn;
  };
  struct Panel;

  Plan() = default;
  [[nodiscard]] Coefficients coefficients(double hold_s) const noexcept;
  void move(const Coefficients& steps, const GraspWrench& wrench,
            ObjectState& state) const noexcept;
  void move_along_axes(const Coefficients& steps, const Vec3& force_W,
                       ObjectState& state) const noexcept;
  [[nodiscard]] Motion turn_about_axis(const LinearStep& step, double hold_s, double torque,
                                       const Motion& start) const noexcept;
  void turn_freely(double hold_s, const Wrench& F_O_W, ObjectState& state) const noexcept;
  void follow_about_axis(double hold_s, const Wrench& F_O_W, ObjectState& state) const noexcept;
  void push_over(const Panel& panel, ObjectState& state) const noexcept;
  void set_turn(const Motion& turn, ObjectState& state) const noexcept;
  [[nodiscard]] double linear_rate() const noexcept;

  Scene scene_;
  double hold_s_ = 0.0;
  Rotations rotations_ = Rotations::none;
  Eigen::Index axis_ = 2;  ///< of the one free rotation
  bool force_follows_ = false;
  double branch_ = 1.0;  ///< q of the spring's branch = branch_ * pose.q_WO
  std::array<Oscillator, 3> linear_{};
  Oscillator turn_;
  so3::Body body_;
  Vec3 weight_W_ = Vec3::Zero();  ///< mass times gravity [N]
  std::array<bool, 6> limited_{};
  std::array<Travel, 6> travel_{};  ///< world position [m] or angle [rad]
  std::array<bool, 8> acts_{};
  Coefficients steps_;
};

}  // namespace isograsp
