// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/trial_about.hpp"

#include <QHeaderView>
#include <QStyledItemDelegate>
#include <utility>

#include "gui/look/look.hpp"
#include "gui/trial_pages/trial_plot.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

namespace {
constexpr int kFirstColumn_px = 170;
constexpr int kMarkTime = Qt::UserRole;

/// A text is as high as it is between the paddings of its cell: the style sheet's are left out of
/// what Qt asks for, and the last line would be cut.
class PaddedText final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                               const QModelIndex& index) const override {
    constexpr int kPaddings_px = 18;
    QStyleOptionViewItem between = option;
    between.rect.setWidth(option.rect.width() - kPaddings_px);
    return QStyledItemDelegate::sizeHint(between, index);
  }
};
}  // namespace

QString seconds_text(double t_s) {
  return translated_number(t_s, 2);
}

TrialAbout::TrialAbout(QWidget* parent) : QTableWidget(0, 2, parent) {
  setObjectName("trial_about");
  horizontalHeader()->hide();
  horizontalHeader()->setStretchLastSection(true);
  horizontalHeader()->resizeSection(0, scaled(kFirstColumn_px));
  verticalHeader()->hide();
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  setItemDelegate(new PaddedText(this));
  setShowGrid(false);
  setWordWrap(true);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setTabKeyNavigation(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  describe(*this, tr("About this trial"),
           tr("Measures, events and what is known: arrow keys; Enter on an event goes there"));
  const auto go = [this](QTableWidgetItem* chosen) {
    const auto at = item(chosen->row(), 0)->data(kMarkTime);
    if (at.isValid()) Q_EMIT sought(at.toDouble());
  };
  connect(this, &QTableWidget::itemActivated, this, go);
  connect(this, &QTableWidget::itemClicked, this, go);
}

int TrialAbout::add(const QString& what, const QString& value, bool bold, const QString& tip) {
  const int row = rowCount();
  insertRow(row);
  int column = 0;
  for (const auto& text : {what, value}) {
    auto* cell = new QTableWidgetItem(text);
    cell->setToolTip(tip.isEmpty() ? tr("%1: %2").arg(what, value) : tip);
    cell->setTextAlignment((column == 1 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
    if (bold) {
      QFont heavy = font();
      heavy.setBold(true);
      cell->setFont(heavy);
    }
    setItem(row, column++, cell);
  }
  return row;
}

void TrialAbout::add_heading(const QString& text) {
  const int row = add(text, {}, true, text);
  setSpan(row, 0, 1, 2);
  item(row, 0)->setForeground(look::kAccent);
  item(row, 0)->setFlags(Qt::ItemIsEnabled);
}

void TrialAbout::add_measures(const LoadedTrial& trial, const QString& title, bool drawn) {
  const auto spec = trial.task ? std::optional(*trial.task) : std::nullopt;
  bool first = true;
  for (const auto& measure : trial.opened.measures) {
    const auto prominence = tasks::place_of(spec, measure.name, measure.channel).prominence;
    if ((prominence != tasks::Prominence::none) != drawn) continue;
    if (std::exchange(first, false)) add_heading(title);
    add(measure_title(measure), measure_value(measure), prominence == tasks::Prominence::key,
        measure_remark(measure));
  }
}

void TrialAbout::add_marks(const std::vector<TrialMark>& marks) {
  if (!marks.empty()) add_heading(tr("Events"));
  for (const auto& mark : marks) {
    const auto what = tr("%1 %2").arg(mark_letter(mark.kind), mark_words(mark.kind));
    const bool typed = mark.kind == "note";  // by a person, in any language
    const auto text = mark.text.empty()
                          ? what
                          : tr("%1: %2").arg(what, typed ? QString::fromStdString(mark.text)
                                                         : translated(mark.text));
    const int row = add(text, tr("%1 s").arg(seconds_text(mark.t_s)), false);
    item(row, 0)->setData(kMarkTime, mark.t_s);
  }
}

/// Why each digit held and let go.
void TrialAbout::add_story(const std::vector<GraspEvent>& story) {
  if (!story.empty()) add_heading(tr("Why it was held and let go"));
  for (const GraspEvent& event : story) {
    const int row = add(words_of(event), tr("%1 s").arg(seconds_text(event.t_s)), false);
    item(row, 0)->setData(kMarkTime, event.t_s);
  }
}

void TrialAbout::show_trial(const LoadedTrial& trial) {
  setRowCount(0);
  clearSpans();
  add_measures(trial, tr("Measures"), true);
  add_marks(trial.opened.marks);
  if (trial.tracked) add_story(trial.tracked->story());
  add_heading(tr("About"));
  for (const auto& fact : trial.facts)
    add(fact.doubtful ? tr("⚠ %1").arg(fact.what) : fact.what, fact.value, fact.doubtful);
  add_measures(trial, tr("Other measures"), false);
}

}  // namespace isograsp::gui
