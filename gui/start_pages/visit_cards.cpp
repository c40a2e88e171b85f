// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/start_pages/visit_cards.hpp"

#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kCardWide_px = 344;  // at least
constexpr int kCardHigh_px = 136;  // with what keeps it apart from the next one

/// A card paints itself.
class NothingBelow final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter*, const QStyleOptionViewItem&, const QModelIndex&) const override {}
};

}  // namespace

VisitCards::VisitCards(const DayBook& book, QWidget* parent) : QListWidget(parent), book_(book) {
  setObjectName("patient_list");
  setProperty("plain", true);
  viewport()->setAutoFillBackground(false);
  setItemDelegate(new NothingBelow(this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  verticalScrollBar()->setSingleStep(scaled(kCardHigh_px) / 4);
  connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
    show_chosen();
    if (row >= 0) Q_EMIT chosen(item(row)->text());
  });
  connect(this, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { Q_EMIT begin_pressed(item->text()); });
}

VisitCard* VisitCards::card_at(int row) const {
  return qobject_cast<VisitCard*>(itemWidget(item(row)));
}

void VisitCards::show_people(const std::vector<Shown>& people) {
  auto most = people;
  if (most.size() > kMost) most.resize(kMost);
  const bool same = std::equal(most.begin(), most.end(), people_.begin(), people_.end(),
                               [](const Shown& a, const Shown& b) {
                                 return a.person.patient.code == b.person.patient.code;
                               });
  people_ = std::move(most);
  if (same) {  // the cards stay: somebody may be pressing one
    for (int row = 0; row < count(); ++row) say(row);
    return;
  }
  const QSignalBlocker quiet(this);
  const QString before = currentItem() == nullptr ? QString() : currentItem()->text();
  clear();
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const auto code = QString::fromStdString(people_[i].person.patient.code);
    auto* item = new QListWidgetItem(code, this);
    auto* card = new VisitCard;
    card->allow(may_begin_, may_open_);
    setItemWidget(item, card);
    connect(card, &VisitCard::begin_pressed, this, [this, code] { Q_EMIT begin_pressed(code); });
    connect(card, &VisitCard::open_pressed, this, [this, code] { Q_EMIT open_pressed(code); });
    connect(card, &VisitCard::remove_pressed, this, [this, code] { Q_EMIT remove_pressed(code); });
    say(static_cast<int>(i));
  }
  arrange();
  choose(before);
}

void VisitCards::say(int row) {
  const Shown& shown = people_[static_cast<std::size_t>(row)];
  const DayCard* read = book_.card(shown.person.patient.code);
  const CardWords words = words_of(shown.person, shown.name, read);
  card_at(row)->show_person(shown.person, words, read);
  item(row)->setToolTip(words.aloud());
  item(row)->setData(Qt::AccessibleTextRole, words.aloud());
}

void VisitCards::renew(const QString& code) {
  for (int row = 0; row < count(); ++row)
    if (item(row)->text() == code) say(row);
}

void VisitCards::choose(const QString& code) {
  if (code == (currentItem() == nullptr ? QString() : currentItem()->text())) return show_chosen();
  const QSignalBlocker quiet(this);
  setCurrentRow(-1);  // nobody, so that a click on any card chooses
  for (int row = 0; row < count(); ++row)
    if (item(row)->text() == code) setCurrentRow(row);
  show_chosen();
}

void VisitCards::show_chosen() {
  for (int row = 0; row < count(); ++row) card_at(row)->show_chosen(row == currentRow());
}

void VisitCards::allow(bool begin, bool open) {
  may_begin_ = begin;
  may_open_ = open;
  for (int row = 0; row < count(); ++row) card_at(row)->allow(begin, open);
}

void VisitCards::mark_begin(bool next) {
  for (int row = 0; row < count(); ++row)
    mark_next(card_at(row)->begin(), next && row == currentRow());
}

void VisitCards::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  arrange();
}

/// As many columns as have room, all of the same width.
void VisitCards::arrange() {
  const int room_px = viewport()->width() - 1;
  const int columns = std::max(1, room_px / scaled(kCardWide_px));
  const QSize cell(room_px / columns, scaled(kCardHigh_px));
  setGridSize(cell);
  for (int row = 0; row < count(); ++row) item(row)->setSizeHint(cell);
}

}  // namespace isograsp::gui
