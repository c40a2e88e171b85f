// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of a patient's main measures side by side; one of them at a time may be large.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <vector>

#include "gui/record_pages/measure_trend.hpp"
#include "gui/record_pages/trend_tile.hpp"

namespace isograsp::gui {

class TrendGrid final : public QStackedWidget {
  Q_OBJECT

 public:
  explicit TrendGrid(QWidget* parent = nullptr);

  void show_trends(std::vector<MeasureTrend> trends);
  void open_large(std::size_t index);
  void close_large();
  /// Gives the focus to what is to be read next: the current picture, or the way back.
  void take_focus();

  [[nodiscard]] const std::vector<MeasureTrend>& trends() const noexcept { return trends_; }
  [[nodiscard]] TrendTile* tile(std::size_t index) { return tiles_.at(index); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void arrange();
  void choose(int index);
  [[nodiscard]] int columns() const;

  std::vector<MeasureTrend> trends_;
  std::vector<TrendTile*> tiles_;
  int current_ = 0;  ///< the tile that the Tab key reaches
  int arranged_in_ = 0;
  QScrollArea* scroll_;
  QWidget* sheet_;
  QLabel* nothing_;
  QWidget* large_;
  QLabel* large_title_;
  QLabel* large_remark_;
  QPushButton* back_;
  SessionTrendPlot* large_plot_;
};

}  // namespace isograsp::gui
