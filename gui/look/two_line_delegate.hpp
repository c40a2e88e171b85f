// SPDX-License-Identifier: GPL-3.0-or-later
// Entries of a list in two lines: a title with a mark at its right, and a quiet line below.
#pragma once

#include <QListWidget>
#include <QStyledItemDelegate>

namespace isograsp::gui {

struct TwoLines {
  QString title;
  QString mark;  ///< "SIMULATED"; may be empty
  QString below;
  bool doubtful = false;  ///< a warning sign stands before the second line
};

/// Adds an entry; all of it is read aloud and stands in its tooltip.
void add_two_lines(QListWidget& list, const TwoLines& lines);

class TwoLineDelegate final : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override;
};

}  // namespace isograsp::gui
