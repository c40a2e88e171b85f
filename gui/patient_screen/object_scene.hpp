// SPDX-License-Identifier: GPL-3.0-or-later
// The 3D picture of the patient's screen: block, ghost of the target, three virtual fingers, floor
// and wall with grid and shadows; of a real object the same in a larger room, without fingers.
// World: x right, y up, z to the viewer [m]. Needs a current OpenGL
// context (compatibility profile) in draw() only.
#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>
#include <memory>

#include "gui/picture/patient_picture.hpp"

namespace isograsp::gui {

class ObjectScene {
 public:
  ObjectScene();
  ~ObjectScene();
  ObjectScene(const ObjectScene&) = delete;
  ObjectScene& operator=(const ObjectScene&) = delete;

  /// @pre picture.page == Page::object
  void show(const PatientPicture& picture);
  /// Clears that part of the frame buffer and draws there, device pixels from its lower left.
  void draw(const QRect& viewport_px);
  /// Where a point of the world appears, in pixels from the upper left of `size_px`.
  [[nodiscard]] QPointF project(const Vec3& p_W, QSize size_px) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isograsp::gui
