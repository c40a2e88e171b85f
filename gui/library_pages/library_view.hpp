// SPDX-License-Identifier: GPL-3.0-or-later
// The preview beside the editor of the library page: facts, target over time, object from above,
// steps with their durations.
#pragma once

#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "gui/library_pages/library_preview.hpp"
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
  QTableWidget* steps_;
  QLabel* facts_;
};

}  // namespace isograsp::gui
