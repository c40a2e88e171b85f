// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/page_view.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kAround_px = 14;
constexpr double kLeastScale = 0.4;
constexpr double kMostScale = 4.0;
constexpr double kMostFitting = 1.7;  // wider windows show more of a page, not larger letters
}  // namespace

/// Paints what there is of the pages.
class PageView::Sheets final : public QWidget {
 public:
  explicit Sheets(PageView& view) : view_(view) {}

 protected:
  void paintEvent(QPaintEvent* event) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.fillRect(event->rect(), look::kDesk);
    for (int page = 0; page < view_.pages(); ++page) {
      const QRect place = view_.place_of(page);
      if (!place.intersects(event->rect())) continue;
      painter.fillRect(place, Qt::white);
      const auto& sheet = view_.sheets_[static_cast<std::size_t>(page)];
      if (!sheet.image.isNull()) painter.drawImage(place, sheet.image);
      painter.setPen(look::kLine);
      painter.drawRect(place.adjusted(-1, -1, 0, 0));
    }
  }

 private:
  PageView& view_;
};

PageView::PageView(QWidget* parent) : QScrollArea(parent), canvas_(new Sheets(*this)) {
  setWidget(canvas_);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  between_events_.setInterval(0);
  connect(&between_events_, &QTimer::timeout, this, &PageView::paint_next);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, this, [this] {
    if (!held_) between_events_.start();
    Q_EMIT moved();
  });
}

PageView::~PageView() = default;

void PageView::show_pages(std::shared_ptr<const reports::ReportPages> pages) {
  under_way_.reset();  // before what it paints
  pages_ = std::move(pages);
  sheets_.assign(pages_ == nullptr ? 0 : static_cast<std::size_t>(pages_->pages()), {});
  verticalScrollBar()->setValue(0);
  lay_out();
}

QRect PageView::place_of(int page) const {
  const QSizeF size = scale_ * reports::report_page_size();
  const int height = static_cast<int>(std::lround(size.height()));
  const int width = static_cast<int>(std::lround(size.width()));
  const int left = std::max(kAround_px, (viewport()->width() - width) / 2);
  return {left, kAround_px + page * (height + kAround_px), width, height};
}

int PageView::page() const {
  const int middle = verticalScrollBar()->value() + viewport()->height() / 2;
  for (int page = 0; page < pages(); ++page)
    if (middle < place_of(page).bottom() + kAround_px) return page + 1;
  return pages();
}

void PageView::lay_out() {
  if (fits_)
    scale_ =
        std::clamp((viewport()->width() - 2.0 * kAround_px) / reports::report_page_size().width(),
                   kLeastScale, kMostFitting);
  const QRect last = place_of(std::max(0, pages() - 1));
  canvas_->resize(std::max(viewport()->width(), last.width() + 2 * kAround_px),
                  pages() == 0 ? viewport()->height() : last.bottom() + kAround_px);
  canvas_->update();
  if (!held_) between_events_.start();
  Q_EMIT moved();
}

void PageView::set_scale(double scale) {
  auto* bar = verticalScrollBar();
  const double before = bar->maximum() > 0 ? static_cast<double>(bar->value()) / bar->maximum() : 0;
  scale_ = std::clamp(scale, kLeastScale, kMostScale);
  lay_out();
  bar->setValue(static_cast<int>(std::lround(before * bar->maximum())));
}

void PageView::zoom(double factor) {
  fits_ = false;
  set_scale(scale_ * factor);
}

void PageView::fit_width() {
  fits_ = true;
  set_scale(scale_);
}

void PageView::hold(bool wait) {
  if (held_ == wait) return;
  held_ = wait;
  if (held_)
    between_events_.stop();
  else
    between_events_.start();
}

int PageView::next_to_paint() const {
  const QRect seen(0, verticalScrollBar()->value(), canvas_->width(), viewport()->height());
  for (int page = 0; page < pages(); ++page)
    if (place_of(page).intersects(seen) && sheets_[static_cast<std::size_t>(page)].scale != scale_)
      return page;
  return -1;
}

bool PageView::complete() const {
  return pages() > 0 && next_to_paint() < 0;
}

void PageView::paint_next() {
  const int page = next_to_paint();
  if (page < 0 || pages_ == nullptr) {
    under_way_.reset();
    between_events_.stop();
    return;
  }
  if (under_way_ == nullptr || under_way_page_ != page || under_way_scale_ != scale_) {
    under_way_page_ = page;
    under_way_scale_ = scale_;
    under_way_ =
        std::make_unique<reports::PagePicture>(*pages_, page, scale_ * devicePixelRatioF());
  }
  under_way_->paint_next();
  if (!under_way_->complete()) return;
  sheets_[static_cast<std::size_t>(page)] = {under_way_->image(), scale_};
  under_way_.reset();
  canvas_->update(place_of(page));
}

void PageView::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  lay_out();
}

void PageView::wheelEvent(QWheelEvent* event) {
  if ((event->modifiers() & Qt::ControlModifier) == 0) return QScrollArea::wheelEvent(event);
  constexpr double kStep = 1.15;
  zoom(event->angleDelta().y() > 0 ? kStep : 1.0 / kStep);
  event->accept();
}

void PageView::keyPressEvent(QKeyEvent* event) {
  auto* bar = verticalScrollBar();
  switch (event->key()) {
    case Qt::Key_Home: return bar->setValue(0);
    case Qt::Key_End: return bar->setValue(bar->maximum());
    default: QScrollArea::keyPressEvent(event);
  }
}

}  // namespace isograsp::gui
