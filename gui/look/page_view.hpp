// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a report as they will be written, one below the other. Painted in steps of some
// milliseconds between other events, what is seen first; nothing is written anywhere.
#pragma once

#include <QImage>
#include <QScrollArea>
#include <QTimer>
#include <memory>
#include <vector>

#include "reports/paper/report_pages.hpp"

namespace isograsp::gui {

class PageView final : public QScrollArea {
  Q_OBJECT

 public:
  explicit PageView(QWidget* parent = nullptr);
  ~PageView() override;

  /// Null: none.
  void show_pages(std::shared_ptr<const reports::ReportPages> pages);
  [[nodiscard]] int pages() const noexcept { return static_cast<int>(sheets_.size()); }
  [[nodiscard]] int page() const;  ///< in the middle of the view, from 1; 0: none
  /// Larger (above 1) or smaller; from then on the width of the window no longer counts.
  void zoom(double factor);
  void fit_width();
  [[nodiscard]] double scale() const noexcept { return scale_; }  ///< pixels per point
  /// No painting while a trial needs an even picture.
  void hold(bool wait);
  /// The visible pages are painted at this scale.
  [[nodiscard]] bool complete() const;

 Q_SIGNALS:
  void moved();  ///< page(), pages() or scale()

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  class Sheets;
  struct Sheet {
    QImage image;
    double scale = 0.0;  ///< that it was painted at; 0: not yet
  };

  [[nodiscard]] QRect place_of(int page) const;
  [[nodiscard]] int next_to_paint() const;
  void set_scale(double scale);
  void lay_out();
  void paint_next();

  std::shared_ptr<const reports::ReportPages> pages_;
  std::vector<Sheet> sheets_;
  std::unique_ptr<reports::PagePicture> under_way_;
  int under_way_page_ = -1;
  double under_way_scale_ = 0.0;
  double scale_ = 1.0;
  bool fits_ = true;
  bool held_ = false;
  Sheets* canvas_;
  QTimer between_events_;
};

}  // namespace isograsp::gui
