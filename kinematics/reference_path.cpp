// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/reference_path.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp {

namespace {

double least_jerk_share(double u) noexcept {
  return u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
}

Quat rotation_by(const Vec3& turn) noexcept {
  const double angle_rad = turn.norm();
  if (!(angle_rad > 0.0)) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(angle_rad, turn / angle_rad));
}

}  // namespace

ReferencePath::ReferencePath(const Postures& library, std::span<const std::size_t> round,
                             const StartPosture& start, SizeScale scale, double leg_s)
    : leg_s_(leg_s),
      links_(library.postures.front().X_L.size()),
      legs_(round.size()),
      X_W_(start.X_W) {
  const Posture& initial = library.postures.front();
  for (std::size_t l = 0; l < links_; ++l) X_L_.push_back({start.X_L[l].p, initial.X_L[l].q});
  const auto change = [&](std::size_t posture, std::size_t l) {
    return change_of_link(library, posture, l, start, scale);
  };
  for (std::size_t k = 0; k < legs_; ++k)
    for (std::size_t l = 0; l < links_; ++l) {
      const Pose from = change(round[k], l);
      const Pose to = change(round[(k + 1) % legs_], l);
      changes_.push_back({from, to.p - from.p, rotation_vector(from.q.conjugate() * to.q)});
    }
}

int ReferencePath::leg(double t_s) const noexcept {
  return static_cast<int>(std::floor(std::max(0.0, t_s) / leg_s_));
}

Pose ReferencePath::at(double t_s) const noexcept {
  const double legs = std::max(0.0, t_s) / leg_s_;
  const double over = std::floor(legs);
  const double s = least_jerk_share(legs - over);
  const auto k = static_cast<std::size_t>(std::fmod(over, static_cast<double>(legs_)));
  Pose X_WO = X_W_;
  for (std::size_t l = 0; l < links_; ++l) {
    const Change& change = changes_[k * links_ + l];
    X_WO = compose(compose(X_WO, X_L_[l]),
                   {change.from.p + s * change.way, change.from.q * rotation_by(s * change.turn)});
  }
  X_WO.q.normalize();
  return X_WO;
}

}  // namespace isograsp
