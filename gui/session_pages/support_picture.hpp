// SPDX-License-Identifier: GPL-3.0-or-later
// Which support is to be pressed and in which direction, as a picture: the platform seen by the
// patient, thumb and fingers facing each other, and one arrow.
#pragma once

#include <QWidget>
#include <optional>

#include "device/sensors/device_check.hpp"

namespace isograsp::gui {

class SupportPicture final : public QWidget {
  Q_OBJECT

 public:
  explicit SupportPicture(QWidget* parent = nullptr);
  /// Nothing: the supports without an arrow.
  void show_step(std::optional<CheckStep> step, Hand hand);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::optional<CheckStep> step_;
  Hand hand_ = Hand::right;
};

}  // namespace isograsp::gui
