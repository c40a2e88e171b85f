// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/course_panel.hpp"

#include <QShortcut>
#include <QSignalBlocker>
#include <algorithm>

#include "gui/look/look.hpp"
#include "gui/look/two_line_delegate.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

namespace {

TwoLines lines_of(const CourseSession& session) {
  TwoLines lines;
  lines.title = local_time(session.record.started_utc);
  lines.mark = source_mark(session.record);
  const auto unfinished =
      std::count_if(session.trials.begin(), session.trials.end(), [](const CourseTrial& trial) {
        return trial.record.status != storage::TrialStatus::completed;
      });
  const auto what = session.record.protocol_name.empty() ? QObject::tr("single tasks")
                                                         : translated(session.record.protocol_name);
  QStringList words{QObject::tr("No. %1").arg(session.number), hand_words(session.record.hand),
                    trials_words(static_cast<int>(session.trials.size())), what};
  if (unfinished > 0)
    words.insert(0, QObject::tr("%1 not completed").arg(static_cast<int>(unfinished)));
  if (session.record.ended_utc.empty()) words.insert(0, QObject::tr("not closed"));
  lines.doubtful = unfinished > 0 || session.record.ended_utc.empty();
  lines.below = words.join(QStringLiteral(" · "));
  return lines;
}

TwoLines lines_of(const CourseTrial& trial) {
  TwoLines lines;
  lines.title =
      QObject::tr("%1  %2").arg(trial.record.number).arg(translated(trial.record.task_name));
  QStringList words{standing_words(trial.record)};
  if (const Measure* key = key_measure(trial))
    words.insert(0, QObject::tr("%1 %2").arg(measure_title(*key), measure_value(*key)));
  if (trial.record.drifted) words << QObject::tr("zero drifted");
  lines.doubtful = trial.record.status != storage::TrialStatus::completed || trial.record.drifted;
  lines.below = words.join(QStringLiteral(" · "));
  return lines;
}

QListWidget* make_list(const char* name) {
  auto* list = new QListWidget;
  list->setObjectName(name);
  list->setItemDelegate(new TwoLineDelegate(list));
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setMouseTracking(true);
  take_rest(*list, 90);
  return list;
}

}  // namespace

CoursePanel::CoursePanel(QWidget* parent) : Card(tr("Sessions"), parent) {
  sessions_ = make_list("course_sessions");
  describe(*sessions_, tr("Sessions"),
           tr("Choose a session, newest first: up and down arrow keys (F2)"));
  trials_title_ = new QLabel(tr("Trials"));
  trials_title_->setProperty("role", "title");
  trials_ = make_list("course_trials");
  describe(*trials_, tr("Trials of this session"),
           tr("Choose a trial with the arrow keys, open it with Enter or the mouse (F3)"));
  column_->addWidget(sessions_, 5);
  column_->addWidget(trials_title_);
  column_->addWidget(trials_, 6);

  const auto reach = [this](int key, QListWidget* list) {
    connect(new QShortcut(key, this), &QShortcut::activated, list, [list] { list->setFocus(); });
  };
  reach(Qt::Key_F2, sessions_);
  reach(Qt::Key_F3, trials_);
  connect(sessions_, &QListWidget::currentRowChanged, this, &CoursePanel::fill_trials);
  // Enter is activation on every platform; a click of the mouse opens as well.
  connect(trials_, &QListWidget::itemActivated, this, [this] { open_row(trials_->currentRow()); });
  connect(trials_, &QListWidget::itemClicked, this, [this] { open_row(trials_->currentRow()); });
}

int CoursePanel::session_of_row(int row) const {
  return course_ == nullptr ? -1 : static_cast<int>(course_->sessions.size()) - 1 - row;
}

void CoursePanel::show_course(std::shared_ptr<const PatientCourse> course) {
  storage::RowId chosen = 0;
  if (const int row = sessions_->currentRow(); row >= 0)
    chosen = course_->sessions[static_cast<std::size_t>(session_of_row(row))].record.id;
  course_ = std::move(course);
  int again = 0;
  {
    const QSignalBlocker quiet(sessions_);
    sessions_->clear();
    if (course_ != nullptr)
      for (auto session = course_->sessions.rbegin(); session != course_->sessions.rend();
           ++session) {
        if (session->record.id == chosen) again = sessions_->count();
        add_two_lines(*sessions_, lines_of(*session));
      }
    sessions_->setCurrentRow(sessions_->count() > 0 ? again : -1);
  }
  fill_trials(sessions_->currentRow());
}

void CoursePanel::choose(int session_index, int trial_index) {
  sessions_->setCurrentRow(session_of_row(session_index));  // it is its own inverse
  trials_->setCurrentRow(trial_index);
}

void CoursePanel::fill_trials(int row) {
  trials_->clear();
  if (row < 0) {
    trials_title_->setText(tr("Trials"));
    return;
  }
  const auto& session = course_->sessions[static_cast<std::size_t>(session_of_row(row))];
  trials_title_->setText(tr("Trials of session %1").arg(session.number));
  for (const auto& trial : session.trials) add_two_lines(*trials_, lines_of(trial));
  trials_->setCurrentRow(trials_->count() > 0 ? 0 : -1);
}

void CoursePanel::open_row(int row) {
  const int session = session_of_row(sessions_->currentRow());
  if (row >= 0 && session >= 0) Q_EMIT trial_opened(session, row);
}

}  // namespace isograsp::gui
