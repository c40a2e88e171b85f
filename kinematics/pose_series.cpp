// SPDX-License-Identifier: GPL-3.0-or-later
// X_PC = X_WP^-1 X_WC
#include "kinematics/pose_series.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp {

std::optional<std::size_t> PoseSeries::frame(std::string_view name) const noexcept {
  const auto at = std::find(frames.begin(), frames.end(), name);
  if (at == frames.end()) return std::nullopt;
  return static_cast<std::size_t>(at - frames.begin());
}

Result<std::size_t> frame_of(const PoseSeries& series, const std::string& name) {
  if (const auto at = series.frame(name)) return *at;
  return refused("has no frame '%1'"_text(name), "give poses that have it"_text).at(series.source);
}

Result<std::vector<Pose>> link_poses(const PoseSeries& series, const std::string& parent,
                                     const std::string& child) {
  const auto inner = frame_of(series, child);
  if (!inner) return inner.error();
  std::vector<Pose> poses = series.X_W[*inner];
  if (parent == kWorld) return poses;
  const auto outer = frame_of(series, parent);
  if (!outer) return outer.error();
  for (std::size_t row = 0; row < poses.size(); ++row) {
    const Pose& X_WP = series.X_W[*outer][row];
    poses[row] = is_missing(X_WP) || is_missing(poses[row]) ? missing_pose()
                                                            : compose(inverse(X_WP), poses[row]);
  }
  return poses;
}

double unwrapped(double angle, double last) noexcept {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  double step = std::remainder(angle - last, kTurn);
  if (step <= -std::numbers::pi) step += kTurn;
  return last + step;
}

}  // namespace isograsp
