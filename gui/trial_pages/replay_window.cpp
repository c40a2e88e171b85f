// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/replay_window.hpp"

#include <QKeyEvent>
#include <QPainter>

#include <GL/gl.h>

#include "gui/look/look.hpp"

namespace isograsp::gui {

ReplayWindow::~ReplayWindow() {
  makeCurrent();
  scene_.reset();
  doneCurrent();
}

void ReplayWindow::show_trial(std::shared_ptr<const LoadedTrial> trial) {
  trial_ = std::move(trial);
  state_ = {};
  path_ = {};
  update();
}

void ReplayWindow::show_state(const ReplayState& state) {
  state_ = state;
  if (isExposed()) update();
}

void ReplayWindow::initializeGL() {
  scene_ = std::make_unique<ObjectScene>();
}

void ReplayWindow::draw_path(QSize size_px) {
  path_ = QImage(size_px, QImage::Format_ARGB32_Premultiplied);
  path_.fill(Qt::transparent);
  QPainter painter(&path_);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look::kAccent, 1.5));
  QPolygonF stretch;
  for (const auto& p : trial_->path) {
    if (p.allFinite()) {
      stretch << scene_->project(p, size_px);
      continue;
    }
    painter.drawPolyline(stretch);
    stretch.clear();
  }
  painter.drawPolyline(stretch);
}

void ReplayWindow::paintGL() {
  const QSize size_px = size() * devicePixelRatio();
  const bool object = trial_ != nullptr && (trial_->arm != nullptr || state_.X_WO);
  const PatientPicture picture = object ? picture_at(*trial_, state_) : PatientPicture{};
  if (picture.page != PatientPicture::Page::object) {
    glClearColor(0.91F, 0.93F, 0.95F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return;
  }
  scene_->show(picture);
  scene_->draw(QRect(QPoint(0, 0), size_px));
  if (path_.size() != size_px) draw_path(size_px);
  // QPainter changes OpenGL's state, and the next 3D picture would be lit wrongly.
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  {
    QPainter painter(this);
    painter.scale(1.0 / devicePixelRatio(), 1.0 / devicePixelRatio());
    painter.drawImage(0, 0, path_);
  }
  glPopClientAttrib();
  glPopAttrib();
}

void ReplayWindow::keyPressEvent(QKeyEvent* event) {
  Q_EMIT key_pressed(event->key());
}

}  // namespace isograsp::gui
