// SPDX-License-Identifier: GPL-3.0-or-later
// The object of a patient's picture in three dimensions, with the hand that holds it where one is
// tracked, without words, to be put into a page of the therapist. Needs a display with OpenGL
// (why_no_opengl).
#pragma once

#include <QOpenGLWindow>
#include <functional>
#include <memory>

#include "gui/patient_screen/hand_scene.hpp"
#include "gui/patient_screen/object_scene.hpp"

class QPainter;

namespace isograsp::gui {

class ObjectWindow : public QOpenGLWindow {
  Q_OBJECT

 public:
  ObjectWindow() = default;
  ~ObjectWindow() override;

  /// Of other pages than those of an object and of a tracked hand nothing is drawn.
  void show_picture(const PatientPicture& picture);

 Q_SIGNALS:
  /// A window in a widget keeps its keys to itself.
  void key_pressed(int key, Qt::KeyboardModifiers modifiers);

 protected:
  /// Where a point of the world appears [px].
  using Project = std::function<QPointF(const Vec3& p_W)>;
  /// Over the picture, which is drawn.
  virtual void paint_over(QPainter&, const Project&, QSize /*size_px*/) {}

  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// Draws the scene of the picture, and says where its points appear.
  template <class Scene, class Shown>
  Project draw(std::unique_ptr<Scene>& scene, const Shown& shown, QSize size_px);

  PatientPicture picture_;
  std::unique_ptr<ObjectScene> scene_;     ///< made with the first picture of its kind;
  std::unique_ptr<HandScene> hand_scene_;  ///< so is this one
};

}  // namespace isograsp::gui
