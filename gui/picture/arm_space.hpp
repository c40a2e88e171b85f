// SPDX-License-Identifier: GPL-3.0-or-later
// From the frame W of the cameras to the frame S of the screens: x right, y up, z to whoever looks
// [m]. Its origin is a point of W, as a rule where the object was in the start posture. Of a left
// arm poses are those of its reflection: they are reflected back here, and only here. For drawing:
// nothing that is stored comes from it.
#pragma once

#include <memory>

#include "grasp_model/scene.hpp"
#include "hand/finger.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

class ArmSpace {
 public:
  ArmSpace(const session::ArmSetup& setup, Hand hand);

  /// `centre_W`: what is drawn in the middle, in the frame that poses are in.
  [[nodiscard]] Vec3 place(const Vec3& p_W, const Vec3& centre_W) const;
  [[nodiscard]] Pose pose(const Pose& X_W, const Vec3& centre_W) const;
  /// The same of a marker, which stands where cameras see it.
  [[nodiscard]] Vec3 marker(const Vec3& p_W, const Vec3& centre_W) const;

  /// The object as it is drawn: the box round its markers, in its true size. Not null.
  [[nodiscard]] const std::shared_ptr<const Scene>& box() const noexcept { return box_; }
  /// Pose of that box where the object is at X_WO.
  [[nodiscard]] Pose box_at(const Pose& X_WO, const Vec3& centre_W) const;

 private:
  bool mirrored_;
  Mat3 R_SW_;  ///< W as the cameras have it
  std::shared_ptr<const Scene> box_;
  Vec3 p_OB_;  ///< centre of the box on the object, as the cameras see it [m]
};

}  // namespace isograsp::gui
