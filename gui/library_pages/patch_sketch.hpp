// SPDX-License-Identifier: GPL-3.0-or-later
// What the pads of a scene cover of its object, each as it looks at the object, to one scale.
#pragma once

#include <QPainter>
#include <QPolygonF>
#include <QWidget>
#include <vector>

#include "gui/library_pages/library_preview.hpp"

namespace isograsp::gui {

class PatchSketch final : public QWidget {
  Q_OBJECT

 public:
  explicit PatchSketch(QWidget* parent = nullptr);
  void show_patches(const std::vector<LibraryPreview::Patch>& patches);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// x and y of a contact [m], as they stand in a panel: the pad looks along its normal, x, the
  /// tangent, is up.
  struct Place {
    QPointF point_px;  ///< of the contact point
    double px_per_m;

    [[nodiscard]] QPointF at(const QPointF& p) const {
      return {point_px.x() + px_per_m * p.y(), point_px.y() - px_per_m * p.x()};
    }
    [[nodiscard]] QPolygonF shape(const QPolygonF& outline) const {
      QPolygonF drawn;
      for (const auto& corner : outline) drawn << at(corner);
      return drawn;
    }
  };
  [[nodiscard]] QRectF panel(int index) const;
  [[nodiscard]] double px_per_m() const;
  void draw_patch(QPainter& painter, const LibraryPreview::Patch& patch, const QRectF& panel) const;
  void draw_foot(QPainter& painter) const;

  std::vector<LibraryPreview::Patch> patches_;
};

}  // namespace isograsp::gui
