// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/object_window.hpp"

#include <QKeyEvent>
#include <QPainter>

#include <GL/gl.h>

namespace isograsp::gui {

ObjectWindow::~ObjectWindow() {
  makeCurrent();
  scene_.reset();
  doneCurrent();
}

void ObjectWindow::show_picture(const PatientPicture& picture) {
  picture_ = picture;
  if (isExposed()) update();
}

void ObjectWindow::initializeGL() {
  scene_ = std::make_unique<ObjectScene>();
}

void ObjectWindow::paintGL() {
  if (picture_.page != PatientPicture::Page::object) {
    glClearColor(0.91F, 0.93F, 0.95F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return;
  }
  const QSize size_px = size() * devicePixelRatio();
  scene_->show(picture_);
  scene_->draw(QRect(QPoint(0, 0), size_px));
  // QPainter changes OpenGL's state, and the next 3D picture would be lit wrongly.
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  {
    QPainter painter(this);
    painter.scale(1.0 / devicePixelRatio(), 1.0 / devicePixelRatio());
    paint_over(painter, *scene_, size_px);
  }
  glPopClientAttrib();
  glPopAttrib();
}

void ObjectWindow::keyPressEvent(QKeyEvent* event) {
  Q_EMIT key_pressed(event->key(), event->modifiers());
}

}  // namespace isograsp::gui
