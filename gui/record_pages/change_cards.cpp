// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/change_cards.hpp"

#include <QGridLayout>
#include <algorithm>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::gui {

namespace {

QString day_of(const std::string& utc) {
  constexpr std::size_t kDate = 10;  // characters of "2026-11-21"
  return translated_date(utc.substr(0, kDate));
}

QString words_of(const storage::PrimaryMeasure& primary) {
  Measure measure;
  measure.name = primary.measure;
  measure.channel = primary.channel;
  return QObject::tr("%1 · %2, %3")
      .arg(measure_title(measure), translated(primary.task_name), hand_words(primary.hand));
}

bool same(const storage::PrimaryMeasure& a, const storage::PrimaryMeasure& b) {
  return a.task_name == b.task_name && a.hand == b.hand && a.measure == b.measure &&
         a.channel == b.channel;
}

QLineEdit* who_field(const QString& object_name, const QString& name, const QString& hint,
                     const QString& key, QWidget* card) {
  auto* field = entry_text(object_name, name, hint);
  describe(*field, name,
           QObject::tr("%1; stays for the next entry (%2)").arg(name, key_words(key)));
  add_key(card, key, [field] { field->setFocus(); });
  return field;
}

/// Moves an entry to those that can be brought back.
template <class Entry>
void take_out(std::vector<Entry>& entries, int row, std::vector<Entry>& gone) {
  gone.push_back(entries[static_cast<std::size_t>(row)]);
  entries.erase(entries.begin() + row);  // at once, so that it cannot be removed twice
}

/// What a list says of its last removed entry; nothing: there is none.
template <class Entry, class Words>
QString last_removed(const std::vector<Entry>& gone, Words words) {
  return gone.empty() ? QString() : words(gone.back());
}

QString primary_removed(const storage::PrimaryMeasure& primary) {
  return QObject::tr("Removed: %1.").arg(words_of(primary));
}

QString period_removed(const storage::StablePeriod& period) {
  return removed_words(period.from_date, QObject::tr("until %1").arg(day_of(period.until_date)));
}

}  // namespace

PrimaryCard::PrimaryCard(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Primary measures"));
  measure_ = new ChoiceBox;
  measure_->setObjectName("primary_measure");
  measure_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  measure_->setMinimumContentsLength(12);
  describe(*measure_, tr("Measure that gets a verdict of change"),
           tr("Measure that gets a verdict of change; Alt+Down shows all (Ctrl+Shift+M)"));
  add_key(this, "Ctrl+Shift+M", [this] { measure_->setFocus(); });
  by_ =
      who_field("primary_by", tr("Who chooses the measure"), tr("Chosen by"), "Ctrl+Shift+W", this);
  add_ = add_button("primary_add", tr("Make this a primary measure"), this);
  remark_ = new Remark;
  remark_->setObjectName("primary_remark");
  list_ = new DatedList(
      "primary", tr("Primary measures"), {tr("Chosen"), tr("By"), tr("Measure")},
      tr("No measure is chosen: no change is judged. Choose up to four before the second "
         "assessment."),
      this);
  auto* entry = new QGridLayout;
  entry->setSpacing(6);
  entry->addWidget(measure_, 0, 0, 1, 2);
  entry->addWidget(by_, 1, 0);
  entry->addWidget(add_, 1, 1);
  entry->setColumnStretch(0, 1);
  column_->addWidget(list_);
  column_->addWidget(caption(tr("New primary measure"), measure_));
  column_->addLayout(entry);
  column_->addWidget(remark_);

  connect(add_, &QPushButton::clicked, this, &PrimaryCard::add);
  connect(by_, &QLineEdit::returnPressed, this, &PrimaryCard::add);
  connect(by_, &QLineEdit::textEdited, this, &PrimaryCard::show_state);
  connect(list_, &DatedList::remove_pressed, this, [this](int row) {
    take_out(primaries_, row, gone_);
    list_->offer_undo(last_removed(gone_, primary_removed));
    show_primaries(std::vector(primaries_));
    Q_EMIT removed(gone_.back().id);
  });
  connect(list_, &DatedList::undo_pressed, this, [this] {
    const storage::PrimaryMeasure back = gone_.back();
    gone_.pop_back();
    list_->offer_undo(last_removed(gone_, primary_removed));
    Q_EMIT added(back);  // with the day on which it was chosen
  });
  show_state();
}

void PrimaryCard::show_primaries(const std::vector<storage::PrimaryMeasure>& primaries) {
  primaries_ = primaries;
  std::vector<QStringList> rows;
  for (const auto& primary : primaries_)
    rows.push_back(
        {day_of(primary.chosen_utc), QString::fromStdString(primary.chosen_by), words_of(primary)});
  list_->show_rows(rows);
  show_state();
}

void PrimaryCard::offer(const std::vector<storage::PrimaryMeasure>& choices) {
  if (choices == choices_) return;  // what is being chosen stays
  choices_ = choices;
  measure_->clear();
  for (const auto& choice : choices_) {
    measure_->addItem(words_of(choice));
    measure_->setItemData(measure_->count() - 1, words_of(choice), Qt::ToolTipRole);
  }
  show_state();
}

void PrimaryCard::clear() {
  gone_.clear();
  list_->offer_undo({});
  show_primaries({});
  offer({});
}

void PrimaryCard::show_state() {
  const bool full = primaries_.size() >= storage::kMostPrimaryMeasures;
  measure_->setEnabled(!full && !choices_.empty());
  add_->setEnabled(!full && !choices_.empty());
  if (full)
    remark_->say(tr("Four are chosen. Remove one to choose another."));
  else if (choices_.empty())
    remark_->say(tr("Measures can be chosen from the first assessment on."));
  else
    remark_->say({});
}

void PrimaryCard::add() {
  if (!add_->isEnabled()) return;
  storage::PrimaryMeasure chosen = choices_.at(static_cast<std::size_t>(measure_->currentIndex()));
  chosen.chosen_by = by_->text().trimmed().toStdString();
  const bool there = std::any_of(primaries_.begin(), primaries_.end(),
                                 [&](const auto& one) { return same(one, chosen); });
  if (chosen.chosen_by.empty() || there) {
    (there ? static_cast<QWidget*>(measure_) : by_)->setFocus();
    remark_->warn(there ? tr("Not added. This measure is chosen already.")
                        : tr("Not added. Say who chooses it."));
    return;
  }
  show_state();
  Q_EMIT added(chosen);
}

StableCard::StableCard(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Judged stable"));
  from_ = entry_date("stable_from", tr("First day of the stable time"), "Ctrl+Shift+F",
                     Ahead::refused, this);
  until_ = entry_date("stable_until", tr("Last day of the stable time"), "Ctrl+Shift+U",
                      Ahead::refused, this);
  by_ = who_field("stable_by", tr("Clinician who judges the person stable"), tr("Judged by"),
                  "Ctrl+Shift+C", this);
  text_ = entry_text("stable_text", tr("Remark on the stable time"), tr("Remark"));
  auto* add = add_button("stable_add", tr("Add this stable time"), this);
  remark_ = new Remark;
  remark_->setObjectName("stable_remark");
  list_ = new DatedList(
      "stable", tr("Times judged stable"), {tr("From"), tr("Until"), tr("By"), tr("Remark")},
      tr("No stable time is entered. Assessments of people in whom a clinician expects no change "
         "tell how large the measurement error of this clinic is."),
      this);
  auto* entry = new QGridLayout;
  entry->setSpacing(6);
  entry->addWidget(from_, 0, 0);
  entry->addWidget(until_, 0, 1, 1, 2);
  entry->addWidget(by_, 1, 0);
  entry->addWidget(text_, 1, 1);
  entry->addWidget(add, 1, 2);
  entry->setColumnStretch(0, 1);
  entry->setColumnStretch(1, 1);
  column_->addWidget(list_);
  column_->addWidget(caption(tr("Stable from, until; judged by whom"), from_));
  column_->addLayout(entry);
  column_->addWidget(remark_);

  connect(add, &QPushButton::clicked, this, &StableCard::add);
  for (auto* field :
       {static_cast<QLineEdit*>(from_), static_cast<QLineEdit*>(until_), by_, text_}) {
    connect(field, &QLineEdit::returnPressed, this, &StableCard::add);
    connect(field, &QLineEdit::textEdited, this, [this] { remark_->say({}); });
  }
  connect(list_, &DatedList::remove_pressed, this, [this](int row) {
    take_out(periods_, row, gone_);
    list_->offer_undo(last_removed(gone_, period_removed));
    show_periods(std::vector(periods_));
    Q_EMIT removed(gone_.back().id);
  });
  connect(list_, &DatedList::undo_pressed, this, [this] {
    const storage::StablePeriod back = gone_.back();
    gone_.pop_back();
    list_->offer_undo(last_removed(gone_, period_removed));
    Q_EMIT added(back);
  });
}

void StableCard::show_periods(const std::vector<storage::StablePeriod>& periods) {
  periods_ = periods;
  std::vector<QStringList> rows;
  for (const auto& period : periods_)
    rows.push_back({day_of(period.from_date), day_of(period.until_date),
                    QString::fromStdString(period.judged_by), QString::fromStdString(period.text)});
  list_->show_rows(rows);
}

void StableCard::clear() {
  gone_.clear();
  list_->offer_undo({});
  show_periods({});
  from_->show_date(local_today());
  until_->show_date(local_today());
  text_->setText({});  // unlike clear() it cannot be taken back
  remark_->say({});
}

void StableCard::add() {
  const auto from = from_->typed();
  const auto until = until_->typed();
  const auto refuse = [this](QLineEdit* field, const QString& why) {
    field->setFocus();
    remark_->warn(tr("Not added. %1").arg(why));
  };
  if (!from.value) return refuse(from_, from.problem);
  if (!until.value) return refuse(until_, until.problem);
  from_->show_date(from.value);
  until_->show_date(until.value);
  storage::StablePeriod period;
  period.from_date = iso_text(*from.value);
  period.until_date = iso_text(*until.value);
  period.judged_by = by_->text().trimmed().toStdString();
  period.text = text_->text().trimmed().toStdString();
  if (period.until_date < period.from_date)
    return refuse(until_, tr("The last day is before the first."));
  if (period.judged_by.empty()) return refuse(by_, tr("Say which clinician judges so."));
  for (const auto& one : periods_)
    if (one.from_date <= period.until_date && period.from_date <= one.until_date)
      return refuse(from_, tr("It overlaps the time from %1 until %2.")
                               .arg(day_of(one.from_date), day_of(one.until_date)));
  remark_->say({});
  Q_EMIT added(period);
  text_->clear();
}

}  // namespace isograsp::gui
