// SPDX-License-Identifier: GPL-3.0-or-later
// The object of a stored trial in three dimensions, with its path: the patient's picture again.
#pragma once

#include <QImage>
#include <memory>

#include "gui/patient_screen/object_window.hpp"
#include "gui/trial_pages/loaded_trial.hpp"

namespace isograsp::gui {

class ReplayWindow final : public ObjectWindow {
  Q_OBJECT

 public:
  void show_trial(std::shared_ptr<const LoadedTrial> trial);
  void show_state(const ReplayState& state);

 protected:
  void paint_over(QPainter& painter, const Project& project, QSize size_px) override;

 private:
  void draw_path(const Project& project, QSize size_px);

  std::shared_ptr<const LoadedTrial> trial_;
  QImage path_;  ///< the camera never moves: the path is projected once
};

}  // namespace isograsp::gui
