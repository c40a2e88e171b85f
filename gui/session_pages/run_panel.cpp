// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/run_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStyle>
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <tuple>
#include <utility>

#include "gui/library/task_groups.hpp"
#include "gui/look/look.hpp"
#include "gui/presenter/next_words.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

QString kept_words(const Rating::Answer& answer) {
  if (answer.shoulder_pain)
    return RatingPanel::tr("Kept: effort %1, pain %2, shoulder %3. Another number corrects it.")
        .arg(answer.effort)
        .arg(answer.pain)
        .arg(*answer.shoulder_pain);
  return RatingPanel::tr("Kept: effort %1, pain %2. Another number corrects it.")
      .arg(answer.effort)
      .arg(answer.pain);
}

QString correct_words(const Rating::Answer& answer) {
  if (answer.shoulder_pain)
    return RatingPanel::tr("Correct: effort %1, pain %2, shoulder %3")
        .arg(answer.effort)
        .arg(answer.pain)
        .arg(*answer.shoulder_pain);
  return RatingPanel::tr("Correct: effort %1, pain %2").arg(answer.effort).arg(answer.pain);
}

}  // namespace

RunPanel::RunPanel(SessionPresenter& presenter, QWidget* parent)
    : Card({}, parent), presenter_(presenter) {
  title_->setText(tr("Now"));
  make_choice();
  make_next();
  make_buttons();
  make_between();
  connect(&presenter_.flow(), &SessionFlow::changed, this, &RunPanel::refresh);
  connect(&presenter_.flow(), &SessionFlow::library_changed, this, [this] {
    fill_list();
    refresh();
  });
  connect(&presenter_.flow(), &SessionFlow::frame, this, &RunPanel::refresh_progress);
  refresh();
  refresh_progress();
}

/// The protocol, or one task of the list.
void RunPanel::make_choice() {
  follow_ = new QPushButton(tr("Prot&ocol"));
  follow_->setObjectName("follow_protocol");
  follow_->setCheckable(true);
  describe(*follow_, tr("Follow the protocol"), tr("The protocol says what comes (Alt+O)"));
  by_hand_ = new QPushButton(tr("One &task"));
  by_hand_->setObjectName("by_hand");
  by_hand_->setCheckable(true);
  describe(*by_hand_, tr("Choose one task"),
           tr("Choose a task yourself; the protocol waits meanwhile (Alt+T)"));
  auto* mode = new QHBoxLayout;
  mode->setSpacing(6);
  mode->addWidget(follow_);
  mode->addWidget(by_hand_);
  list_ = new QListWidget;
  list_->setObjectName("tasks");
  describe(*list_, tr("Tasks"), tr("Choose what the patient will do (Alt+T, then arrow keys)"));
  fill_list();
  column_->addLayout(mode);
  column_->addWidget(list_, 1);
  connect(follow_, &QPushButton::clicked, this, [this] {
    presenter_.protocol().follow();
    refresh();
  });
  connect(by_hand_, &QPushButton::clicked, this, [this] {
    presenter_.protocol().choose_by_hand();
    refresh();
    list_->setFocus();
  });
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr && item->data(Qt::UserRole).isValid())
      presenter_.tasks().choose(item->data(Qt::UserRole).toInt());
  });
}

/// What comes next, and how it is done.
void RunPanel::make_next() {
  next_ = new QLabel;
  next_->setObjectName("next_task");
  next_->setProperty("role", "title");
  next_->setWordWrap(true);
  instruction_ = new QLabel;
  instruction_->setObjectName("instruction");
  instruction_->setProperty("role", "quiet");
  instruction_->setWordWrap(true);
  instruction_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  practice_ = new QCheckBox(tr("Practice, not an assess&ment"));
  practice_->setObjectName("practice");
  describe(*practice_, tr("Practice trial"),
           tr("A practice trial is recorded but counts for no assessment (Alt+M)"));
  by_itself_ = new QCheckBox(tr("Goes on by itsel&f"));
  by_itself_->setObjectName("by_itself");
  describe(*by_itself_, tr("The protocol goes on by itself"),
           tr("After a rest the next trial begins without a press; F9 holds it (Alt+F)"));
  show_how_ = new QPushButton;
  show_how_->setObjectName("show_how");
  not_shown_ = new QLabel;
  not_shown_->setObjectName("not_shown");
  not_shown_->setProperty("role", "quiet");
  not_shown_->setWordWrap(true);
  not_shown_->hide();
  for (QWidget* widget : std::initializer_list<QWidget*>{next_, instruction_, practice_, by_itself_,
                                                         show_how_, not_shown_})
    column_->addWidget(widget);
  connect(practice_, &QCheckBox::toggled, this,
          [this](bool practice) { presenter_.tasks().set_practice(practice); });
  connect(by_itself_, &QCheckBox::toggled, this,
          [this](bool by_itself) { presenter_.protocol().set_by_itself(by_itself); });
  connect(show_how_, &QPushButton::clicked, this, [this] { presenter_.tasks().show_how(); });
}

/// Start, pause, and the end where nothing is left to start.
void RunPanel::make_buttons() {
  const auto make = [this](const char* name, int height_px, const QString& text = {}) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setMinimumHeight(scaled(height_px));
    column_->addWidget(button);
    return button;
  };
  start_ = make("start", 38, tr("&Start"));
  end_report_ = make("end_report", 38, tr("Write the report …"));
  describe(*end_report_, tr("Write the report"),
           tr("The report of this patient, on its page (Ctrl+R)"));
  end_disconnect_ = make("end_disconnect", 32, tr("Disconnect"));
  describe(*end_disconnect_, tr("Disconnect: end the session"),
           tr("End the session and disconnect (Tab, then Enter)"));
  pause_ = make("pause", 32);
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  describe(*progress_, tr("Progress of the trial"), tr("How much of the trial is over"));
  hint_ = new QLabel;
  hint_->setObjectName("start_hint");
  hint_->setProperty("role", "quiet");
  hint_->setWordWrap(true);
  column_->addWidget(progress_);
  column_->addWidget(hint_);
  connect(start_, &QPushButton::clicked, this, [this] { presenter_.trials().start(); });
  connect(end_report_, &QPushButton::clicked, this, &RunPanel::report_wanted);
  connect(end_disconnect_, &QPushButton::clicked, this,
          [this] { presenter_.connecting().disconnect_device(); });
  connect(pause_, &QPushButton::clicked, this, &RunPanel::pause_or_go_on);
}

void RunPanel::pause_or_go_on() {
  const auto& view = presenter_.flow().view();
  if (view.may_pause)
    presenter_.trials().pause();
  else if (view.may_resume)
    presenter_.trials().resume();
  else
    presenter_.protocol().stand_by();
}

/// What a therapist does between two trials: difficulty, repeat, skip, helped, a note.
void RunPanel::make_between() {
  const auto make = [](const QString& text, const char* name, const QString& full,
                       const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    describe(*button, full, tip);
    return button;
  };
  easier_ = make(tr("Easier"), "easier", tr("Make the task easier"),
                 tr("The next trial is one step easier (Ctrl+Minus)"));
  harder_ = make(tr("Harder"), "harder", tr("Make the task harder"),
                 tr("The next trial is one step harder (Ctrl+Plus)"));
  level_ = new QLabel;
  level_->setObjectName("level");
  level_->setAlignment(Qt::AlignCenter);
  repeat_ = make(tr("Repeat"), "repeat", tr("Repeat the last trial"),
                 tr("The last trial once more, beside the protocol (Ctrl+Shift+R)"));
  skip_ = make(tr("Skip"), "skip", tr("Skip the next step of the protocol"),
               tr("The next task is not asked for; this is noted (Ctrl+K)"));
  helped_ = make(tr("&Helped"), "helped", tr("The therapist helps or helped in this trial"),
                 tr("Such a trial is kept but counts for no assessment (Alt+H)"));
  helped_->setCheckable(true);
  note_ = new QLineEdit;
  note_->setObjectName("note");
  note_->setPlaceholderText(tr("Note, then Enter"));
  note_->setMaxLength(500);
  describe(*note_, tr("Note at this moment"),
           tr("A remark at this moment, kept with the session (Ctrl+N); Ctrl+M: a mark only"));
  auto* levels = new QHBoxLayout;
  levels->setSpacing(6);
  levels->addWidget(easier_);
  levels->addWidget(level_, 1);
  levels->addWidget(harder_);
  auto* trials = new QHBoxLayout;
  trials->setSpacing(6);
  trials->addWidget(repeat_);
  trials->addWidget(skip_);
  trials->addWidget(helped_);
  column_->addLayout(levels);
  column_->addLayout(trials);
  column_->addWidget(note_);
  column_->addStretch(0);
  connect(easier_, &QPushButton::clicked, this,
          [this] { presenter_.tasks().adjust_difficulty(-1); });
  connect(harder_, &QPushButton::clicked, this,
          [this] { presenter_.tasks().adjust_difficulty(+1); });
  connect(repeat_, &QPushButton::clicked, this, [this] { presenter_.trials().repeat(); });
  connect(skip_, &QPushButton::clicked, this, [this] { presenter_.protocol().skip(); });
  connect(helped_, &QPushButton::clicked, this, [this] {
    presenter_.remarks().toggle_helped();
    refresh();
  });
  connect(note_, &QLineEdit::returnPressed, this, [this] {
    presenter_.remarks().note(note_->text().trimmed().toStdString());
    note_->clear();
  });
}

void RunPanel::fill_list() {
  constexpr int kRow_px = 24;
  std::optional<TaskGroup> group;
  const auto& tasks = presenter_.state().library.tasks;
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (group != tasks[i].kind->group) {
      group = tasks[i].kind->group;
      auto* heading = new QListWidgetItem(translated(words_of(*group)), list_);
      QFont font = list_->font();
      font.setBold(true);
      heading->setFont(font);
      heading->setForeground(look::kQuietText);
      heading->setFlags(Qt::NoItemFlags);  // keys and clicks pass over it
      heading->setSizeHint({0, scaled(kRow_px)});
    }
    auto* item = new QListWidgetItem(QStringLiteral("   ") + translated(tasks[i].name), list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setData(Qt::AccessibleTextRole, translated(tasks[i].name));
    item->setSizeHint({0, scaled(kRow_px)});
  }
  take_rest(*list_, 3 * kRow_px);
}

void RunPanel::refresh() {
  const auto& view = presenter_.flow().view();
  refresh_choice();
  const auto* spec = presenter_.state().next_task();
  next_->setText(QString::fromStdString(next_words(presenter_.state())));
  next_->setVisible(!next_->text().isEmpty());
  instruction_->setText(spec == nullptr ? QString() : translated(spec->instruction));
  instruction_->setVisible(!instruction_->text().isEmpty());
  show_how_->setText(presenter_.tasks().showing_how() ? tr("Stop sho&wing")
                                                      : tr("Show the patient ho&w"));
  describe(*show_how_, show_how_->text().remove(QLatin1Char('&')),
           presenter_.state().measures_arm()
               ? tr("The patient's screen shows how a healthy arm does this task (F7, Alt+W)")
               : tr("The patient's screen shows how a healthy hand does this task (F7, Alt+W)"));
  show_how_->setVisible(view.not_shown.empty());
  not_shown_->setText(translated(view.not_shown));
  not_shown_->setVisible(!view.not_shown.empty());
  show_how_->setEnabled(view.may_show_how || presenter_.tasks().showing_how());
  describe(*start_, tr("Start: %1").arg(next_->text()), tr("Begin (F8, Alt+S)"));
  start_->setEnabled(view.may_start);
  // With nothing left to start, its place is that of the end.
  start_->setVisible(!view.may_stop && (view.may_start || !view.offers_end));
  const bool ends = view.offers_end && !view.closes;
  end_report_->setVisible(ends);
  end_disconnect_->setVisible(ends);
  mark_next(*end_disconnect_, ends && view.press == NextPress::end);
  mark_next(*start_, view.press == NextPress::start);
  const bool between = view.may_stand_by;
  pause_->setText(view.may_resume ? tr("R&esume")
                  : between       ? tr("Hold: do not start")
                                  : tr("Paus&e"));
  describe(*pause_,
           view.may_resume ? tr("Resume the trial")
           : between       ? tr("Hold: nothing begins by itself")
                           : tr("Pause the trial"),
           tr("The trial stands still until it is resumed; between trials nothing begins (F9)"));
  pause_->setEnabled(view.may_pause || view.may_resume || between);
  pause_->setVisible(view.may_stop || between);
  mark_next(*pause_, view.press == NextPress::resume);
  hint_->setText(QString::fromStdString(view.may_stop ? "" : view.start_hint));
  hint_->setVisible(!hint_->text().isEmpty());
  refresh_between();
}

void RunPanel::refresh_choice() {
  const auto& view = presenter_.flow().view();
  const bool protocol = presenter_.state().guide().active();
  const bool follows = presenter_.state().follows();
  follow_->setVisible(protocol);
  by_hand_->setVisible(protocol);
  follow_->setChecked(follows);
  by_hand_->setChecked(!follows);
  follow_->setEnabled(view.may_choose_task);
  by_hand_->setEnabled(view.may_choose_task);
  // Before a session the protocol is what will come; tasks are listed only where one is chosen.
  const bool listed = !follows && (protocol || presenter_.state().session_open() ||
                                   !presenter_.state().has_protocol());
  list_->setVisible(listed);
  practice_->setVisible(listed);
  by_itself_->setVisible(!listed);
  {
    const QSignalBlocker quiet(by_itself_);
    by_itself_->setChecked(presenter_.state().choices.by_itself);
  }
  const auto task = presenter_.state().task();
  const QSignalBlocker quiet(list_);
  for (int row = 0; row < list_->count(); ++row) {
    const auto number = list_->item(row)->data(Qt::UserRole);
    if (number.isValid() && number.toInt() == task && list_->currentRow() != row)
      list_->setCurrentRow(row);
  }
  list_->setEnabled(view.may_choose_task);
  practice_->setEnabled(view.may_choose_task);
}

void RunPanel::refresh_between() {
  const auto& view = presenter_.flow().view();
  const auto level = presenter_.tasks().difficulty();
  const bool idle = view.may_choose_task && presenter_.state().session_open();
  easier_->setVisible(level.has_value());
  harder_->setVisible(level.has_value());
  level_->setVisible(level.has_value());
  if (level) {
    easier_->setEnabled(idle && *level > 0.0);
    harder_->setEnabled(idle && *level < 1.0);
    level_->setText(tr("Difficulty %1 %").arg(100.0 * *level, 0, 'f', 0));
  }
  repeat_->setEnabled(presenter_.flow().view().may_repeat);
  skip_->setVisible(presenter_.state().follows());
  skip_->setEnabled(view.may_skip);
  helped_->setEnabled(presenter_.remarks().may_help());
  helped_->setChecked(presenter_.state().helped());
  note_->setEnabled(presenter_.state().session_open());
}

void RunPanel::refresh_progress() {
  const auto picture = presenter_.patient_view().picture();
  progress_->setValue(picture.progress_shown ? static_cast<int>(1000.0 * picture.progress) : 0);
}

RatingPanel::RatingPanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("The patient says"), parent), presenter_(presenter) {
  remark_ = new QLabel;
  remark_->setObjectName("rating_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  auto* questions = new QGridLayout;
  questions->setColumnStretch(1, 1);
  const auto add = [&](const QString& words, const char* name, const QString& question) {
    auto* row = new ScoreRow(name, question);
    auto* label = new QLabel(words);
    const int place = questions->rowCount();
    questions->addWidget(label, place, 0);
    questions->addWidget(row, place, 1);
    return std::pair(label, row);
  };
  effort_ = add(tr("Effort", "beside its numbers"), "effort", tr("Effort")).second;
  pain_ = add(tr("Pain", "beside its numbers"), "pain", tr("Pain")).second;
  std::tie(shoulder_words_, shoulder_) =
      add(tr("Shoulder", "beside its numbers"), "shoulder_pain", tr("Shoulder pain"));
  column_->addLayout(questions);
  correct_ = new QPushButton;
  correct_->setObjectName("rating_correct");
  connect(correct_, &QPushButton::clicked, this, [this] { presenter_.remarks().show_rated(); });
  column_->addWidget(remark_);
  column_->addWidget(correct_);
  connect(effort_, &ScoreRow::chosen, this,
          [this](int effort) { presenter_.remarks().rate_effort(effort); });
  connect(pain_, &ScoreRow::chosen, this,
          [this](int pain) { presenter_.remarks().rate_pain(pain); });
  connect(shoulder_, &ScoreRow::chosen, this,
          [this](int pain) { presenter_.remarks().rate_shoulder_pain(pain); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &RatingPanel::refresh);
  refresh();
}

void RatingPanel::refresh() {
  const bool due = presenter_.state().guide().rating_due();
  const bool possible =
      presenter_.state().session_open() && presenter_.state().traces().last_trial.has_value();
  setVisible(possible);
  const bool of_shoulder = presenter_.state().measures_hand();
  show_part(*shoulder_words_, of_shoulder);
  show_part(*shoulder_, of_shoulder);
  const Rating& rating = presenter_.state().rating();
  effort_->show_value(rating.effort);
  pain_->show_value(rating.pain);
  shoulder_->show_value(rating.shoulder_pain);
  const bool begun = rating.effort || rating.pain || rating.shoulder_pain;
  remark_->setText(rating.corrects ? kept_words(*rating.last)
                   : begun         ? tr("A number is missing: nothing is kept yet.")
                   : due           ? tr("0: none, 10: the most. Asked after every block.")
                                   : QString());
  remark_->setVisible(!remark_->text().isEmpty());
  correct_->setVisible(rating.last && !rating.corrects);
  correct_->setText(correct_words(rating.last.value_or(Rating::Answer{})));
  describe(*correct_, correct_->text(),
           tr("Shows the last answer again; another number corrects it, and what it was is kept "
              "(Tab, then space)"));
  if (property("due").toBool() != due) {
    setProperty("due", due);
    style()->unpolish(this);
    style()->polish(this);
  }
}

}  // namespace isograsp::gui
