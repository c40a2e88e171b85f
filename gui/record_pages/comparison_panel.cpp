// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/comparison_panel.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>

#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

namespace {

QString words_for_session(const CourseSession& session) {
  const auto mark = source_mark(session.record);
  const auto what = mark.isEmpty()
                        ? hand_words(session.record.hand)
                        : QObject::tr("%1, %2").arg(hand_words(session.record.hand), mark);
  return QObject::tr("%1: %2, %3")
      .arg(session.number)
      .arg(local_date(session.record.started_utc), what);
}

QString with_unit(double value, const std::string& unit, bool signed_value) {
  const auto number = translated_digits(signed_value ? tasks::format_change(value, unit)
                                                     : tasks::format_value(value, unit));
  const auto printed = translated(tasks::unit_words(tasks::printed_unit(unit).text));
  return printed.isEmpty() ? number : QObject::tr("%1 %2").arg(number, printed);
}

QString words_for_mean(const SessionMean& mean, const std::string& unit) {
  if (!mean.value) return QStringLiteral("–");
  return QObject::tr("%1  (n %2)").arg(with_unit(*mean.value, unit, false)).arg(mean.trials);
}

QString words_for_trials(const SessionMean& mean) {
  if (!mean.value) return mean.reason;
  if (mean.without == 0) return QObject::tr("Mean of %1.").arg(trials_words(mean.trials));
  return QObject::tr("Mean of %1; without a value: %2.")
      .arg(trials_words(mean.trials), trials_words(mean.without));
}

QComboBox* make_choice(const char* name, const QString& title, const QString& key) {
  auto* box = new ChoiceBox;
  box->setObjectName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  describe(*box, title, QObject::tr("%1: choose with the arrow keys (%2)").arg(title, key));
  return box;
}

}  // namespace

ComparisonPanel::ComparisonPanel(QWidget* parent) : Card(tr("Compare two sessions"), parent) {
  first_ = make_choice("compare_a", tr("Session A"), tr("F5"));
  second_ = make_choice("compare_b", tr("Session B"), tr("F5, then Tab"));
  all_ = new QCheckBox(tr("All measures"));
  all_->setObjectName("compare_all");
  describe(*all_, tr("All measures"),
           tr("Also those for research, not only those of the report (F5, then Tab twice; Space)"));
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(new QLabel(tr("A")));
  head->addWidget(first_, 1);
  head->addSpacing(8);
  head->addWidget(new QLabel(tr("B")));
  head->addWidget(second_, 1);
  head->addSpacing(8);
  head->addWidget(all_);
  table_ = new QTableWidget(0, 5);
  table_->setObjectName("compare_table");
  table_->setHorizontalHeaderLabels({tr("Task"), tr("Measure"), tr("A"), tr("B"), tr("B − A")});
  auto* header = table_->horizontalHeader();
  header->setSectionResizeMode(QHeaderView::ResizeToContents);
  header->setSectionResizeMode(1, QHeaderView::Stretch);
  for (int column = 0; column < 5; ++column)
    table_->horizontalHeaderItem(column)->setTextAlignment(
        (column >= 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(scaled(26));
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  take_rest(*table_, 120);
  describe(*table_, tr("Measures of both sessions"),
           tr("Means over the assessments of each session, n of them; up and down arrow keys"));
  remark_ = new QLabel;
  remark_->setObjectName("compare_remark");
  remark_->setProperty("role", "quiet");
  remark_->setWordWrap(true);
  column_->addLayout(head);
  column_->addWidget(table_, 1);
  column_->addWidget(remark_);
  for (auto* box : {first_, second_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &ComparisonPanel::compare);
  connect(all_, &QCheckBox::toggled, this, &ComparisonPanel::compare);
}

void ComparisonPanel::show_course(std::shared_ptr<const PatientCourse> course) {
  course_ = std::move(course);
  {
    const QSignalBlocker quiet_first(first_);
    const QSignalBlocker quiet_second(second_);
    for (auto* box : {first_, second_}) {
      box->clear();
      if (course_ == nullptr) continue;
      for (const auto& session : course_->sessions) box->addItem(words_for_session(session));
    }
    const int newest = first_->count() - 1;
    int other = newest;
    for (int i = newest - 1; i >= 0; --i) {
      const auto& a = course_->sessions[static_cast<std::size_t>(i)].record;
      const auto& b = course_->sessions[static_cast<std::size_t>(newest)].record;
      if (a.hand == b.hand && a.simulated == b.simulated && a.recorded == b.recorded) other = i;
    }
    first_->setCurrentIndex(other);
    second_->setCurrentIndex(newest);
  }
  compare();
}

void ComparisonPanel::compare() {
  if (first_->currentIndex() < 0 || second_->currentIndex() < 0) {
    fill({});
    return;
  }
  const auto session = [&](const QComboBox* box) -> const CourseSession& {
    return course_->sessions[static_cast<std::size_t>(box->currentIndex())];
  };
  fill(compare_sessions(session(first_), session(second_)));
}

void ComparisonPanel::fill(const SessionComparison& comparison) {
  table_->setRowCount(0);
  QString task;
  for (const auto& row : comparison.rows) {
    if (!row.drawn && !all_->isChecked()) continue;
    const int at = table_->rowCount();
    table_->insertRow(at);
    const std::array<QString, 5> texts{
        row.task == task ? QString() : row.task, row.title, words_for_mean(row.a, row.unit),
        words_for_mean(row.b, row.unit),
        row.difference ? with_unit(*row.difference, row.unit, true) : QStringLiteral("–")};
    task = row.task;
    for (int column = 0; column < 5; ++column) {
      auto* item = new QTableWidgetItem(texts[static_cast<std::size_t>(column)]);
      item->setTextAlignment((column >= 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
      item->setToolTip(column == 2   ? words_for_trials(row.a)
                       : column == 3 ? words_for_trials(row.b)
                                     : tr("%1, %2").arg(row.task, row.title));
      if (row.key && column > 0) {
        QFont bold = table_->font();
        bold.setBold(true);
        item->setFont(bold);
      }
      table_->setItem(at, column, item);
    }
  }
  QStringList remarks;
  if (table_->rowCount() == 0 && comparison.left_out.empty())
    remarks << tr("The two sessions share no assessment.");
  if (table_->rowCount() > 0)
    remarks << tr("Means over the completed trials without practice and help; n: how many.");
  if (!comparison.left_out.empty() && !comparison.rows.empty()) {
    QStringList what;
    for (const auto& one : comparison.left_out) what << one;
    remarks << tr("Not compared: %1.").arg(what.join(tr("; ")));
  } else {
    for (const auto& one : comparison.left_out) remarks << one;
  }
  remark_->setText(remarks.join(QStringLiteral(" ")));
}

}  // namespace isograsp::gui
