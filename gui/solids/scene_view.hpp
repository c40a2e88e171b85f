// SPDX-License-Identifier: GPL-3.0-or-later
// A scene of Coin in a part of a window: drawn by OpenGL, and where its points appear.
#pragma once

#include <QPointF>
#include <QRect>
#include <QSize>
#include <memory>

#include "core/spatial.hpp"

class SoCamera;
class SoGLRenderAction;
class SoNode;

namespace isograsp::gui {

class SceneView {
 public:
  SceneView();
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Clears that part of the frame buffer, in the colour of the wall, and draws there; device
  /// pixels from its lower left. Call it with the OpenGL context current (compatibility profile).
  void draw(SoNode& root, const QRect& viewport_px);
  /// Where a point of the world appears, in pixels from the upper left of `size_px`.
  [[nodiscard]] static QPointF project(const SoCamera& camera, const Vec3& p_W, QSize size_px);

 private:
  std::unique_ptr<SoGLRenderAction> action_;
};

}  // namespace isograsp::gui
