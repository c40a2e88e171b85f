// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/history_panel.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/look/value_table.hpp"
#include "gui/words/words.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

HistoryPanel::HistoryPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : Card({}, parent), clinic_(clinic), presenter_(presenter) {
  title_->setText(tr("&History"));
  choice_ = new ChoiceBox;
  choice_->setObjectName("history_measure");
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  describe(*choice_, tr("Task and measure"), tr("Which measure of the patient is shown (Alt+H)"));
  title_->setBuddy(choice_);
  auto* head = new QHBoxLayout;
  head->setSpacing(10);
  column_->removeWidget(title_);
  head->addWidget(title_);
  head->addWidget(choice_, 1);
  table_ = make_value_table("history", {tr("When"), tr("Trial"), tr("Value")}, 80);
  describe(*table_, tr("Stored values"),
           tr("Every stored value of this measure (Tab, arrow keys)"));
  trend_ = new TrendPlot;
  take_rest(*trend_, 80);
  describe(*trend_, tr("Trend"), tr("The same values in order; hollow dots are practice trials"));
  auto* body = new QBoxLayout(side_by_side());
  body->setSpacing(12);
  body->addWidget(table_, 4);
  body->addWidget(trend_, 5);
  column_->addLayout(head);
  column_->addLayout(body, 1);
  nothing_ = new QLabel;
  nothing_->setProperty("role", "quiet");
  column_->addWidget(nothing_);

  connect(choice_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &HistoryPanel::show_series);
  connect(&clinic_, &Clinic::history_changed, this, &HistoryPanel::fill);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &HistoryPanel::refresh);
  fill();
}

void HistoryPanel::fill() {
  const auto shown = choice_->currentText();
  series_ =
      presenter_.state().choices.patient.empty() ? std::vector<HistorySeries>{} : clinic_.history();
  {
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const auto& one : series_) choice_->addItem(one.title);
    // A new trial shows its own result; otherwise the therapist's choice stays.
    const storage::RowId newest = series_.empty() ? 0 : series_.front().points.back().trial_id;
    const int again = newest == newest_trial_ ? choice_->findText(shown) : 0;
    newest_trial_ = newest;
    choice_->setCurrentIndex(series_.empty() ? -1 : std::max(0, again));
  }
  show_series(choice_->currentIndex());
  refresh();
}

void HistoryPanel::show_series(int index) {
  table_->setRowCount(0);
  std::vector<TrendPoint> trend;
  QString axis;
  if (index >= 0) {
    const auto& series = series_[static_cast<std::size_t>(index)];
    axis = series.unit;
    table_->setRowCount(static_cast<int>(series.points.size()));
    // The table shows the newest first, the trend runs from old to new.
    int row = table_->rowCount();
    for (const auto& point : series.points) {
      --row;
      const auto& measure = point.measure;
      const auto trial = point.practice ? tr("%1, practice").arg(point.trial_number)
                                        : QString::number(point.trial_number);
      const std::array<QString, 3> texts{local_time(point.started_utc), trial,
                                         measure_value(measure)};
      for (int column = 0; column < 3; ++column) {
        auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
        item->setTextAlignment((column == 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        item->setToolTip(measure_remark(measure));
        table_->setItem(row, column, item);
      }
      if (measure.value)
        trend.push_back(
            {*measure.value * tasks::printed_unit(measure.unit).factor, point.practice});
    }
  }
  trend_->show_trend(trend, axis);
}

void HistoryPanel::refresh() {
  choice_->setEnabled(!series_.empty());
  if (!series_.empty()) {
    nothing_->hide();
  } else {
    nothing_->setText(presenter_.state().choices.patient.empty()
                          ? tr("Choose a patient to see what is stored.")
                      : clinic_.history_loading() ? tr("Reading what is stored …")
                                                  : tr("Nothing stored for this patient yet."));
    nothing_->show();
  }
}

}  // namespace isograsp::gui
