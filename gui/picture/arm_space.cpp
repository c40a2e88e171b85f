// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/picture/arm_space.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/attitude.hpp"

namespace isograsp::gui {

namespace {

/// An object of which the rig says nothing, and the thinnest box: a plane cannot be seen from its
/// side [m].
constexpr double kUnknownSize_m = 0.06;
constexpr double kThinnest_m = 0.02;

/// "x", "-z": an axis of the cameras.
Vec3 axis_called(const std::string& name) {
  const bool negative = name.starts_with('-');
  const char letter = name.empty() ? 'x' : name.back();
  Vec3 axis = Vec3::Zero();
  axis[letter == 'y' ? 1 : letter == 'z' ? 2 : 0] = negative ? -1.0 : 1.0;
  return axis;
}

Mat3 screen_from_cameras(const RigView& view) {
  const Vec3 right = axis_called(view.right);
  const Vec3 up = axis_called(view.up);
  Mat3 R_SW;
  R_SW.row(0) = right;
  R_SW.row(1) = up;
  R_SW.row(2) = right.cross(up);
  return R_SW;
}

}  // namespace

ArmSpace::ArmSpace(const session::ArmSetup& setup, Hand hand)
    : mirrored_(hand == Hand::left), R_SW_(screen_from_cameras(setup.view)), p_OB_(Vec3::Zero()) {
  auto box = std::make_shared<Scene>();
  box->shape = Shape::box;
  box->size_m = Vec3::Constant(kUnknownSize_m);
  if (!setup.object_m.empty()) {
    Vec3 least = setup.object_m.front();
    Vec3 most = least;
    for (const Vec3& p_O : setup.object_m) {
      least = least.cwiseMin(p_O);
      most = most.cwiseMax(p_O);
    }
    box->size_m = (most - least).cwiseMax(kThinnest_m);
    p_OB_ = 0.5 * (least + most);
    if (mirrored_) p_OB_ = mirrored(p_OB_);
  }
  box_ = std::move(box);
}

Vec3 ArmSpace::place(const Vec3& p_W, const Vec3& centre_W) const {
  const Vec3 from_centre = p_W - centre_W;
  return R_SW_ * (mirrored_ ? mirrored(from_centre) : from_centre);
}

Pose ArmSpace::pose(const Pose& X_W, const Vec3& centre_W) const {
  const Pose seen = mirrored_ ? mirrored(X_W) : X_W;
  return {place(X_W.p, centre_W), Quat(R_SW_) * seen.q};
}

Vec3 ArmSpace::marker(const Vec3& p_W, const Vec3& centre_W) const {
  return R_SW_ * (p_W - (mirrored_ ? mirrored(centre_W) : centre_W));
}

Pose ArmSpace::box_at(const Pose& X_WO, const Vec3& centre_W) const {
  Pose X_SO = pose(X_WO, centre_W);
  X_SO.p += X_SO.q * p_OB_;
  return X_SO;
}

}  // namespace isograsp::gui
