// SPDX-License-Identifier: GPL-3.0-or-later
// The grasp map G and the hand's Jacobian of a few soft contacts, and their singular values
// (docs/virtual_hand.md, "Criteria"). Fixed sizes, without allocation: real-time safe. SI units.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include <Eigen/Core>

#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::virtual_hand {

/// One contact. Its force coordinates: three forces along the columns of R_OC, torque about the
/// normal.
struct ContactMaps {
  Digit digit = Digit::thumb;
  double distance2_m2 = 0.0;  ///< from the centre of the object, squared
  /// Wrench on the object, object axes, of a unit of each coordinate.
  Eigen::Matrix<double, 6, 4> G;
  /// Rates of the digit's angles to the velocities that belong to the coordinates. The palm does
  /// not count: it moves any object.
  Eigen::Matrix4d J;
};
/// Without a hand, whose J is zero.
[[nodiscard]] ContactMaps contact_maps(const DigitContact& contact) noexcept;
[[nodiscard]] ContactMaps contact_maps(const DigitContact& contact, const HandInSpace& hand,
                                       const Pose& X_WO) noexcept;

/// Some contacts of different digits.
struct ContactSet {
  static constexpr std::size_t kMost = kDigitCount;
  std::array<const ContactMaps*, kMost> contacts{};
  std::size_t count = 0;

  [[nodiscard]] DigitSet digits() const noexcept;
  /// rms distance of the contacts from the centre of the object; 1 if that is 0 [m].
  [[nodiscard]] double length_m() const noexcept;
};

/// Lengths that take the units out of both maps; all 1: SI.
struct MapScales {
  double torque_m = 1.0;   ///< of torques on the object
  double torsion_m = 1.0;  ///< of torque about a normal
  double hand_m = 1.0;     ///< of motions of the hand
};

/// Singular values of a matrix of six columns with as many rows as R, the factor of its QR
/// decomposition.
[[nodiscard]] SixValues six_values(const Eigen::Matrix<double, 6, 6>& R) noexcept;

/// What is left of both maps after orthogonal transformations: R of G^T, and of H^T. All zero: the
/// contacts cannot hold every wrench.
struct SetFactors {
  SixValues G;
  Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
  /// Product of the singular values of H.
  [[nodiscard]] double H_det() const noexcept { return std::abs(H.diagonal().prod()); }
};
/// @pre two or three contacts
[[nodiscard]] SetFactors factors_of(const ContactSet& set, const MapScales& scales) noexcept;

/// The contacts can press, strictly inside their friction cones (ellipsoids), without a resulting
/// wrench. Each answer rests on a certificate: such forces, or a wrench that no contact resists; if
/// neither is found, which happens only at the threshold or where the contacts cannot hold every
/// wrench in any case, the answer is no. @pre friction.friction > 0
[[nodiscard]] bool closes(const ContactSet& set, const PadFriction& friction) noexcept;

}  // namespace isograsp::virtual_hand
