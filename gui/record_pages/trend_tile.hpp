// SPDX-License-Identifier: GPL-3.0-or-later
// One measure as a small picture: title, newest value, the task, a line for what may be said about
// it, and its trend over the sessions.
#pragma once

#include <QWidget>

#include "gui/record_pages/measure_trend.hpp"
#include "gui/record_pages/trend_plot.hpp"

namespace isograsp::gui {

class TrendTile final : public QWidget {
  Q_OBJECT

 public:
  explicit TrendTile(const MeasureTrend& trend, QWidget* parent = nullptr);

  /// One line under the title; there is room for it from the beginning.
  void set_remark(const QString& remark);

 Q_SIGNALS:
  void opened();  ///< clicked, or Enter

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QString title_;
  QString task_;
  QString last_;
  QString remark_;
};

}  // namespace isograsp::gui
