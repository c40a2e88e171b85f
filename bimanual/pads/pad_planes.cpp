// SPDX-License-Identifier: GPL-3.0-or-later
// Pads whose points rub in one plane each. The plane follows from the pressure at the end of the
// step; while Newton runs it stands, and is laid anew from where that has come.
#include <algorithm>
#include <cmath>

#include "bimanual/pads/pad_points.hpp"
#include "bimanual/pads/pad_rows.hpp"

namespace isograsp::bimanual {

/// Across the mean normal, through the centroid of pressure. Returns by how much it has moved: as
/// an angle, and its points over the size of the pad.
double PointSolver::lay_plane(const PadFace& spec, Face& face) const {
  const std::size_t count = spec.points.size();
  if (count == 0) return 0.0;
  face.arms.resize(count, Vec3::Zero());
  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero(), normal_of_all = Vec3::Zero(),
       middle_of_all = Vec3::Zero();
  double volume_m3 = 0.0, area_m2 = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const PadPoint& point = spec.points[i];
    const double depth_m = face.points[i].at_rest_m +
                           step_s_ * point.normal.dot(velocity_at(face.relative, point.p_pad));
    const double share_m3 = point.area_m2 * std::max(0.0, depth_m);
    volume_m3 += share_m3;
    normal += share_m3 * point.normal;
    middle += share_m3 * point.p_pad;
    area_m2 += point.area_m2;
    normal_of_all += point.area_m2 * point.normal;
    middle_of_all += point.area_m2 * point.p_pad;
  }
  if (!(volume_m3 > 0.0)) {  // nothing touches: where all would
    normal = normal_of_all;
    middle = middle_of_all;
    volume_m3 = area_m2;
  }
  if (!(normal.norm() > 0.0)) normal = spec.points.front().normal;
  normal.normalize();
  middle /= volume_m3;
  double moved = (normal - face.plane).norm(), size_m2 = 0.0, moved_m2 = 0.0;
  face.plane = normal;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 from_middle = spec.points[i].p_pad - middle;
    const Vec3 arm = middle + across(from_middle, normal);
    size_m2 = std::max(size_m2, from_middle.squaredNorm());
    moved_m2 = std::max(moved_m2, (arm - face.arms[i]).squaredNorm());
    face.arms[i] = arm;
  }
  if (size_m2 > 0.0) moved = std::max(moved, std::sqrt(moved_m2 / size_m2));
  return moved;
}

/// Of all pads; what is held stays in the plane.
double PointSolver::lay_planes(const PadStep& step) {
  double moved = 0.0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    moved = std::max(moved, lay_plane(step.faces[f], face));
    for (PointState& state : face.points)
      state.held_N = state.foreseen_N = across(state.held_N, face.plane);
  }
  return moved;
}

/// Wrench of a pad on the object, and how it grows with the velocity of the pad over it: pressure
/// where the points are, friction in the plane.
void PointSolver::look_in_plane(const PadFace& spec, Face& face) const {
  face.wrench.setZero();
  face.hardness.setZero();
  Vec3 rubs = Vec3::Zero(), turns = Vec3::Zero();
  Mat3 vv = Mat3::Zero(), vw = Mat3::Zero(), ww = Mat3::Zero();
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const PadPoint& point = spec.points[i];
    const PointState& state = face.points[i];
    const PointForce force =
        force_at(state, spec.friction, step_s_, slip_of(spec, face, i, face.relative));
    if (force.normal_N == 0.0) continue;
    const Vec3& arm = face.arms[i];
    const Vec6 presses = row_of(point.normal, point.p_pad);
    face.wrench += force.normal_N * presses;
    rubs += force.friction_N;
    turns += arm.cross(force.friction_N);
    Vec6 grows = presses;
    if (force.slides) grows += row_of(friction_of_pressure(spec.friction, force), arm);
    face.hardness += (step_s_ * state.stiffness_N_m * grows) * presses.transpose();
    // With the skew matrix S of the arm: K, -K S, -S K S; K is symmetric.
    const Mat3 K = friction_hardness(face.plane, state, force);
    Mat3 KS;
    for (int k = 0; k < 3; ++k) KS.row(k) = arm.cross(K.row(k).transpose()).transpose();
    vv += K;
    vw += KS;
    for (int k = 0; k < 3; ++k) ww.col(k) += arm.cross(KS.col(k));
  }
  face.wrench.head<3>() += rubs;
  face.wrench.tail<3>() += turns;
  face.hardness.topLeftCorner<3, 3>() += vv;
  face.hardness.topRightCorner<3, 3>() += vw;
  face.hardness.bottomLeftCorner<3, 3>() += vw.transpose();
  face.hardness.bottomRightCorner<3, 3>() += ww;
}

}  // namespace isograsp::bimanual
