// SPDX-License-Identifier: GPL-3.0-or-later
// Four objects side by side (batch.hpp): what moves, and what their plans have of it. Inside
// grasp_model/batch/ only.
#pragma once

#include <array>
#include <cstddef>

#include "grasp_model/batch/spin_bodies.hpp"
#include "grasp_model/free_turn.hpp"
#include "grasp_model/lanes.hpp"
#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What moves of four objects, an object a lane; as ObjectState.
struct alignas(32) BatchBlock {
  std::array<Four, 4> q{};  ///< w x y z
  std::array<Four, 3> p{}, v{}, w{};
  Four angle{};
  std::array<LaneMask, kFingerCount> contact{};
  std::array<double, kLaneCount> error_rad{};
  std::array<int, kLaneCount> level{};
  std::array<bool, kLaneCount> exceeded{};
  std::size_t terms = 0;  ///< which of Batch

  [[nodiscard]] ObjectState get(std::size_t lane) const noexcept;
  void set(std::size_t lane, const ObjectState& state) noexcept;
};

/// What four plans have of their objects' motion, a plan a lane.
struct alignas(32) BatchTerms {  // a vector asks alignof, which says 16 where there is no AVX
  using Plans = std::array<const Plan*, kLaneCount>;
  using Rows = std::array<const FingerWrenches*, kLaneCount>;

  explicit BatchTerms(const Plans& of);

  Plans plans;
  bool side_by_side = false;  ///< else nothing below counts, and each object moves by itself
  // Fingers: as PlanLanes, by finger.
  std::array<Four, kFingerCount> friction, touches_above, stays_above, presses_above;
  std::array<std::array<bool, 8>, kLaneCount> acts{};  ///< by plan and set of fingers
  /// Of f_x f_y f_z of each finger, by row of the grasp map.
  std::array<std::array<std::array<Four, 3>, kFingerCount>, 6> columns;
  // Axes: the free translations in their order, behind them the one free rotation.
  std::array<std::size_t, 3> axes{};  ///< of the translations
  std::size_t turn_axis = 0;
  Four branch;
  std::array<Four, 4> weight, anchor, force_share, position_share, x_of_v, x_of_off, v_of_v,
      v_of_off;
  std::array<LaneMask, 4> about_rest;
  bool some_about_rest = false;
  // Three free rotations.
  bool spins = false;
  std::array<so3::SpinRate, kLaneCount> rate;
  std::array<FreeTurn::Terms, kLaneCount> turn_terms;
  so3::BodyRates rates;
  Four hold_s, tolerance_rad;
  LaneMask world, watched;
  bool some_watched = false;
  bool some_pushed = false;  ///< FreeTurn::Terms::pushed_rate
  double stable_rad = 0.0;   ///< up to this turn of the fastest rate each keeps its coarsest level
  /// Of SpinRate::fastest(): least torque that a speed costs, and the rate of spring and damper.
  Four resisting, own_rate;
  /// All but three free rotations: these get their torque. False: some object needs the long way,
  /// and nothing has changed.
  using Press = bool(const BatchTerms&, const Rows&, BatchBlock&,
                     std::array<Four, 3>& torque) noexcept;
  /// Of these plans, on this processor and on one without wide registers.
  Press* press = nullptr;
  Press* narrow = nullptr;

 private:
  static bool stands_alone(const Plan& plan) noexcept;
  static bool alike(const Plan& a, const Plan& b) noexcept;
  void choose_press(std::size_t translations,
                    Plan::Rotations rotations) noexcept;  // batch_press.cpp
  void take_fingers(const Plan& plan, std::size_t lane);
  void take_axes(const Plan& plan, std::size_t lane, std::size_t count);
  void take_rates(const Plan& plan, std::size_t lane);
};

/// One hold of four objects that turn freely under these torques. Real-time safe.
void spin_block(const BatchTerms& terms, const std::array<Four, 3>& torque, BatchBlock& block,
                bool narrow) noexcept;
/// One hold of four objects. `narrow`: without the wide registers of this processor. Real-time
/// safe.
void step_block(const BatchTerms& terms, const BatchTerms::Rows& wrench_C, BatchBlock& block,
                bool narrow) noexcept;

}  // namespace isograsp
