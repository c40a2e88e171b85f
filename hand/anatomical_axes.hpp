// SPDX-License-Identifier: GPL-3.0-or-later
// Forces in the axes of the hand, so that a right hand and its mirror image give the same numbers.
// Derived in docs/conventions.md, "Axes of the hand". SI units.
#pragma once

#include "core/signals.hpp"
#include "hand/columns.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Axes of the hand. The thumb has the same axes: its own borders turn as it opposes.
enum class HandAxis : std::uint8_t {
  flexion,  ///< closing the grip, into the object; negative: extension, opening
  radial,   ///< towards the thumb's side of the hand; negative: ulnar
  distal    ///< away from the wrist; negative: proximal
};
inline constexpr std::array<HandAxis, 3> kHandAxes{HandAxis::flexion, HandAxis::radial,
                                                   HandAxis::distal};
[[nodiscard]] constexpr std::string_view name_of(HandAxis axis) noexcept {
  constexpr std::array<std::string_view, 3> kNames{"flexion", "radial", "distal"};
  return kNames[static_cast<std::size_t>(axis)];
}

/// Whether y of the finger's contact frame points away from the wrist (1) or towards it (-1).
[[nodiscard]] constexpr double distal_sign(Finger finger, Hand hand) noexcept {
  return (finger == Finger::thumb) == (hand == Hand::left) ? 1.0 : -1.0;
}

/// (flexion, radial, distal) [N] of a force in the finger's contact frame: (z, x, ±y).
/// Real-time safe. @pre the device stands as docs/conventions.md says
[[nodiscard]] Vec3 anatomical(const Vec3& force_C, Finger finger, Hand hand) noexcept;

/// "thumb_flexion_N"
[[nodiscard]] const Column& anatomical_column(Finger finger, HandAxis axis) noexcept;

/// Adds these columns of every finger of which thumb_fx_N, _fy_N and _fz_N … are there, and whose
/// new columns are not. A component is missing exactly where its own source is.
void add_anatomical_forces(Signals& signals, Hand hand);

}  // namespace isograsp
