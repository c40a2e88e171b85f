// SPDX-License-Identifier: GPL-3.0-or-later
// The object of a stored trial in three dimensions, with its path: the patient's picture again.
#pragma once

#include <QImage>
#include <QOpenGLWindow>
#include <memory>

#include "gui/patient_screen/object_scene.hpp"
#include "gui/trial_pages/loaded_trial.hpp"

namespace isograsp::gui {

class ReplayWindow final : public QOpenGLWindow {
  Q_OBJECT

 public:
  ReplayWindow() = default;
  ~ReplayWindow() override;

  void show_trial(std::shared_ptr<const LoadedTrial> trial);
  void show_state(const ReplayState& state);

 Q_SIGNALS:
  void key_pressed(int key);  ///< a window in a widget keeps its keys to itself

 protected:
  void initializeGL() override;
  void paintGL() override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::shared_ptr<const LoadedTrial> trial_;
  ReplayState state_;
  void draw_path(QSize size_px);

  std::unique_ptr<ObjectScene> scene_;
  QImage path_;  ///< the camera never moves: the path is projected once
};

}  // namespace isograsp::gui
