// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/point_force.hpp"

#include <algorithm>

namespace isograsp::bimanual {

PointForce force_at(const PadPoint& point, const PointState& state, double friction, double step_s,
                    const Vec3& slip) {
  PointForce force;
  const double closing = point.normal.dot(slip);
  const double depth_m = state.at_rest_m + step_s * closing;
  if (!(depth_m > 0.0)) return force;
  force.normal_N = state.stiffness_N_m * depth_m;
  force.limit_N = friction * force.normal_N;
  force.asked_N = state.held_N + state.firm * (slip - closing * point.normal);
  const double asked = force.asked_N.norm();
  force.slides = asked > force.limit_N;
  force.friction_N = force.slides ? Vec3(force.limit_N / asked * force.asked_N) : force.asked_N;
  return force;
}

Mat3 hardness_at(const PadPoint& point, const PointState& state, double friction, double step_s,
                 const PointForce& force) {
  const double bed = step_s * state.stiffness_N_m;
  const Vec3& n = point.normal;
  const Mat3 across = Mat3::Identity() - n * n.transpose();
  if (!force.slides) return state.firm * across + bed * n * n.transpose();
  const double asked = force.asked_N.norm();
  const Vec3 way = force.asked_N / asked;
  const double most_N = std::max(force.limit_N, state.foreseen_N.norm());
  const Vec3 foreseen = most_N > 0.0 ? Vec3(state.foreseen_N / most_N) : Vec3::Zero();
  const Mat3 turned = 0.5 * (foreseen * way.transpose() + way * foreseen.transpose());
  return force.limit_N * state.firm / asked * (across - turned) +
         bed * (n + friction * way) * n.transpose();
}

}  // namespace isograsp::bimanual
