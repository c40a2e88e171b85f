// SPDX-License-Identifier: GPL-3.0-or-later
// The object of a patient's picture in three dimensions, alone and without words, to be put into a
// page of the therapist. Needs a display with OpenGL (why_no_opengl).
#pragma once

#include <QOpenGLWindow>
#include <memory>

#include "gui/patient_screen/object_scene.hpp"

class QPainter;

namespace isograsp::gui {

class ObjectWindow : public QOpenGLWindow {
  Q_OBJECT

 public:
  ObjectWindow() = default;
  ~ObjectWindow() override;

  /// Of another page than that of an object nothing is drawn.
  void show_picture(const PatientPicture& picture);

 Q_SIGNALS:
  /// A window in a widget keeps its keys to itself.
  void key_pressed(int key, Qt::KeyboardModifiers modifiers);

 protected:
  /// Over the picture, which is drawn.
  virtual void paint_over(QPainter&, const ObjectScene&, QSize /*size_px*/) {}

  void initializeGL() override;
  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  PatientPicture picture_;
  std::unique_ptr<ObjectScene> scene_;
};

}  // namespace isograsp::gui
