// SPDX-License-Identifier: GPL-3.0-or-later
// What the library page looks like and which key does what; its acts: library_page_acts.cpp.
#include "gui/library_pages/library_page.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/look/form_fields.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kLibraryRow_px = 24;
constexpr int kList_px = 284;
constexpr int kView_px = 350;

QPushButton* make_button(const QString& text, const char* name, const QString& title,
                         const QString& tooltip) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  describe(*button, title, tooltip);
  return button;
}

/// Keys and clicks pass over it.
void add_heading(const QString& words, QListWidget& list) {
  auto* item = new QListWidgetItem(words, &list);
  QFont font = list.font();
  font.setBold(true);
  item->setFont(font);
  item->setForeground(look::kQuietText);
  item->setFlags(Qt::NoItemFlags);
  item->setSizeHint({0, scaled(kLibraryRow_px)});
}

}  // namespace

LibraryPage::LibraryPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      clinic_(clinic),
      presenter_(presenter),
      files_(presenter.state().config.library,
             session::own_library_folder(presenter.state().config.database)) {
  postures_ = new PostureDesk(presenter_, this);
  auto* row = new QBoxLayout(side_by_side(), this);
  row->setContentsMargins(12, 12, 12, 12);
  row->setSpacing(10);
  auto* list = make_list();
  if (row->direction() == QBoxLayout::LeftToRight) list->setFixedWidth(scaled(kList_px));
  row->addWidget(list);
  row->addWidget(make_editor(), 3);
  row->addWidget(make_pictures(), 2);
  constexpr int kCheckAfter_ms = 300;
  constexpr int kKeepAfter_ms = 1000;
  check_soon_.setSingleShot(true);
  check_soon_.setInterval(kCheckAfter_ms);
  draft_soon_.setSingleShot(true);
  draft_soon_.setInterval(kKeepAfter_ms);
  connect(&check_soon_, &QTimer::timeout, this, &LibraryPage::check);
  connect(&draft_soon_, &QTimer::timeout, this, &LibraryPage::keep_draft_now);
  add_keys();
  refresh();
}

LibraryPage::~LibraryPage() = default;

QWidget* LibraryPage::make_list() {
  auto* card = new Card(tr("Library"));
  auto* kinds = new QGridLayout;
  kinds->setSpacing(4);
  const std::array<std::array<QString, 3>, kLibraryKindCount> words{
      {{tr("&Tasks"), tr("Tasks"), tr("What the patient is asked to do (Alt+T)")},
       {tr("&Scenes"), tr("Scenes"), tr("Objects that a task can have (Alt+S)")},
       {tr("&Protocols"), tr("Protocols"), tr("What sessions consist of (Alt+P)")},
       {tr("P&ostures"), tr("Postures"), tr("What an arm is asked to do with an object (Alt+O)")}}};
  for (std::size_t k = 0; k < kLibraryKindCount; ++k) {
    const auto kind = static_cast<LibraryKind>(k);
    kinds_[k] = make_button(words[k][0], "", words[k][1], words[k][2]);
    kinds_[k]->setObjectName(QStringLiteral("library_") +
                             QString::fromStdString(std::string(folder_of(kind))));
    kinds_[k]->setCheckable(true);
    kinds_[k]->setProperty("tight", true);
    connect(kinds_[k], &QPushButton::clicked, this, [this, kind] { show_kind(kind); });
    constexpr std::size_t kBeside = 2;
    kinds->addWidget(kinds_[k], static_cast<int>(k / kBeside), static_cast<int>(k % kBeside));
  }
  search_ = new QLineEdit;
  search_->setObjectName("library_search");
  search_->setPlaceholderText(tr("Search"));
  search_->setClearButtonEnabled(true);
  describe(*search_, tr("Search the library"), tr("Any part of the name or of the file (Alt+F)"));
  connect(search_, &QLineEdit::textChanged, this, &LibraryPage::fill_list);
  list_ = new QListWidget;
  list_->setObjectName("library_list");
  describe(*list_, tr("Files of the library"),
           tr("Arrow keys choose one, Enter goes to its text (Alt+I)"));
  take_rest(*list_, 6 * kLibraryRow_px);
  connect(list_, &QListWidget::currentRowChanged, this, &LibraryPage::choose_row);
  connect(list_, &QListWidget::itemActivated, this, &LibraryPage::focus_body);
  bring_back_ = make_button(tr("&Bring back"), "library_bring_back", tr("Bring back"),
                            tr("The file that was removed last (Alt+B)"));
  bring_back_->hide();
  connect(bring_back_, &QPushButton::clicked, this, &LibraryPage::bring_back);
  card->column().addLayout(kinds);
  card->column().addWidget(search_);
  card->column().addWidget(list_, 1);
  card->column().addWidget(bring_back_);
  return card;
}

QWidget* LibraryPage::make_editor() {
  auto* card = new Card({});
  auto& column = card->column();
  name_ = card->findChild<QLabel*>();
  name_->setObjectName("library_name");
  name_->setWordWrap(true);
  place_ = new QLabel;
  place_->setObjectName("library_place");
  place_->setProperty("role", "quiet");
  place_->setWordWrap(true);
  duplicate_ = make_button(tr("&Duplicate"), "library_duplicate", tr("Duplicate"),
                           tr("An own file with this text under a new name (Alt+D)"));
  save_ = make_button(tr("Sa&ve"), "library_save", tr("Save"),
                      tr("Sessions use it from now on; what a stored trial used is kept (Ctrl+S)"));
  revert_ = make_button(tr("&Revert"), "library_revert", tr("Revert"),
                        tr("What was saved last; Undo brings your text back (Alt+R)"));
  remove_ = make_button(tr("Re&move"), "library_remove", tr("Remove"),
                        tr("Puts this own file away; it can be brought back (Alt+M)"));
  undo_ = make_button(QStringLiteral("↶"), "library_undo", tr("Undo"), tr("Undo (Ctrl+Z)"));
  redo_ = make_button(QStringLiteral("↷"), "library_redo", tr("Redo"), tr("Redo (Ctrl+Shift+Z)"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(6);
  for (auto* button : {duplicate_, save_, revert_, undo_, redo_}) buttons->addWidget(button);
  buttons->addStretch(1);
  buttons->addWidget(remove_);
  remark_ = new QLabel;
  remark_->setObjectName("library_remark");
  remark_->setWordWrap(true);
  remark_->hide();
  editor_ = new TomlEditor;
  editor_->setObjectName("library_editor");
  describe(*editor_, tr("Text of the file"),
           tr("Ctrl+Z undoes, Ctrl+Shift+Z redoes; Tab leaves the text (Alt+X)"));
  take_rest(*editor_, 160);
  problem_ = new QLabel;
  problem_->setObjectName("library_problem");
  problem_->setWordWrap(true);
  problem_->setTextInteractionFlags(Qt::LinksAccessibleByMouse);
  go_to_ = make_button(tr("&Go to line"), "library_go_to", tr("Go to the line of the problem"),
                       tr("The cursor to the line that the reader refuses (Alt+G)"));
  auto* verdict = new QHBoxLayout;
  verdict->setSpacing(8);
  verdict->addWidget(problem_, 1);
  verdict->addWidget(go_to_);
  column.addWidget(place_);
  column.addLayout(buttons);
  column.addWidget(remark_);
  body_ = new QStackedWidget;
  body_->addWidget(editor_);
  body_->addWidget(&postures_->editor());
  column.addWidget(body_, 1);
  column.addLayout(verdict);
  watch_editor();
  return card;
}

/// What the file will be; of postures pictures, and below them the same in words.
QWidget* LibraryPage::make_pictures() {
  auto* pictures = new QWidget;
  pictures->setMinimumWidth(scaled(kView_px));
  auto* column = new QVBoxLayout(pictures);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  view_ = new LibraryView;
  column->addWidget(&postures_->view(), 3);
  column->addWidget(view_, 1);
  postures_->view().hide();
  return pictures;
}

void LibraryPage::watch_editor() {
  connect(duplicate_, &QPushButton::clicked, this, &LibraryPage::duplicate);
  connect(save_, &QPushButton::clicked, this, &LibraryPage::save);
  connect(revert_, &QPushButton::clicked, this, &LibraryPage::revert);
  connect(remove_, &QPushButton::clicked, this, &LibraryPage::remove);
  connect(undo_, &QPushButton::clicked, editor_, &QPlainTextEdit::undo);
  connect(redo_, &QPushButton::clicked, editor_, &QPlainTextEdit::redo);
  connect(go_to_, &QPushButton::clicked, this, [this] {
    if (error_ && error_->line) editor_->go_to_line(*error_->line);
  });
  connect(postures_, &PostureDesk::edited, this, [this](const QString& text) {
    if (!editor_->isReadOnly()) editor_->replace_text(text);
  });
  connect(postures_, &PostureDesk::new_file, this, &LibraryPage::add_file);
  connect(postures_, &PostureDesk::said, this, &LibraryPage::say);
  connect(problem_, &QLabel::linkActivated, go_to_, &QPushButton::click);
  connect(editor_, &QPlainTextEdit::textChanged, this, &LibraryPage::text_changed);
  connect(editor_->document(), &QTextDocument::undoAvailable, this, &LibraryPage::refresh);
  connect(editor_->document(), &QTextDocument::redoAvailable, this, &LibraryPage::refresh);
}

void LibraryPage::add_keys() {
  add_key(this, "Ctrl+S", [this] { save_->click(); });
  add_key(this, "Alt+F", [this] { search_->setFocus(); });
  add_key(this, "Alt+I", [this] { list_->setFocus(); });
  add_key(this, "Alt+X", [this] { focus_body(); });
  for (QWidget* widget :
       {static_cast<QWidget*>(&postures_->editor()), static_cast<QWidget*>(&postures_->view())}) {
    add_key(widget, "Ctrl+Z", [this] { undo_->click(); });
    add_key(widget, "Ctrl+Shift+Z", [this] { redo_->click(); });
  }
}

void LibraryPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  list_files(entry_ ? entry_->path : "");
}

void LibraryPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  keep_draft_now();
}

/// Own ones under a heading of their own, shipped ones by group.
void LibraryPage::fill_list() {
  const QSignalBlocker quiet(list_);
  list_->clear();
  const auto wanted = search_->text().trimmed();
  QString above;
  QString heading;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto& entry = entries_[i];
    const auto name = QString::fromStdString(entry.name);
    if (!name.contains(wanted, Qt::CaseInsensitive) &&
        !QString::fromStdString(entry.path).section('/', -1).contains(wanted, Qt::CaseInsensitive))
      continue;
    const auto part = entry.own ? tr("Own") : tr("Shipped, read-only");
    if (part != above) add_heading(part, *list_);
    above = part;
    const auto group = QString::fromStdString(entry.group);
    if (group != heading && !group.isEmpty()) add_heading(group, *list_);
    heading = group;
    const auto mark = !entry.sound ? QStringLiteral("⚠ ") : entry.draft ? QStringLiteral("● ") : "";
    auto* item = new QListWidgetItem(QStringLiteral("   ") + mark + name, list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setSizeHint({0, scaled(kLibraryRow_px)});
    QStringList words{name};
    if (!entry.sound) words << tr("cannot be used");
    if (entry.draft) words << tr("has unsaved changes");
    item->setToolTip(words.join(QStringLiteral(", ")));
    item->setData(Qt::AccessibleTextRole, words.join(QStringLiteral(", ")));
    if (entry_ && entry.path == entry_->path) list_->setCurrentItem(item);
  }
}

void LibraryPage::refresh() {
  for (std::size_t k = 0; k < kLibraryKindCount; ++k)
    kinds_[k]->setChecked(static_cast<LibraryKind>(k) == kind_);
  const bool own = entry_ && entry_->own;
  const bool changed = modified();
  name_->setText(!entry_   ? tr("Choose a file.")
                 : changed ? tr("%1 – not saved").arg(QString::fromStdString(entry_->name))
                           : QString::fromStdString(entry_->name));
  place_->setText(!entry_ ? QString()
                  : own   ? QString::fromStdString(entry_->path)
                          : tr("Shipped: it stays as it is. Duplicate it to change it."));
  editor_->setReadOnly(!own || !loaded_ || saving_);
  editor_->setEnabled(entry_.has_value());
  show_body();
  duplicate_->setEnabled(loaded_);
  mark_next(*duplicate_, loaded_ && !own);
  save_->setEnabled(changed && checked_ && !error_ && !saving_);
  mark_next(*save_, save_->isEnabled());
  revert_->setEnabled(changed && !saving_);
  remove_->setEnabled(own && !saving_);
  undo_->setEnabled(own && editor_->document()->isUndoAvailable());
  redo_->setEnabled(own && editor_->document()->isRedoAvailable());
  remark_->setVisible(!remark_->text().isEmpty());
  bring_back_->setVisible(removed_.has_value());
  if (removed_)
    bring_back_->setText(tr("&Bring back: %1").arg(QString::fromStdString(removed_->entry.name)));
}

void LibraryPage::show_body() {
  // While a file of postures is being read the form waits for it.
  if (kind_ == LibraryKind::postures && entry_ && !loaded_ && !error_) return;
  const bool form = kind_ == LibraryKind::postures && entry_ && loaded_ &&
                    postures_->show_text(text(), entry_->path, entry_->own && !saving_, modified());
  if (!form) postures_->leave();
  body_->setCurrentIndex(form ? 1 : 0);
  postures_->view().setVisible(form);
}

void LibraryPage::focus_body() {
  body_->currentWidget()->setFocus();
}

void LibraryPage::say(const QString& words) {
  remark_->setText(words);
  refresh();
}

}  // namespace isograsp::gui
