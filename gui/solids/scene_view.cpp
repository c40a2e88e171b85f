// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/solids/scene_view.hpp"

#include <GL/gl.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/nodes/SoCamera.h>

#include "gui/solids/scene_nodes.hpp"

namespace isograsp::gui {

SceneView::SceneView() = default;
SceneView::~SceneView() = default;

void SceneView::draw(SoNode& root, const QRect& viewport_px) {
  const QRect& v = viewport_px;
  SbViewportRegion region;
  region.setWindowSize(static_cast<short>(v.x() + v.width()),
                       static_cast<short>(v.y() + v.height()));
  region.setViewportPixels(static_cast<short>(v.x()), static_cast<short>(v.y()),
                           static_cast<short>(v.width()), static_cast<short>(v.height()));
  if (action_ == nullptr) {
    action_ = std::make_unique<SoGLRenderAction>(region);
    action_->setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    action_->setSmoothing(TRUE);
    action_->setCacheContext(1);
  }
  action_->setViewportRegion(region);
  glViewport(v.x(), v.y(), v.width(), v.height());
  glEnable(GL_SCISSOR_TEST);
  glScissor(v.x(), v.y(), v.width(), v.height());
  const SbColor& wall = scene_nodes::kWallColour;
  glClearColor(wall[0], wall[1], wall[2], 1.0F);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  action_->apply(&root);
  glDisable(GL_SCISSOR_TEST);
}

QPointF SceneView::project(const SoCamera& camera, const Vec3& p_W, QSize size_px) {
  const auto aspect = static_cast<float>(size_px.width()) / static_cast<float>(size_px.height());
  SbVec3f place;
  camera.getViewVolume(aspect).projectToScreen(scene_nodes::to_sb(p_W), place);
  return {static_cast<qreal>(place[0]) * size_px.width(),
          (1.0 - static_cast<qreal>(place[1])) * size_px.height()};
}

}  // namespace isograsp::gui
