// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/object_window.hpp"

#include <QKeyEvent>
#include <QPainter>

#include <GL/gl.h>

namespace isograsp::gui {

ObjectWindow::~ObjectWindow() {
  makeCurrent();
  scene_.reset();
  hand_scene_.reset();
  doneCurrent();
}

void ObjectWindow::show_picture(const PatientPicture& picture) {
  picture_ = picture;
  if (isExposed()) update();
}

template <class Scene, class Shown>
ObjectWindow::Project ObjectWindow::draw(std::unique_ptr<Scene>& scene, const Shown& shown,
                                         QSize size_px) {
  if (!scene) scene = std::make_unique<Scene>();
  scene->show(shown);
  scene->draw(QRect(QPoint(0, 0), size_px));
  return [&scene, size_px](const Vec3& p_W) { return scene->project(p_W, size_px); };
}

void ObjectWindow::paintGL() {
  const bool hand = picture_.page == PatientPicture::Page::hand;
  if (!hand && picture_.page != PatientPicture::Page::object) {
    glClearColor(0.91F, 0.93F, 0.95F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return;
  }
  const QSize size_px = size() * devicePixelRatio();
  const Project project =
      hand ? draw(hand_scene_, *picture_.tracked_hand, size_px) : draw(scene_, picture_, size_px);
  // QPainter changes OpenGL's state, and the next 3D picture would be lit wrongly.
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  {
    QPainter painter(this);
    painter.scale(1.0 / devicePixelRatio(), 1.0 / devicePixelRatio());
    paint_over(painter, project, size_px);
  }
  glPopClientAttrib();
  glPopAttrib();
}

void ObjectWindow::keyPressEvent(QKeyEvent* event) {
  Q_EMIT key_pressed(event->key(), event->modifiers());
}

}  // namespace isograsp::gui
