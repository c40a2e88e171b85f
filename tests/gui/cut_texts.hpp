// SPDX-License-Identifier: GPL-3.0-or-later
// Which texts of a window are cut off because they have less room than they need.
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QPointer>
#include <set>
#include <string>

#include "qt_test.hpp"

namespace isograsp::gui::test {

/// What a text in one line needs; the numbers of a score stand close, without the air of a button.
inline int needed_px(const QWidget& widget) {
  const auto text = widget.property("text").toString();
  if (widget.property("score").toBool()) return widget.fontMetrics().horizontalAdvance(text) + 4;
  return widget.sizeHint().width();
}

/// Questions and acts that appear only at times take their place.
inline void show_hidden_controls(QWidget& page) {
  for (auto* widget : page.findChildren<QWidget*>()) {
    const bool control = qobject_cast<QAbstractButton*>(widget) != nullptr ||
                         qobject_cast<QLabel*>(widget) != nullptr ||
                         widget->property("confirm").toBool();
    if (control && widget->isHidden() && widget->parentWidget()->isVisible()) widget->show();
  }
}

/// Labels and buttons in one line that need more room than they have.
inline std::set<std::string> cut_texts(QWidget& window, const std::string& page, int& seen) {
  std::set<std::string> cut;
  QList<QPointer<QWidget>> widgets;
  for (auto* widget : window.findChildren<QWidget*>()) widgets << widget;
  for (const auto& widget : widgets) {
    if (widget == nullptr || !widget->isVisible()) continue;
    const auto* label = qobject_cast<QLabel*>(widget.data());
    const auto* button = qobject_cast<QAbstractButton*>(widget.data());
    if (label != nullptr && (label->wordWrap() || label->text().isEmpty())) continue;
    if (button != nullptr && button->text().isEmpty()) continue;
    if (label == nullptr && button == nullptr) continue;
    if (widget->sizePolicy().horizontalPolicy() == QSizePolicy::Ignored) continue;  // elided
    ++seen;
    // What a page reads in the background may just have made a text bold.
    constexpr int kLaidOutWithin_s = 2;
    const bool fits =
        wait_until([&] { return widget == nullptr || needed_px(*widget) <= widget->width(); },
                   kLaidOutWithin_s);
    if (!fits)
      cut.insert(page + ": " + widget->property("text").toString().toStdString() + " (" +
                 std::to_string(widget->width()) + " of " + std::to_string(needed_px(*widget)) +
                 " px)");
  }
  return cut;
}

}  // namespace isograsp::gui::test
