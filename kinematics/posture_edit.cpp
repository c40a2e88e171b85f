// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/posture_edit.hpp"

#include <utility>

namespace isograsp {

namespace {

Vec3 unit_of(EditAxis axis) {
  return Vec3::Unit(static_cast<Eigen::Index>(axis));
}

}  // namespace

Pose turn_about(EditAxis axis, double angle_rad) {
  return {Vec3::Zero(), Quat(Eigen::AngleAxisd(angle_rad, unit_of(axis)))};
}

Pose shift_along(EditAxis axis, double way_m) {
  return {way_m * unit_of(axis), Quat::Identity()};
}

Posture with_link_changed(Posture posture, std::size_t l, const Pose& T, EditAxes axes) {
  Pose& X_L = posture.X_L[l];
  X_L = axes == EditAxes::own ? compose(X_L, T) : compose(T, X_L);
  X_L.q.normalize();
  return posture;
}

std::vector<LinkChange> changes_from(const Posture& initial, const Posture& posture) {
  std::vector<LinkChange> changes;
  for (std::size_t l = 0; l < posture.X_L.size(); ++l) {
    const Pose& from = initial.X_L[l];
    const Pose& to = posture.X_L[l];
    changes.push_back({angle_between(from.q, to.q), (to.p - from.p).norm()});
  }
  return changes;
}

}  // namespace isograsp
