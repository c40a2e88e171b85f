// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_panel.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <algorithm>
#include <optional>

#include "gui/look.hpp"
#include "gui/task_groups.hpp"
#include "gui/words.hpp"

namespace isograsp {

TaskPanel::TaskPanel(SessionPresenter& presenter, QWidget* parent)
    : Card({}, parent), presenter_(presenter) {
  title_->setText(tr("&Task"));
  list_ = new QListWidget;
  list_->setObjectName("tasks");
  describe(*list_, tr("Tasks"), tr("Choose what the patient will do (Alt+T)"));
  title_->setBuddy(list_);
  fill_list();
  instruction_ = new QLabel;
  instruction_->setObjectName("instruction");
  instruction_->setProperty("role", "quiet");
  instruction_->setWordWrap(true);
  instruction_->setMinimumHeight(34);
  instruction_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  practice_ = new QCheckBox(tr("Practice, not an assess&ment"));
  practice_->setObjectName("practice");
  describe(*practice_, tr("Practice trial"),
           tr("A practice trial is recorded but counts for no assessment (Alt+M)"));
  show_how_ = new QPushButton;
  show_how_->setObjectName("show_how");
  start_ = new QPushButton;
  start_->setObjectName("start");
  start_->setMinimumHeight(30);
  pause_ = new QPushButton;
  pause_->setObjectName("pause");
  stop_ = new QPushButton(tr("St&op"));
  stop_->setObjectName("stop");
  describe(*stop_, tr("Stop the trial"),
           tr("End the trial now; it is kept and marked (F10, Alt+O)"));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(pause_, 1);
  row->addWidget(stop_, 1);
  hint_ = new QLabel;
  hint_->setProperty("role", "quiet");
  hint_->setWordWrap(true);
  progress_ = new QProgressBar;
  progress_->setRange(0, 1000);
  describe(*progress_, tr("Progress of the trial"), tr("How much of the trial is over"));

  column_->addWidget(list_);
  column_->addWidget(instruction_);
  column_->addWidget(practice_);
  column_->addWidget(show_how_);
  column_->addWidget(start_);
  column_->addLayout(row);
  column_->addWidget(progress_);
  column_->addWidget(hint_);

  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr && item->data(Qt::UserRole).isValid())
      presenter_.choose_task(item->data(Qt::UserRole).toInt());
  });
  connect(practice_, &QCheckBox::toggled, &presenter_, &SessionPresenter::set_practice);
  connect(show_how_, &QPushButton::clicked, &presenter_, &SessionPresenter::show_how);
  connect(start_, &QPushButton::clicked, &presenter_, &SessionPresenter::start);
  connect(pause_, &QPushButton::clicked, &presenter_, &SessionPresenter::start_pause_resume);
  connect(stop_, &QPushButton::clicked, &presenter_, &SessionPresenter::stop);
  connect(&presenter_, &SessionPresenter::changed, this, &TaskPanel::refresh);
  connect(&presenter_, &SessionPresenter::frame, this, &TaskPanel::refresh_progress);
  refresh();
  refresh_progress();
}

void TaskPanel::fill_list() {
  constexpr int kRow_px = 24;
  constexpr int kMostRows = 7;
  std::optional<TaskGroup> group;
  const auto& tasks = presenter_.tasks();
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (group != group_of(tasks[i])) {
      group = group_of(tasks[i]);
      const auto title = title_of(*group);
      auto* heading = new QListWidgetItem(
          QString::fromUtf8(title.data(), static_cast<int>(title.size())), list_);
      QFont font = list_->font();
      font.setBold(true);
      heading->setFont(font);
      heading->setForeground(look::kQuietText);
      heading->setFlags(Qt::NoItemFlags);  // keys and clicks pass over it
      heading->setSizeHint({0, kRow_px});
    }
    auto* item =
        new QListWidgetItem(QStringLiteral("   ") + QString::fromStdString(tasks[i].name), list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
    item->setData(Qt::AccessibleTextRole, QString::fromStdString(tasks[i].name));
    item->setSizeHint({0, kRow_px});
  }
  list_->setFixedHeight(kRow_px * std::clamp(list_->count(), 3, kMostRows) + 6);
}

void TaskPanel::refresh() {
  const auto& view = presenter_.view();
  const int task = presenter_.task();
  {
    const QSignalBlocker quiet(list_);
    for (int row = 0; row < list_->count(); ++row) {
      const auto number = list_->item(row)->data(Qt::UserRole);
      if (number.isValid() && number.toInt() == task && list_->currentRow() != row)
        list_->setCurrentRow(row);
    }
  }
  list_->setEnabled(view.may_choose_task);
  practice_->setEnabled(view.may_choose_task);
  const auto name =
      task < 0 ? QString()
               : QString::fromStdString(presenter_.tasks()[static_cast<std::size_t>(task)].name);
  instruction_->setText(
      task < 0
          ? tr("Choose a task.")
          : QString::fromStdString(presenter_.tasks()[static_cast<std::size_t>(task)].instruction));
  show_how_->setText(presenter_.showing_how() ? tr("Stop sho&wing") : tr("Show the patient ho&w"));
  describe(*show_how_, show_how_->text().remove(QLatin1Char('&')),
           tr("The patient's screen shows how a healthy hand does this task (F7, Alt+W)"));
  show_how_->setEnabled(view.may_show_how || presenter_.showing_how());
  start_->setText(task < 0 ? tr("&Start") : tr("&Start: %1").arg(name));
  describe(*start_, start_->text().remove(QLatin1Char('&')), tr("Begin the trial (F8, Alt+S)"));
  start_->setEnabled(view.may_start);
  mark_next(*start_, view.may_start);
  pause_->setText(view.may_resume ? tr("R&esume") : tr("Paus&e"));
  describe(*pause_, view.may_resume ? tr("Resume the trial") : tr("Pause the trial"),
           tr("The trial stands still until it is resumed (F9, Alt+E)"));
  pause_->setEnabled(view.may_pause || view.may_resume);
  mark_next(*pause_, view.may_resume);
  stop_->setEnabled(view.may_stop);
  hint_->setText(QString::fromStdString(view.may_stop ? "" : view.start_hint));
  hint_->setVisible(!hint_->text().isEmpty());
}

void TaskPanel::refresh_progress() {
  const auto picture = presenter_.picture();
  progress_->setValue(picture.progress_shown ? static_cast<int>(1000.0 * picture.progress) : 0);
}

ScorePanel::ScorePanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Result"), parent), presenter_(presenter) {
  remark_ = new QLabel;
  remark_->setObjectName("result_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  table_ = new QTableWidget(0, 2);
  table_->setObjectName("score");
  table_->setHorizontalHeaderLabels({tr("Measure"), tr("Value")});
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeaderItem(1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(24);
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  take_rest(*table_, 90);
  describe(*table_, tr("Result of the trial"),
           tr("Measures of the running or the last trial (Alt+U)"));
  title_->setText(tr("Res&ult"));
  title_->setBuddy(table_);
  column_->addWidget(remark_);
  column_->addWidget(table_, 1);
  connect(&presenter_, &SessionPresenter::score_changed, this, &ScorePanel::refresh);
  connect(&presenter_, &SessionPresenter::changed, this, &ScorePanel::refresh);
  refresh();
}

void ScorePanel::refresh() {
  const auto& measures = presenter_.live_score();
  const auto& last = presenter_.last_trial();
  if (presenter_.view().may_stop) {
    remark_->setText(tr("So far, renewed every second"));
  } else if (last) {
    const auto name = QString::fromStdString(last->trial.task_name);
    const bool whole = last->trial.status == TrialStatus::completed && last->trial.dropped == 0;
    remark_->setText(tr("%1: %2").arg(name, status_words(last->trial.status)) +
                     (last->trial.practice ? tr(", practice") : QString()) +
                     (whole || last->reason.empty()
                          ? QString()
                          : QStringLiteral(". ") + QString::fromStdString(last->reason)));
  } else {
    remark_->setText(tr("No trial in this session yet."));
  }
  table_->setRowCount(static_cast<int>(measures.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const auto& measure = measures[static_cast<std::size_t>(row)];
    const auto set = [&](int column, const QString& text, Qt::Alignment alignment) {
      auto* item = table_->item(row, column);
      if (item == nullptr) table_->setItem(row, column, item = new QTableWidgetItem);
      item->setText(text);
      item->setTextAlignment(alignment | Qt::AlignVCenter);
      item->setToolTip(measure_remark(measure));
    };
    set(0, measure_title(measure), Qt::AlignLeft);
    set(1, measure_value(measure), Qt::AlignRight);
  }
}

}  // namespace isograsp
