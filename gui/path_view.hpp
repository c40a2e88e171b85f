// SPDX-License-Identifier: GPL-3.0-or-later
// Path, object and target of a trial, projected: front view (x right, y up) and side view (seen
// from the right). For computers without OpenGL.
#pragma once

#include <QWidget>
#include <memory>

#include "gui/loaded_trial.hpp"

namespace isograsp {

class PathView final : public QWidget {
  Q_OBJECT

 public:
  explicit PathView(QWidget* parent = nullptr);
  void show_trial(std::shared_ptr<const LoadedTrial> trial);
  void show_state(const ReplayState& state);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_view(QPainter& painter, const QRectF& area, int across_axis, double scale) const;

  std::shared_ptr<const LoadedTrial> trial_;
  ReplayState state_;
  Vec3 least_m_ = Vec3::Zero();  ///< of the box around path, targets and object
  Vec3 most_m_ = Vec3::Zero();
};

}  // namespace isograsp
