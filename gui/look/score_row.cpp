// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/score_row.hpp"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVariant>

#include "gui/look/look.hpp"

namespace isograsp::gui {

ScoreRow::ScoreRow(const QString& name, const QString& question, QWidget* parent)
    : ScoreRow(name, question, Scale(), parent) {}

ScoreRow::ScoreRow(const QString& name, const QString& question, Scale scale, QWidget* parent)
    : QWidget(parent), numbers_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(1);
  constexpr int kLeast_px = 28;
  setMinimumHeight(scaled(kLeast_px));
  for (int value = scale.least; value <= scale.most; ++value) {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("%1_%2").arg(name).arg(value));
    button->setText(QString::number(value));
    button->setCheckable(true);
    button->setProperty("score", true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFocusPolicy(value == scale.least ? Qt::StrongFocus : Qt::ClickFocus);
    describe(*button, tr("%1: %2 of %3").arg(question).arg(value).arg(scale.most),
             tr("%1: %2 of %3 (Tab, then arrow keys)").arg(question).arg(value).arg(scale.most));
    numbers_->addButton(button, value);
    constexpr int kBesideDigits_px = 4;
    button->ensurePolished();  // its letters are those of the style
    button->setMinimumWidth(button->fontMetrics().horizontalAdvance(button->text()) +
                            kBesideDigits_px);
    row->addWidget(button);
  }
  connect(numbers_, &QButtonGroup::idClicked, this, &ScoreRow::chosen);
}

void ScoreRow::show_value(std::optional<int> value) {
  if (value && numbers_->checkedId() == *value) return;
  numbers_->setExclusive(false);
  for (auto* button : numbers_->buttons()) button->setChecked(value == numbers_->id(button));
  numbers_->setExclusive(true);
}

}  // namespace isograsp::gui
