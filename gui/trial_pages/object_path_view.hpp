// SPDX-License-Identifier: GPL-3.0-or-later
// Path, object and target of a trial, projected: front view (x right, y up) and side view (seen
// from the right). For computers without OpenGL.
#pragma once

#include <QPixmap>
#include <QWidget>
#include <array>
#include <memory>

#include "gui/trial_pages/loaded_trial.hpp"

namespace isograsp::gui {

class ObjectPathView final : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectPathView(QWidget* parent = nullptr);
  void show_trial(std::shared_ptr<const LoadedTrial> trial);
  void show_state(const ReplayState& state);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// One of the two views: where it is and which axis of the world goes across.
  struct View {
    QRectF area;
    int across = 0;
    double px_per_m = 1.0;
  };
  [[nodiscard]] std::array<View, 2> views() const;
  [[nodiscard]] QPointF place(const View& view, const Vec3& p_W) const;
  void paint_backdrop();
  void paint_object(QPainter& painter, const View& view) const;
  void paint_outline(QPainter& painter, const View& view, const Pose& pose) const;

  std::shared_ptr<const LoadedTrial> trial_;
  ReplayState state_;
  QPixmap backdrop_;  ///< frame, titles and path: they do not change while the object moves
  Vec3 least_m_ = Vec3::Zero();  ///< of the box around path, targets and object
  Vec3 most_m_ = Vec3::Zero();
};

}  // namespace isograsp::gui
