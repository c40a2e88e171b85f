// SPDX-License-Identifier: GPL-3.0-or-later
// The preview beside the editor of the library page: facts, target over time, object from above,
// steps with their durations.
#pragma once

#include <QLabel>
#include <QPainter>
#include <QPolygonF>
#include <QTableWidget>
#include <QWidget>

#include "gui/library_pages/library_preview.hpp"
#include "gui/library_pages/patch_sketch.hpp"
#include "gui/look/card.hpp"

namespace isograsp::gui {

/// A target over time; what the patient does not see is dashed.
class TargetCurve final : public QWidget {
  Q_OBJECT

 public:
  explicit TargetCurve(QWidget* parent = nullptr);
  void show_curve(const LibraryPreview::Curve& curve);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Axes {
    QRectF area;  ///< of the plot [px]
    double least;
    double most;
    double end_s;

    [[nodiscard]] double x(double t_s) const { return area.left() + area.width() * t_s / end_s; }
    [[nodiscard]] double y(double value) const {
      return area.bottom() - area.height() * (value - least) / (most - least);
    }
  };
  [[nodiscard]] Axes axes() const;
  void draw_axes(QPainter& painter, const Axes& on) const;
  void draw_curve(QPainter& painter, const Axes& on) const;

  LibraryPreview::Curve curve_;
};

/// The object in the plane of x and y with its fingers and targets, to scale.
class ObjectSketch final : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectSketch(QWidget* parent = nullptr);
  void show_sketch(const LibraryPreview::Sketch& sketch);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Of x and y [m], as it stands in the widget.
  struct Plane {
    QPointF center_m;
    QPointF center_px;
    double px_per_m;

    [[nodiscard]] QPointF at(const QPointF& place) const {
      return {center_px.x() + px_per_m * (place.x() - center_m.x()),
              center_px.y() - px_per_m * (place.y() - center_m.y())};
    }
    [[nodiscard]] QPolygonF shape(const QPolygonF& outline) const {
      QPolygonF drawn;
      for (const auto& corner : outline) drawn << at(corner);
      return drawn;
    }
  };
  [[nodiscard]] Plane plane() const;
  /// The object's outline there [m].
  [[nodiscard]] QPolygonF placed(const LibraryPreview::Sketch::Target& target) const;
  void draw_targets(QPainter& painter, const Plane& on) const;
  void draw_arrows(QPainter& painter, const Plane& on) const;
  void draw_letters(QPainter& painter, const Plane& on) const;

  LibraryPreview::Sketch sketch_;
};

class LibraryView final : public Card {
  Q_OBJECT

 public:
  explicit LibraryView(QWidget* parent = nullptr);
  void show_preview(const LibraryPreview& preview);
  /// What is shown is that of the last text that could be read.
  void show_outdated(bool outdated);

 private:
  void fill_steps(const std::vector<LibraryPreview::Step>& steps);

  QLabel* outdated_;
  TargetCurve* curve_;
  ObjectSketch* sketch_;
  PatchSketch* patches_;
  QTableWidget* steps_;
  QLabel* facts_;
};

}  // namespace isograsp::gui
