// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/point_force.hpp"

#include <algorithm>

namespace isograsp::bimanual {

PointForce force_at(const PointState& state, double friction, double step_s,
                    const PointSlip& slip) {
  PointForce force;
  const double depth_m = state.at_rest_m + step_s * slip.closing;
  if (!(depth_m > 0.0)) return force;
  force.normal_N = state.stiffness_N_m * depth_m;
  force.limit_N = friction * force.normal_N;
  force.asked_N = state.held_N + state.firm * slip.across;
  const double asked = force.asked_N.norm();
  force.slides = asked > force.limit_N;
  force.friction_N = force.slides ? Vec3(force.limit_N / asked * force.asked_N) : force.asked_N;
  return force;
}

Mat3 friction_hardness(const Vec3& normal, const PointState& state, const PointForce& force) {
  const Mat3 across = Mat3::Identity() - normal * normal.transpose();
  if (!force.slides) return state.firm * across;
  const double asked = force.asked_N.norm();
  const Vec3 way = force.asked_N / asked;
  const double most_N = std::max(force.limit_N, state.foreseen_N.norm());
  const Vec3 foreseen = most_N > 0.0 ? Vec3(state.foreseen_N / most_N) : Vec3::Zero();
  const Mat3 turned = 0.5 * (foreseen * way.transpose() + way * foreseen.transpose());
  return force.limit_N * state.firm / asked * (across - turned);
}

Vec3 friction_of_pressure(double friction, const PointForce& force) {
  if (!force.slides) return Vec3::Zero();
  return friction * Vec3(force.asked_N / force.asked_N.norm());
}

}  // namespace isograsp::bimanual
