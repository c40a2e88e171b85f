// SPDX-License-Identifier: GPL-3.0-or-later
// A rigid body seen by its markers: the pose that brings the template, points of the body in its
// own frame B, nearest to the positions seen in the world W. Positions in m.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/spatial.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp {

/// What became of a frame in one row.
enum class FrameState : std::uint8_t {
  ok,
  rejected,   ///< a pose without one marker that stood astray
  few,        ///< fewer than three markers seen
  collinear,  ///< what is seen lies on a line: no attitude
  residual,   ///< the markers do not fit the body
  missing     ///< a marker, landmark or frame that it is made of is not there
};
[[nodiscard]] constexpr bool has_pose(FrameState state) noexcept {
  return state <= FrameState::rejected;
}

struct BodyFit {
  FrameState state = FrameState::few;
  int used = 0;                         ///< markers in the fit; without a pose: those seen
  std::optional<std::size_t> rejected;  ///< which marker was left out
  double residual_m = kMissing;         ///< root mean square; missing where nothing was fitted
  Pose X_WB = missing_pose();
};

class RigidBody {
 public:
  /// A body with more markers is refused where it is read.
  static constexpr std::size_t kMostMarkers = 64;

  /// @pre at most kMostMarkers finite points, max_residual_m > 0
  RigidBody(std::vector<Vec3> template_m, double max_residual_m);

  [[nodiscard]] std::size_t markers() const noexcept { return template_m_.size(); }
  /// `p_W`: as many positions as markers, missing ones NaN. Real-time: nothing is allocated.
  [[nodiscard]] BodyFit fit(std::span<const Vec3> p_W) const noexcept;

 private:
  std::vector<Vec3> template_m_;
  double max_residual_m_;
  bool all_on_a_line_ = false;  ///< the points of the whole body: nearly always all are seen
};

}  // namespace isograsp
