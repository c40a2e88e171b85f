// SPDX-License-Identifier: GPL-3.0-or-later
// When a grasp of a hand is feasible: how well its contacts hold the object (grasp map G) and how
// well its joints move it (H = (G^T)^+ J_h), in numbers without units (Delrieu et al., criteria;
// which of them count and why they are scaled: docs/virtual_hand.md). SI units.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "virtual_hand/hand_pose.hpp"

namespace isograsp::virtual_hand {

/// Where a digit touches the object.
struct DigitContact {
  Digit digit = Digit::thumb;
  std::size_t link = kLinkCount - 1;
  Vec3 p_OC = Vec3::Zero();      ///< [m]
  Mat3 R_OC = Mat3::Identity();  ///< columns: tangents, then the normal into the object
};

/// What friction gives all contacts.
struct PadFriction {
  double friction = 0.8;          ///< mu
  double patch_radius_m = 0.005;  ///< R of a disk with uniform pressure
  /// Torsional limit over tangential limit [m].
  [[nodiscard]] double torsion_m() const noexcept { return 2.0 / 3.0 * patch_radius_m; }
};

/// Digits of a set, bit d for digit d.
using DigitSet = unsigned;
[[nodiscard]] std::vector<Digit> digits_of(DigitSet set);
/// "thumb+index"; empty for none.
[[nodiscard]] std::string name_of(DigitSet set);

/// Singular values (six, descending) and what is read from them: least and product.
struct SixValues {
  std::array<double, 6> values{};
  double least = 0.0;
  double product = 0.0;
};

/// What the algebra says of two or three contacts.
struct GraspCriteria {
  DigitSet digits = 0;
  double length_scale_m = 0.0;  ///< of torques: rms distance of the contacts from the COM
  /// Scaled; least and product are 0 where the contacts cannot hold every wrench.
  SixValues G;
  SixValues H;
  /// The same in SI units, as in the source.
  SixValues G_raw;
  SixValues H_raw;
  bool force_closure = false;  ///< exact, within the friction cones
};

/// @pre two or three contacts of different digits. `hand_scale_m`: links of the index added.
[[nodiscard]] GraspCriteria grasp_criteria(std::span<const DigitContact> contacts,
                                           const HandInSpace& hand, const Pose& X_WO,
                                           double hand_scale_m, const PadFriction& friction);

/// Sum of the links of the index [m].
[[nodiscard]] double hand_scale_m(const HandModel& hand) noexcept;

/// All sets of two and three of the digits that touch, pairs first, in the order of the digits.
[[nodiscard]] std::vector<GraspCriteria> criteria_of_sets(std::span<const DigitContact> contacts,
                                                          const HandInSpace& hand, const Pose& X_WO,
                                                          double hand_scale_m,
                                                          const PadFriction& friction);

/// What the criteria must exceed; recomputed by `isograsp hand thresholds` for each object.
struct GraspLimits {
  double G_min_2 = 0.0;
  double H_min_2 = 0.0;
  double H_det_2 = 0.0;
  double G_min_3 = 0.0;
  double H_det_3 = 0.0;
  bool closure = true;  ///< force closure, too; false: the source alone
};
struct BestGrasp {
  DigitSet digits = 0;
  double product = 0.0;  ///< H_det G_min
};
/// Of the sets that the limits pass: triples if there are any, else pairs; the largest product, of
/// equal ones the first. Nothing: none is feasible.
[[nodiscard]] std::optional<BestGrasp> best_grasp(std::span<const GraspCriteria> sets,
                                                  const GraspLimits& limits);

/// The best grasp of the digits that touch, and how it stands against what it must exceed.
struct GraspChoice {
  DigitSet digits = 0;  ///< 0: fewer than two digits touch
  bool feasible =
      false;  ///< it is best_grasp(); else: of all sets the one with the largest product
  double G_min = 0.0;
  double H_min = 0.0;
  double H_det = 0.0;
  double G_min_limit = 0.0;
  double H_min_limit = 0.0;  ///< 0 of three digits: it does not count
  double H_det_limit = 0.0;
};
/// best_grasp() of all sets, asking for force closure only where the algebra passes: for a session,
/// when the contacts change. Real-time safe. @pre at most five contacts, of different digits
[[nodiscard]] GraspChoice feasible_grasp(std::span<const DigitContact> contacts,
                                         const HandInSpace& hand, const Pose& X_WO,
                                         double hand_scale_m, const PadFriction& friction,
                                         const GraspLimits& limits) noexcept;

/// Force closure of two to five contacts of different digits (closes() of contact_maps.hpp).
/// Real-time safe. @pre friction.friction > 0
[[nodiscard]] bool closes(std::span<const DigitContact> contacts,
                          const PadFriction& friction) noexcept;

}  // namespace isograsp::virtual_hand
