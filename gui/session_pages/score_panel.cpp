// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/score_panel.hpp"

#include "gui/look/look.hpp"
#include "gui/look/value_table.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"

namespace isograsp::gui {

ScorePanel::ScorePanel(SessionPresenter& presenter, QWidget* parent)
    : Card(tr("Result"), parent), presenter_(presenter) {
  remark_ = new QLabel;
  remark_->setObjectName("result_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  table_ = make_value_table("score", {tr("Measure"), tr("Value")}, 90);
  describe(*table_, tr("Result of the trial"),
           tr("Measures of the running or the last trial (Alt+U)"));
  title_->setText(tr("Res&ult"));
  title_->setBuddy(table_);
  column_->addWidget(remark_);
  column_->addWidget(table_, 1);
  connect(&presenter_.flow(), &SessionFlow::score_changed, this, &ScorePanel::refresh);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ScorePanel::refresh);
  refresh();
}

void ScorePanel::refresh() {
  const auto& measures = presenter_.state().live_score();
  const auto& last = presenter_.state().traces().last_trial;
  if (presenter_.flow().view().may_stop) {
    remark_->setText(tr("So far, renewed every second"));
  } else if (last) {
    const auto name = translated(last->trial.task_name);
    const bool whole =
        last->trial.status == storage::TrialStatus::completed && last->trial.dropped == 0;
    remark_->setText(tr("%1: %2").arg(name, status_words(last->trial.status)) +
                     (last->trial.practice ? tr(", practice") : QString()) +
                     (whole || last->reason.empty()
                          ? QString()
                          : QStringLiteral(". ") + translated(last->reason)));
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

}  // namespace isograsp::gui
