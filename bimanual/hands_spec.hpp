// SPDX-License-Identifier: GPL-3.0-or-later
// How two hands that press on platforms become two points in a scene (docs/bimanual.md; Talvas et
// al.: double bubble, magnetic pinch, joint control). SI units, world axes unless said otherwise.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>

#include "bimanual/pads/side.hpp"
#include "core/spatial.hpp"

namespace isograsp::bimanual {

/// How far a hand reaches without moving its bubble, and beyond what force it moves.
enum class BubbleShape : std::uint8_t { ellipsoid, box, superellipsoid };

enum class Explore : std::uint8_t {
  bubble,     ///< pressed beyond its edge the bubble moves
  clutch,     ///< while a clutch is held the hand is let go and the bubble follows
  fixed,      ///< bubbles stay
  prescribed  ///< the points are given
};

struct HandSpec {
  Vec3 center_m = Vec3::Zero();         ///< of the bubble, at first
  Vec3 force_at_edge_N = Vec3::Ones();  ///< each axis of the view
};

struct HandsSpec {
  Explore explore = Explore::bubble;
  Vec3 half_size_m = Vec3::Constant(0.05);  ///< of both bubbles
  BubbleShape shape = BubbleShape::ellipsoid;
  double exponent = 4.0;  ///< of a superellipsoid
  double rate_m_s = 0.1;  ///< for an excess of 1
  double rate_exponent = 1.0;
  double rate_limit_m_s = 0.25;
  double separation_m = 0.02;             ///< that the hands keep, along the line of the bubbles
  double least_bubble_distance_m = 0.08;  ///< horizontal
  bool joint_control = false;             ///< bubbles move as one while the object is held
  double left_share = 0.5;                ///< of the left hand in that
  double view_fov_rad = 40.0 * std::numbers::pi / 180.0;
  double view_margin = 1.1;
  std::array<HandSpec, kSides> hands;
};

/// When two hands hold the object.
struct GraspDetection {
  /// Each hand squeezes more than its own; half of it lets go.
  std::array<double, kSides> force_on_N{1.0, 1.0};
  double reach_m = 0.01;        ///< from a hand to the object
  double least_chord_m = 0.03;  ///< of the line of the hands in the object
};

/// What holds the object between the hands.
struct Magnet {
  enum class Mode : std::uint8_t { off, spring, constraint };
  Mode mode = Mode::off;
  double stiffness_N_m = 0.0;  ///< of each hand
  double damping_N_s_m = 0.0;
};

}  // namespace isograsp::bimanual
