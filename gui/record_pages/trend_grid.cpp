// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/trend_grid.hpp"

#include <QGridLayout>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/card.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kGap_px = 10;
constexpr int kTile_px = 250;  // least width of a picture
constexpr int kScrollBar_px = 12;
}  // namespace

TrendGrid::TrendGrid(QWidget* parent) : QStackedWidget(parent) {
  scroll_ = new QScrollArea;
  scroll_->setObjectName("trend_scroll");
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->viewport()->setAutoFillBackground(false);
  sheet_ = new QWidget;
  sheet_->setAutoFillBackground(false);
  auto* grid = new QGridLayout(sheet_);
  grid->setContentsMargins(0, 0, 2, 0);
  grid->setSpacing(kGap_px);
  nothing_ = new QLabel(tr("No measure of this patient has been stored yet."));
  nothing_->setProperty("role", "quiet");
  nothing_->setAlignment(Qt::AlignCenter);
  grid->addWidget(nothing_, 0, 0);
  scroll_->setWidget(sheet_);
  addWidget(scroll_);

  auto* card = new Card({});
  large_ = card;
  auto* column = static_cast<QVBoxLayout*>(card->layout());
  large_title_ = card->findChild<QLabel*>();
  large_title_->setWordWrap(true);
  back_ = new QPushButton(tr("All measures"));
  back_->setObjectName("trend_back");
  describe(*back_, tr("All measures"), tr("Back to all measures (Escape, or F4)"));
  auto* head = new QHBoxLayout;
  column->removeWidget(large_title_);
  head->addWidget(large_title_, 1);
  head->addWidget(back_);
  large_remark_ = new QLabel;
  large_remark_->setProperty("role", "quiet");
  large_remark_->setWordWrap(true);
  large_plot_ = new SessionTrendPlot(SessionTrendPlot::Size::large);
  take_rest(*large_plot_, 160);
  column->addLayout(head);
  column->addWidget(large_remark_);
  column->addWidget(large_plot_, 1);
  addWidget(large_);
  connect(back_, &QPushButton::clicked, this, &TrendGrid::close_large);
  large_->installEventFilter(this);
  back_->installEventFilter(this);
}

void TrendGrid::show_trends(std::vector<MeasureTrend> trends) {
  trends_ = std::move(trends);
  for (auto* tile : tiles_) delete tile;
  tiles_.clear();
  for (std::size_t i = 0; i < trends_.size(); ++i) {
    auto* tile = new TrendTile(trends_[i], sheet_);
    tile->setObjectName(QStringLiteral("trend_%1").arg(i));
    tile->installEventFilter(this);
    connect(tile, &TrendTile::opened, this, [this, i] { open_large(i); });
    tiles_.push_back(tile);
  }
  nothing_->setVisible(tiles_.empty());
  arranged_in_ = 0;
  arrange();
  choose(0);
  setCurrentWidget(scroll_);
}

int TrendGrid::columns() const {
  return std::max(1, (width() - kScrollBar_px + kGap_px) / (scaled(kTile_px) + kGap_px));
}

void TrendGrid::arrange() {
  if (columns() == arranged_in_) return;
  arranged_in_ = columns();
  auto* grid = static_cast<QGridLayout*>(sheet_->layout());
  for (auto* tile : tiles_) grid->removeWidget(tile);
  for (std::size_t i = 0; i < tiles_.size(); ++i)
    grid->addWidget(tiles_[i], static_cast<int>(i) / arranged_in_,
                    static_cast<int>(i) % arranged_in_);
  for (int column = 0; column < grid->columnCount(); ++column)
    grid->setColumnStretch(column, column < arranged_in_ ? 1 : 0);
  for (auto* tile : tiles_) tile->show();
}

void TrendGrid::resizeEvent(QResizeEvent* event) {
  QStackedWidget::resizeEvent(event);
  arrange();
}

void TrendGrid::choose(int index) {
  if (tiles_.empty()) return;
  current_ = std::clamp(index, 0, static_cast<int>(tiles_.size()) - 1);
  // One stop for the Tab key: the arrows go on from there.
  for (std::size_t i = 0; i < tiles_.size(); ++i)
    tiles_[i]->setFocusPolicy(static_cast<int>(i) == current_ ? Qt::StrongFocus : Qt::ClickFocus);
}

void TrendGrid::open_large(std::size_t index) {
  const MeasureTrend& trend = trends_.at(index);
  choose(static_cast<int>(index));
  large_title_->setText(tr("%1: %2").arg(trend.title, trend.last));
  large_remark_->setText(
      trend.without > 0
          ? tr("%1. Without a value: %2.").arg(trend.task, trials_words(trend.without))
          : trend.task);
  if (!trend.remark.isEmpty())
    large_remark_->setText(tr("%1\n%2").arg(trend.remark, large_remark_->text()));
  if (trend.mixed)
    large_remark_->setText(
        tr("%1\nThe trials differ in their parameters, level or object, so that not only the "
           "patient changes from one to the next.")
            .arg(large_remark_->text()));
  describe(*large_plot_, trend.title,
           tr("Disc: assessment, ring: practice, triangle: helped; the line joins the means of the "
              "sessions (Escape goes back)"));
  large_plot_->show_trend(trend);
  setCurrentWidget(large_);
  back_->setFocus();
}

void TrendGrid::close_large() {
  setCurrentWidget(scroll_);
  take_focus();
}

void TrendGrid::take_focus() {
  if (currentWidget() == large_)
    back_->setFocus();
  else if (!tiles_.empty())
    tiles_[static_cast<std::size_t>(current_)]->setFocus();
}

bool TrendGrid::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) {
    const auto tile = std::find(tiles_.begin(), tiles_.end(), watched);
    if (tile != tiles_.end()) choose(static_cast<int>(tile - tiles_.begin()));
  }
  if (event->type() != QEvent::KeyPress) return QStackedWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (currentWidget() == large_) {
    if (key != Qt::Key_Escape) return QStackedWidget::eventFilter(watched, event);
    close_large();
    return true;
  }
  int to = current_;
  switch (key) {
    case Qt::Key_Left: to -= 1; break;
    case Qt::Key_Right: to += 1; break;
    case Qt::Key_Up: to -= arranged_in_; break;
    case Qt::Key_Down: to += arranged_in_; break;
    case Qt::Key_Home: to = 0; break;
    case Qt::Key_End: to = static_cast<int>(tiles_.size()) - 1; break;
    default: return QStackedWidget::eventFilter(watched, event);
  }
  if (to >= 0 && to < static_cast<int>(tiles_.size())) {
    choose(to);
    tiles_[static_cast<std::size_t>(current_)]->setFocus(Qt::TabFocusReason);
    scroll_->ensureWidgetVisible(tiles_[static_cast<std::size_t>(current_)], 0, kGap_px);
  }
  return true;
}

}  // namespace isograsp::gui
