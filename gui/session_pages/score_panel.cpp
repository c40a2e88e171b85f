// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/score_panel.hpp"

#include <QHBoxLayout>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/look.hpp"
#include "gui/look/value_table.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

ScorePanel::ScorePanel(const Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Result"), parent), clinic_(clinic), presenter_(presenter) {
  all_ = new QPushButton(tr("All measures"));
  all_->setObjectName("all_measures");
  all_->setCheckable(true);
  all_->setShortcut(QKeySequence("Ctrl+U"));
  describe(*all_, tr("All measures"), tr("All measures of the trial in numbers (Ctrl+U)"));
  key_value_ = new QLabel;
  key_value_->setObjectName("key_value");
  key_value_->setProperty("role", "number");
  key_title_ = new QLabel;
  key_title_->setObjectName("key_title");
  key_title_->setWordWrap(true);
  last_time_ = new QLabel;
  last_time_->setObjectName("last_time");
  last_time_->setProperty("role", "quiet");
  last_time_->setWordWrap(true);
  remark_ = new QLabel;
  remark_->setObjectName("result_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  table_ = make_value_table("score", {tr("Measure"), tr("Value")}, 90);
  describe(*table_, tr("Result of the trial"),
           tr("Measures of the running or the last trial (Tab, arrow keys)"));
  table_->hide();
  auto* top = new QHBoxLayout;
  column_->removeWidget(title_);
  top->addWidget(title_, 1);
  top->addWidget(all_);
  auto* beside = new QVBoxLayout;
  beside->setSpacing(2);
  beside->addWidget(key_title_);
  beside->addWidget(last_time_);
  auto* key = new QHBoxLayout;
  key->setSpacing(16);
  key->addWidget(key_value_);
  key->addLayout(beside, 1);
  column_->insertLayout(0, top);
  column_->addLayout(key);
  column_->addWidget(remark_);
  column_->addWidget(table_, 100);
  column_->addStretch(1);  // without the table nothing is pulled apart
  connect(all_, &QPushButton::toggled, table_, &QWidget::setVisible);
  connect(&presenter_.flow(), &SessionFlow::score_changed, this, &ScorePanel::refresh);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ScorePanel::refresh);
  connect(&clinic_, &Clinic::history_changed, this, &ScorePanel::refresh);
  refresh();
}

/// Of the running trial, or of the last one; null: there was none.
const tasks::TaskSpec* ScorePanel::task() {
  const SessionState& state = presenter_.state();
  if (state.open && state.open->trial) return state.open->trial->task.get();
  const auto& last = state.traces().last_trial;
  if (!last) return nullptr;
  if (read_ != last->trial.id) {
    auto spec = tasks::parse_task(last->trial.task_text, last->trial.task_name);
    read_task_ = spec ? std::make_shared<const tasks::TaskSpec>(*std::move(spec)) : nullptr;
    read_ = last->trial.id;
  }
  return read_task_.get();
}

/// @pre a session is open
TrialLike ScorePanel::trial_like(const tasks::TaskSpec& task) const {
  const SessionState& state = presenter_.state();
  const storage::SessionRecord& session = state.open->session->known().record;
  return {session.id, task.name, task.version, session.hand, session.simulated};
}

QString ScorePanel::remark() const {
  if (presenter_.flow().view().may_stop) return tr("So far, renewed every second");
  const auto& last = presenter_.state().traces().last_trial;
  if (!last) return tr("No trial in this session yet.");
  const bool whole =
      last->trial.status == storage::TrialStatus::completed && last->trial.dropped == 0;
  return tr("%1: %2").arg(translated(last->trial.task_name), status_words(last->trial.status)) +
         (last->trial.practice ? tr(", practice") : QString()) +
         (whole || last->reason.empty() ? QString()
                                        : QStringLiteral(". ") + translated(last->reason));
}

void ScorePanel::refresh() {
  remark_->setText(remark());
  show_key();
  show_all();
}

void ScorePanel::show_key() {
  const auto* spec = task();
  const auto* key = spec == nullptr ? nullptr : key_measure(*spec, presenter_.state().live_score());
  for (QLabel* part : {key_value_, key_title_, last_time_}) part->setVisible(key != nullptr);
  if (key == nullptr) return;
  key_value_->setText(measure_value(*key));
  key_title_->setText(measure_title(*key));
  const auto* before = presenter_.state().session_open()
                           ? gui::last_time(clinic_.history(), trial_like(*spec), *key)
                           : nullptr;
  last_time_->setText(before == nullptr ? tr("No earlier session to compare with")
                                        : tr("Last time %1, on %2")
                                              .arg(measure_value(before->measure),
                                                   local_date(before->started_utc)));
  last_time_->setVisible(presenter_.state().session_open());
}

void ScorePanel::show_all() {
  const auto& measures = presenter_.state().live_score();
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

}  // namespace isograsp::gui
