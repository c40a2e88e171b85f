// SPDX-License-Identifier: GPL-3.0-or-later
// A flat page of the patient's screen, as a widget of another window.
#pragma once

#include <QPaintEvent>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "gui/patient_screen/patient_canvas.hpp"

namespace isograsp::gui {

class PagePicture final : public QWidget {
 public:
  using QWidget::QWidget;

  /// @pre picture.page is flat (paint_page)
  void show_picture(PatientPicture picture) {
    picture_ = std::move(picture);
    update();
  }

 protected:
  /// In the proportions of a screen, in the middle.
  void paintEvent(QPaintEvent*) override {
    constexpr double kScreen = 16.0 / 9.0;
    const double height = std::min(static_cast<double>(this->height()), width() / kScreen);
    QPainter painter(this);
    paint_page(painter,
               QRectF((width() - kScreen * height) / 2, (this->height() - height) / 2,
                      kScreen * height, height),
               picture_);
  }

 private:
  PatientPicture picture_;
};

}  // namespace isograsp::gui
