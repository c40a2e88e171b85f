// SPDX-License-Identifier: GPL-3.0-or-later
// An object that two hands press with forces that were measured (coupling "force"): contacts,
// friction and the exact step are those of one hand (grasp_model/plan.hpp), for each hand; what
// both do adds up (docs/bimanual.md, "Measured forces"). SI units.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "bimanual/pads/side.hpp"
#include "core/result.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp::bimanual {

/// What one hand touches.
struct HandContacts {
  /// One contact that the net push of the whole hand loads, kept as that of the first finger; else
  /// at most one for each finger.
  bool whole = false;
  std::vector<Contact> contacts;
};

/// Wrenches of the contacts of each hand, contact frames [N, N m]; of a whole hand the first.
using HandWrenches = std::array<FingerWrenches, kSides>;

/// The net push of a hand (force [N], torque [N m], world axes) as its one contact takes it: in the
/// place of the first finger. @pre hand.whole. Real-time safe.
[[nodiscard]] FingerWrenches of_whole_hand(const HandContacts& hand, const Wrench& push_W) noexcept;

struct PressedState {
  ObjectState object;  ///< its `contact` means nothing: each hand has its own
  std::array<std::array<bool, kFingerCount>, kSides> touching{};  ///< hysteresis
};

/// What the hands do to the object during one hold.
struct PressedWrench {
  GraspWrench both;                      ///< `F_O_W` and `held`: the sum; the rest is of no finger
  std::array<GraspWrench, kSides> hand;  ///< of each; no force where the grasp rule refuses
};

class PressedByHands {
 public:
  /// Compiles for holds of `hold_s`. `object` has no contacts of its own; its grasp rule looks at
  /// those of both hands together. Refuses what the model cannot do exactly.
  [[nodiscard]] static Result<PressedByHands> compile(const Scene& object,
                                                      const std::array<HandContacts, kSides>& hands,
                                                      double hold_s);

  [[nodiscard]] const HandContacts& contacts_of(Side side) const noexcept {
    return contacts_[index_of(side)];
  }
  [[nodiscard]] PressedState initial_state() const { return {plans_.front().initial_state(), {}}; }

  /// Plan::at_rest() of the object. Real-time safe.
  [[nodiscard]] ObjectState at_rest(const Pose& X_WO) const noexcept {
    return plans_.front().at_rest(X_WO);
  }

  /// The wrench of these forces from now on; updates state.touching. Real-time safe.
  PressedWrench grasp(const HandWrenches& wrench_C, PressedState& state) const noexcept;
  /// The motion over one hold. Real-time safe.
  void move(const PressedWrench& wrench, PressedState& state) const noexcept {
    plans_.front().move(wrench.both, state.object);
  }
  /// The same for another hold [s]; computes coefficients anew. Real-time safe unless springs or
  /// dampers couple the axes.
  void move(const PressedWrench& wrench, double hold_s, PressedState& state) const {
    plans_.front().move(wrench.both, hold_s, state.object);
  }

 private:
  static constexpr std::size_t kMasks = std::size_t{1} << (kSides * kFingerCount);

  PressedByHands(std::vector<Plan> plans, const std::array<HandContacts, kSides>& contacts)
      : plans_(std::move(plans)), contacts_(contacts) {}

  std::vector<Plan> plans_;  ///< one for each hand: the same object, the contacts of the hand
  std::array<HandContacts, kSides> contacts_;
  std::array<bool, kMasks> acts_{};  ///< bit kFingerCount * side + finger: touches
};

}  // namespace isograsp::bimanual
