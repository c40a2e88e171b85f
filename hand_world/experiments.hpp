// SPDX-License-Identifier: GPL-3.0-or-later
// Two experiments whose results are known in closed form or to many digits: a cuboid between two
// pads, and a disk that slides and turns to rest on a table (docs/virtual_hand.md). SI units.
#pragma once

#include "hand_world/world.hpp"

namespace isograsp::hand_world {

/// A cuboid of 20 x 20 x 150 mm hangs between two pads that press with constant force beside its
/// centre.
struct Squeeze {
  double mass_kg = 0.0;
  double gravity_m_s2 = 9.81;
  virtual_hand::PadFriction pad;
  double offset_m = 0.0;  ///< of the pads from the centre, along the cuboid
  double force_N = 0.0;   ///< of each pad
  double duration_s = 1.0;
  double step_s = 0.001;
};
struct SqueezeResult {
  double slip_m = 0.0;    ///< way of what lay between the pads
  double turn_rad = 0.0;  ///< of the cuboid
};
/// Ends early if the cuboid has left the pads.
[[nodiscard]] SqueezeResult squeeze(const Squeeze& setup) noexcept;

/// A flat disk of uniform pressure on a level table.
struct Slide {
  double friction = 0.0;
  double gravity_m_s2 = 9.81;
  double radius_m = 0.0;
  double v0_m_s = 0.0;
  double w0_rad_s = 0.0;
  double step_s = 0.001;
};
struct SlideResult {
  double stop_s = 0.0;
  double distance_m = 0.0;
  double angle_rad = 0.0;
  double last_slip = 0.0;  ///< v / (w R) where a thousandth of its speed was left
  bool stopped = false;    ///< within kLongest_s
};
inline constexpr double kLongest_s = 60.0;
[[nodiscard]] SlideResult slide(const Slide& setup) noexcept;

}  // namespace isograsp::hand_world
