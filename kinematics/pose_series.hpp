// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of named frames over time, and of the links between them. Times in s, poses in the world W
// of the cameras (of a left arm: its reflection); a missing pose is missing_pose().
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "kinematics/rig.hpp"

namespace isograsp {

struct PoseSeries {
  std::vector<double> t_s;             ///< strictly increasing
  std::vector<std::string> frames;     ///< names
  std::vector<std::vector<Pose>> X_W;  ///< [frame][row]
  std::string source;                  ///< the file, for errors

  [[nodiscard]] std::optional<std::size_t> frame(std::string_view name) const noexcept;
};

/// Times are sums of steps, each rounded: within this they are equal [s].
inline constexpr double kMarkerTimeSlack_s = 1e-9;
/// What may stand in for a missing pose [s].
inline constexpr double kLongestStandIn_s = 0.05;

/// Where the frame of a series stands; an error if there is none.
[[nodiscard]] Result<std::size_t> frame_of(const PoseSeries& series, const std::string& name);

/// X of the child in the parent, one for each row. Errors: a frame is not in the series.
[[nodiscard]] Result<std::vector<Pose>> link_poses(const PoseSeries& series,
                                                   const std::string& parent,
                                                   const std::string& child);

/// The attitude of a link from its zero: R R_zero^-1.
[[nodiscard]] inline Quat from_zero(const Quat& q, const std::optional<Quat>& zero) noexcept {
  return zero ? q * zero->conjugate() : q;
}
/// The three angles of a link [rad].
[[nodiscard]] inline Vec3 link_angles(const Quat& q, const RigLink& link) noexcept {
  return angles_of(from_zero(q, link.zero), link.sequence);
}

/// The next multiple of a whole turn nearest to `last`: a step is in (-pi, pi].
[[nodiscard]] double unwrapped(double angle, double last) noexcept;

}  // namespace isograsp
