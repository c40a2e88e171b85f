// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand, its object and its target in three dimensions, over a table (Coin, OpenGL 2.1). A
// frame moves what was built once. Call everything with the OpenGL context current.
#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>
#include <memory>

#include "gui/picture/hand_picture.hpp"

namespace isograsp::gui {

class HandScene {
 public:
  HandScene();
  ~HandScene();
  HandScene(const HandScene&) = delete;
  HandScene& operator=(const HandScene&) = delete;

  void show(const HandPicture& picture);
  /// Clears that part of the frame buffer and draws there, device pixels from its lower left.
  void draw(const QRect& viewport_px);
  /// Where a point of the world appears, in pixels from the upper left of `size_px`.
  [[nodiscard]] QPointF project(const Vec3& p_W, QSize size_px) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isograsp::gui
