// SPDX-License-Identifier: GPL-3.0-or-later
// Four things that two hands hold with soft pads, as Talvas et al. (aggregate constraints, scenes)
// name them; sizes, masses and movements are ours (docs/bimanual.md, "Four scenes"). A scene has
// two or four pads, of as many points as are asked for. SI units.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "bimanual/pads/held_by_pads.hpp"
#include "core/result.hpp"

namespace isograsp::bimanual {

enum class PadScene : std::uint8_t { ball, dumbbell, pencil, edge };
inline constexpr std::array<std::string_view, 4> kPadSceneNames{"ball", "dumbbell", "pencil",
                                                                "edge"};

/// Both hands close on the object within kClosing_s, with gravity growing alongside, and hold it
/// still until kMoving_s; then they lead it away, ever faster.
struct PadGrasp {
  static constexpr double kClosing_s = 0.05;
  static constexpr double kMoving_s = 0.1;

  Scene object;
  std::vector<PadSpec> pads;
  double step_s = 1e-3;
  Vec3 hand_m = Vec3::Zero();     ///< where the right one begins; the left is its mirror image in x
  double squeeze_m = 0.0;         ///< by which each closes
  Vec3 pull_m_s2 = Vec3::Zero();  ///< then
  double turn_rad_s2 = 0.0;       ///< then, about the line between the hands

  [[nodiscard]] std::array<Pose, kSides> proxies(double t_s) const noexcept;
  [[nodiscard]] Vec3 gravity_m_s2(double t_s) const noexcept;
};

/// @param points of all pads together. Errors (field "points"): they cannot be shared alike.
[[nodiscard]] Result<PadGrasp> pad_grasp(PadScene scene, int points);

/// The step at 0.2 s, after steps by `aggregate`: what is timed.
[[nodiscard]] PadStep step_under_way(const PadGrasp& grasp);

}  // namespace isograsp::bimanual
