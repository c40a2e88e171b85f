// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/two_line_delegate.hpp"

#include <QPainter>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
enum LineRole { kMark = Qt::UserRole + 1, kBelow, kDoubtful };
constexpr int kLineEdge_px = 8;
constexpr int kAir_px = 4;  // above, between and below the lines
constexpr int kSign_px = 15;
}  // namespace

void add_two_lines(QListWidget& list, const TwoLines& lines) {
  auto* item = new QListWidgetItem(lines.title, &list);
  item->setData(kMark, lines.mark);
  item->setData(kBelow, lines.below);
  item->setData(kDoubtful, lines.doubtful);
  const auto all = lines.mark.isEmpty()
                       ? QObject::tr("%1. %2").arg(lines.title, lines.below)
                       : QObject::tr("%1, %2. %3").arg(lines.title, lines.mark, lines.below);
  item->setData(Qt::AccessibleTextRole, all);
  item->setToolTip(all);
}

void TwoLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  const bool chosen = option.state.testFlag(QStyle::State_Selected);
  const bool under_mouse = option.state.testFlag(QStyle::State_MouseOver);
  const QRectF area = QRectF(option.rect).adjusted(2, 1, -2, -1);
  if (chosen || under_mouse) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(chosen ? look::kChosen : look::kHover);
    painter->drawRoundedRect(area, 4, 4);
  }
  if (chosen) {  // the colour alone would not tell it
    painter->setBrush(look::kAccent);
    painter->drawRoundedRect(QRectF(area.left(), area.top() + 4, 3, area.height() - 8), 1.5, 1.5);
  }
  QFont bold = option.font;
  bold.setBold(true);
  QFont small = option.font;
  small.setPointSizeF(option.font.pointSizeF() - 1.0);
  const QFontMetrics title_size(bold);
  const QFontMetrics small_size(small);
  QRect line = option.rect.adjusted(kLineEdge_px, kAir_px, -kLineEdge_px, 0);
  line.setHeight(title_size.height());
  const auto mark = index.data(kMark).toString();
  QFont small_bold = small;
  small_bold.setBold(true);
  const int mark_px = mark.isEmpty() ? 0 : QFontMetrics(small_bold).horizontalAdvance(mark) + 6;
  painter->setPen(look::kText);
  painter->setFont(small_bold);
  painter->drawText(line, Qt::AlignRight | Qt::AlignVCenter, mark);
  painter->setFont(bold);
  painter->drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      title_size.elidedText(index.data().toString(), Qt::ElideRight, line.width() - mark_px));
  line.moveTop(line.bottom() + kAir_px / 2);
  line.setHeight(small_size.height());
  if (index.data(kDoubtful).toBool()) {
    const QRectF sign(line.left(), line.top() + 1, scaled(kSign_px) - 4, line.height() - 3);
    painter->setPen(Qt::NoPen);
    painter->setBrush(look::kAttention);
    painter->drawPolygon(
        polygon({QPointF(sign.center().x(), sign.top()), sign.bottomRight(), sign.bottomLeft()}));
    line.setLeft(line.left() + scaled(kSign_px));
  }
  painter->setPen(look::kQuietText);
  painter->setFont(small);
  painter->drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      small_size.elidedText(index.data(kBelow).toString(), Qt::ElideRight, line.width()));
  painter->restore();
}

QSize TwoLineDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
  const int line_px = option.fontMetrics.height();
  return {0, 2 * line_px + 3 * kAir_px - 2};
}

}  // namespace isograsp::gui
