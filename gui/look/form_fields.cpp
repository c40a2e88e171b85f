// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/form_fields.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QShortcut>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kFieldRow_px = 26;
constexpr int kMostFieldRows = 5;  // more are reached by scrolling

Date plus_days(Date date, int days) {
  return Date{std::chrono::sys_days(date) + std::chrono::days(days)};
}

}  // namespace

QLabel* caption(const QString& text, QWidget* field) {
  auto* label = new QLabel(text);
  label->setProperty("role", "quiet");
  if (field != nullptr) label->setBuddy(field);
  return label;
}

QString key_words(const QString& key) {
  return QKeySequence(key).toString(QKeySequence::NativeText);
}

void add_key(QWidget* widget, const QString& key, const std::function<void()>& act) {
  auto* shortcut = new QShortcut(QKeySequence(key), widget);
  shortcut->setContext(Qt::WidgetWithChildrenShortcut);
  QObject::connect(shortcut, &QShortcut::activated, widget, act);
}

SegmentedChoice::SegmentedChoice(const std::vector<Segment>& segments, QWidget* keys_of) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    auto* button = new QPushButton(segment.text);
    button->setObjectName(segment.object_name);
    button->setCheckable(true);
    describe(*button, segment.name,
             tr("%1; pressed again: not told (%2)").arg(segment.name, key_words(segment.key)));
    const int index = static_cast<int>(i);
    connect(button, &QPushButton::clicked, this, [this, index] { press(index); });
    add_key(keys_of, segment.key, [this, index] {
      if (isEnabled()) press(index);
    });
    row->addWidget(button, 1);
    buttons_.push_back(button);
  }
}

void SegmentedChoice::choose(std::optional<int> index) {
  chosen_ = index;
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i]->setChecked(index == static_cast<int>(i));
}

void SegmentedChoice::press(int index) {
  choose(chosen_ == index ? std::nullopt : std::optional(index));
  Q_EMIT chosen_by_user();
}

DateField::DateField(Ahead ahead) : ahead_(ahead) {
  setMaxLength(20);
  setMinimumWidth(scaled(112));
}

Typed<Date> DateField::typed() const {
  return typed_date(text(), local_today(), ahead_);
}

void DateField::show_date(std::optional<Date> date) {
  setText(date ? translated_date(iso_text(*date)) : QString());
}

void DateField::keyPressEvent(QKeyEvent* event) {
  const int days = event->key() == Qt::Key_Up ? 1 : event->key() == Qt::Key_Down ? -1 : 0;
  if (days == 0) {
    QLineEdit::keyPressEvent(event);
    return;
  }
  const Date today = local_today();
  Date next = today;
  if (const auto now = typed().value) next = plus_days(*now, days);
  if (ahead_ == Ahead::refused) next = std::min(next, today);
  selectAll();
  insert(translated_date(iso_text(next)));  // as if typed: Ctrl+Z takes it back
}

Remark::Remark() {
  setWordWrap(true);
  show_words({}, false);
}

void Remark::say(const QString& words) {
  show_words(words, false);
}

void Remark::warn(const QString& problem) {
  show_words(tr("⚠ %1").arg(problem), true);
}

void Remark::show_words(const QString& words, bool warns) {
  warns_ = warns;
  setText(words);
  setVisible(!words.isEmpty());
  setProperty("role", warns ? "problem" : "quiet");
  style()->unpolish(this);
  style()->polish(this);
}

DatedList::DatedList(const QString& name, const QString& title, const QStringList& columns,
                     const QString& empty, QWidget* keys_of) {
  table_ = new QTableWidget(0, columns.size());
  table_->setObjectName(name + "_list");
  describe(*table_, title,
           tr("%1, by date; the arrow keys choose one, Ctrl+Delete removes it").arg(title));
  table_->setHorizontalHeaderLabels(columns);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(columns.size() - 1, QHeaderView::Stretch);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(scaled(kFieldRow_px));
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setTabKeyNavigation(false);  // Tab leaves the list
  empty_ = new QLabel(empty);
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  remove_ = new QPushButton(tr("Remove"));
  remove_->setObjectName(name + "_remove");
  describe(*remove_, tr("Remove the chosen entry"),
           tr("Remove the chosen entry; it can be brought back (Ctrl+Delete)"));
  removed_ = new QLabel;
  removed_->setProperty("role", "quiet");
  removed_->setWordWrap(true);
  undo_ = new QPushButton(tr("Undo"));
  undo_->setObjectName(name + "_undo");
  describe(*undo_, tr("Bring back what was removed last"),
           tr("Bring back what was removed last (Ctrl+U)"));

  auto* below = new QHBoxLayout;
  below->setSpacing(8);
  below->addWidget(removed_, 1);
  below->addWidget(undo_);
  below->addStretch();
  below->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(empty_);
  column->addWidget(table_);
  column->addLayout(below);

  connect(remove_, &QPushButton::clicked, this, &DatedList::remove);
  connect(undo_, &QPushButton::clicked, this, &DatedList::undo_pressed);
  connect(table_, &QTableWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!table_->selectedItems().isEmpty()); });
  add_key(table_, "Delete", [this] { remove(); });
  add_key(keys_of, "Ctrl+Delete", [this] { remove(); });
  add_key(keys_of, "Ctrl+U", [this] {
    if (!undo_->isHidden()) Q_EMIT undo_pressed();
  });
  show_rows({});
  offer_undo({});
}

void DatedList::show_rows(const std::vector<QStringList>& rows) {
  const int before = table_->currentRow();
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row)
    for (int column = 0; column < table_->columnCount(); ++column) {
      const QString& text = rows[static_cast<std::size_t>(row)][column];
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(text);  // a long text is cut
      table_->setItem(row, column, item);
    }
  const int visible = std::min(table_->rowCount(), kMostFieldRows);
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         visible * scaled(kFieldRow_px) + 4);
  table_->setVisible(!rows.empty());
  empty_->setVisible(rows.empty());
  remove_->setVisible(!rows.empty());
  if (before >= 0 && !rows.empty())
    table_->selectRow(std::min(before, table_->rowCount() - 1));
  else
    table_->scrollToBottom();  // the newest
  remove_->setEnabled(!table_->selectedItems().isEmpty());
}

void DatedList::offer_undo(const QString& removed) {
  removed_->setText(removed);
  removed_->setVisible(!removed.isEmpty());
  undo_->setVisible(!removed.isEmpty());
}

void DatedList::remove() {
  const auto chosen = table_->selectedItems();
  if (!chosen.isEmpty()) Q_EMIT remove_pressed(chosen.front()->row());
}

DateField* entry_date(const QString& object_name, const QString& name, const QString& key,
                      Ahead ahead, QWidget* card) {
  auto* field = new DateField(ahead);
  field->setObjectName(object_name);
  describe(*field, name,
           QObject::tr("%1: year-month-day; Up and Down change it, Enter adds (%2)")
               .arg(name, key_words(key)));
  add_key(card, key, [field] { field->setFocus(); });
  field->show_date(local_today());
  return field;
}

QLineEdit* entry_text(const QString& object_name, const QString& name, const QString& hint) {
  constexpr int kLongest = 200;
  auto* field = new QLineEdit;
  field->setObjectName(object_name);
  field->setMaxLength(kLongest);
  field->setPlaceholderText(hint);
  describe(*field, name, QObject::tr("%1; Enter adds, Ctrl+Z takes back what was typed").arg(name));
  return field;
}

QPushButton* add_button(const QString& object_name, const QString& name, QWidget* card) {
  auto* button = new QPushButton(QObject::tr("Add"));
  button->setObjectName(object_name);
  describe(*button, name, QObject::tr("%1 (Ctrl+Enter)").arg(name));
  for (const char* key : {"Ctrl+Return", "Ctrl+Enter"})
    add_key(card, key, [button] {
      if (button->isEnabled()) button->click();
    });
  return button;
}

QString removed_words(const std::string& date, const QString& what) {
  return QObject::tr("Removed: %1, %2.").arg(translated_date(date), what);
}

}  // namespace isograsp::gui
