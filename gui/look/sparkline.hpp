// SPDX-License-Identifier: GPL-3.0-or-later
// A handful of values as one small line, the last one a dot: which way it went, not how far.
#pragma once

#include <QWidget>
#include <vector>

namespace isograsp::gui {

class Sparkline final : public QWidget {
  Q_OBJECT

 public:
  explicit Sparkline(QWidget* parent = nullptr);
  /// Oldest first; none: nothing is drawn.
  void show_values(std::vector<double> values);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<double> values_;
};

}  // namespace isograsp::gui
