// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/profile_cards.hpp"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>

#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr std::array<storage::Side, 4> kSides{storage::Side::left, storage::Side::right,
                                              storage::Side::both, storage::Side::none};
constexpr std::array<Hand, 2> kHands{Hand::left, Hand::right};
constexpr std::array<storage::Sex, 3> kSexes{storage::Sex::female, storage::Sex::male,
                                             storage::Sex::other};
constexpr int kText_px = 76;  // four lines

template <class Values, class Value>
std::optional<int> index_in(const Values& values, const std::optional<Value>& value) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (value == values[i]) return static_cast<int>(i);
  return std::nullopt;
}

template <class Values>
auto value_at(const Values& values, std::optional<int> index) {
  using Value = typename Values::value_type;
  return index ? std::optional<Value>(values[static_cast<std::size_t>(*index)]) : std::nullopt;
}

QString mark_removed(const std::vector<storage::TreatmentMark>& gone) {
  return gone.empty() ? QString()
                      : removed_words(gone.back().on_date, treatment_words(gone.back().kind));
}

QString score_removed(const std::vector<storage::ClinicalScore>& gone) {
  return gone.empty()
             ? QString()
             : removed_words(gone.back().on_date, QString::fromStdString(gone.back().scale));
}

}  // namespace

PersonCard::PersonCard(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Person"));
  affected_ = new SegmentedChoice(
      {{"affected_left", tr("Left"), tr("Affected side: left"), "Ctrl+1"},
       {"affected_right", tr("Right"), tr("Affected side: right"), "Ctrl+2"},
       {"affected_both", tr("Both"), tr("Affected sides: both"), "Ctrl+3"},
       {"affected_none", tr("None"), tr("Affected side: none, healthy"), "Ctrl+4"}},
      this);
  dominant_ =
      new SegmentedChoice({{"dominant_left", tr("Left"), tr("Dominant hand: left"), "Ctrl+5"},
                           {"dominant_right", tr("Right"), tr("Dominant hand: right"), "Ctrl+6"}},
                          this);
  make_sex_and_year();
  make_onset();
  goals_ = text_field("goals", tr("Goals"),
                      tr("What the patient wants to do again; stays in the clinic, never in a "
                         "research export; Ctrl+Z takes back what was typed (Ctrl+Shift+G)"),
                      "Ctrl+Shift+G");
  notes_ = text_field("notes", tr("Notes"),
                      tr("What colleagues should know; stays in the clinic, never in a research "
                         "export; Ctrl+Z takes back what was typed (Ctrl+Shift+N)"),
                      "Ctrl+Shift+N");
  place_fields();
  for (auto* segments : {affected_, dominant_, sex_})
    connect(segments, &SegmentedChoice::chosen_by_user, this, &PersonCard::left);
  for (auto* field : {goals_, notes_})
    connect(field, &QPlainTextEdit::textChanged, this, &PersonCard::typed);
}

void PersonCard::make_onset() {
  onset_ = new DateField(Ahead::refused);
  onset_->setObjectName("onset");
  onset_->setPlaceholderText(tr("not known"));
  onset_->setClearButtonEnabled(true);
  describe(*onset_, tr("Day of the onset"),
           tr("Year-month-day; empty: not known; Up and Down change it (Ctrl+Shift+O)"));
  add_key(this, "Ctrl+Shift+O", [this] { onset_->setFocus(); });
  onset_remark_ = new Remark;
  onset_remark_->setObjectName("onset_remark");
  // Half a date may be another one: 2025-02-2 on the way to 2025-02-29. A whole one is taken.
  connect(onset_, &QLineEdit::textChanged, this, [this](const QString& text) {
    onset_remark_->say({});
    const auto day = onset_->typed().value;
    if (!day || text != translated_date(iso_text(*day))) return;
    finish();
    Q_EMIT typed();
  });
  connect(onset_, &QLineEdit::editingFinished, this, [this] {
    finish();
    Q_EMIT left();
  });
}

void PersonCard::place_fields() {
  column_->addWidget(caption(tr("Affected side"), affected_));
  column_->addWidget(affected_);
  // Two and two side by side: the texts below need the room.
  auto* pairs = new QGridLayout;
  pairs->setColumnStretch(0, 2);
  pairs->setColumnStretch(1, 1);
  const auto put = [pairs](int row, int column, const QString& title, QWidget* field) {
    pairs->addWidget(caption(title, field), 2 * row, column);
    pairs->addWidget(field, 2 * row + 1, column);
  };
  put(0, 0, tr("Dominant hand"), dominant_);
  put(0, 1, tr("Onset"), onset_);
  put(1, 0, tr("Sex"), sex_);
  put(1, 1, tr("Year of birth"), born_);
  column_->addLayout(pairs);
  column_->addWidget(onset_remark_);
  column_->addWidget(born_remark_);
  column_->addWidget(caption(tr("Goals"), goals_));
  column_->addWidget(goals_, 1);
  column_->addWidget(caption(tr("Notes"), notes_));
  column_->addWidget(notes_, 1);
}

/// By these and the dominant hand healthy people of the same kind are found.
void PersonCard::make_sex_and_year() {
  sex_ = new SegmentedChoice({{"sex_female", tr("Female"), tr("Sex: female"), "Ctrl+7"},
                              {"sex_male", tr("Male"), tr("Sex: male"), "Ctrl+8"},
                              {"sex_other", tr("Other"), tr("Sex: other"), "Ctrl+9"}},
                             this);
  born_ = new QLineEdit;
  born_->setObjectName("birth_year");
  born_->setPlaceholderText(tr("not known"));
  born_->setMaxLength(4);
  describe(*born_, tr("Year of birth"),
           tr("Four digits; empty: not known; the day belongs to the name (Ctrl+Shift+B)"));
  add_key(this, "Ctrl+Shift+B", [this] { born_->setFocus(); });
  born_remark_ = new Remark;
  born_remark_->setObjectName("birth_year_remark");
  connect(born_, &QLineEdit::textChanged, this, [this](const QString& text) {
    born_remark_->say({});
    if (text.size() < born_->maxLength()) return;
    finish_year();
    if (!born_remark_->warns()) Q_EMIT typed();
  });
  connect(born_, &QLineEdit::editingFinished, this, [this] {
    finish_year();
    Q_EMIT left();
  });
}

QString PersonCard::refused() const {
  if (onset_remark_->warns()) return tr("Saved, but for the onset");
  return born_remark_->warns() ? tr("Saved, but for the year of birth") : QString();
}

void PersonCard::finish_year() {
  const QString text = born_->text().trimmed();
  bool number = false;
  const int year = text.toInt(&number);
  const int now = static_cast<int>(local_today().year());
  born_remark_->say({});
  if (text.isEmpty())
    birth_year_.reset();
  else if (number && year >= storage::kFirstYear && year <= now)
    birth_year_ = year;
  else
    born_remark_->warn(
        tr("Not stored. Give a year from %1 to %2.").arg(storage::kFirstYear).arg(now));
}

QPlainTextEdit* PersonCard::text_field(const QString& name, const QString& title,
                                       const QString& tooltip, const QString& key) {
  auto* field = new QPlainTextEdit;
  field->setObjectName(name);
  field->setTabChangesFocus(true);
  take_rest(*field, kText_px);
  field->installEventFilter(this);
  describe(*field, title, tooltip);
  add_key(this, key, [field] { field->setFocus(); });
  return field;
}

bool PersonCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) Q_EMIT left();
  return Card::eventFilter(watched, event);
}

void PersonCard::show_profile(const storage::PatientProfile& profile) {
  affected_->choose(index_in(kSides, profile.affected));
  dominant_->choose(index_in(kHands, profile.dominant));
  sex_->choose(index_in(kSexes, profile.sex));
  birth_year_ = profile.birth_year;
  {
    const QSignalBlocker quiet(born_);
    born_->setText(profile.birth_year ? QString::number(*profile.birth_year) : QString());
  }
  onset_iso_ = profile.onset_date;
  {
    const QSignalBlocker quiet(onset_);
    onset_->setText(translated_date(profile.onset_date));  // also forgets what was typed
  }
  finish();
  const std::pair<QPlainTextEdit*, const std::string*> texts[] = {{goals_, &profile.goals},
                                                                  {notes_, &profile.notes}};
  for (const auto& [field, text] : texts) {
    const QSignalBlocker quiet(field);
    field->setPlainText(QString::fromStdString(*text));
  }
}

storage::PatientProfile PersonCard::profile() const {
  return {value_at(kSides, affected_->chosen()),
          value_at(kHands, dominant_->chosen()),
          onset_iso_,
          notes_->toPlainText().toStdString(),
          goals_->toPlainText().toStdString(),
          value_at(kSexes, sex_->chosen()),
          birth_year_};
}

void PersonCard::finish() {
  finish_year();
  const QString text = onset_->text().trimmed();
  const auto onset = onset_->typed();
  if (text.isEmpty()) {
    onset_iso_.clear();
    onset_remark_->say({});
  } else if (onset.value) {
    onset_iso_ = iso_text(*onset.value);
    const QString iso = translated_date(onset_iso_);
    const QSignalBlocker quiet(onset_);
    if (onset_->text() != iso) onset_->setText(iso);
    onset_remark_->say(onset_words(*onset.value, local_today()));
  } else {
    onset_remark_->warn(tr("Not stored. %1").arg(onset.problem));
  }
}

TreatmentCard::TreatmentCard(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Treatment"));
  date_ = entry_date("treatment_date", tr("Day of the treatment"), "Ctrl+Shift+T", Ahead::allowed,
                     this);
  kind_ = new ChoiceBox;
  kind_->setObjectName("treatment_kind");
  for (const auto kind : storage::kTreatmentKinds) {
    const std::string name(kind);
    kind_->addItem(treatment_words(name), QString::fromStdString(name));
  }
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  describe(*kind_, tr("Kind of treatment"), tr("Kind of treatment (Alt+Down shows all)"));
  text_ = entry_text("treatment_text", tr("What was done"), tr("Muscles, dose, what changed"));
  auto* add = add_button("treatment_add", tr("Add this treatment"), this);
  remark_ = new Remark;
  remark_->setObjectName("treatment_remark");
  list_ = new DatedList(
      "treatment", tr("Treatments"), {tr("Date"), tr("Kind"), tr("What")},
      tr("No treatment is entered. What changed, and when, helps to read the trends."), this);
  auto* entry = new QGridLayout;
  entry->setSpacing(6);
  entry->addWidget(date_, 0, 0);
  entry->addWidget(kind_, 0, 1, 1, 2);
  entry->addWidget(text_, 1, 0, 1, 2);
  entry->addWidget(add, 1, 2);
  entry->setColumnStretch(1, 1);
  column_->addWidget(list_);
  column_->addWidget(caption(tr("New treatment"), date_));
  column_->addLayout(entry);
  column_->addWidget(remark_);

  connect(add, &QPushButton::clicked, this, &TreatmentCard::add);
  for (auto* field : {static_cast<QLineEdit*>(date_), text_}) {
    connect(field, &QLineEdit::returnPressed, this, &TreatmentCard::add);
    connect(field, &QLineEdit::textEdited, this, [this] { remark_->say({}); });
  }
  connect(list_, &DatedList::remove_pressed, this, [this](int row) {
    gone_.push_back(marks_[static_cast<std::size_t>(row)]);
    list_->offer_undo(mark_removed(gone_));
    marks_.erase(marks_.begin() + row);  // at once, so that it cannot be removed twice
    show_marks(std::vector(marks_));
    Q_EMIT removed(gone_.back().id);
  });
  connect(list_, &DatedList::undo_pressed, this, [this] {
    const storage::TreatmentMark back = gone_.back();
    gone_.pop_back();
    list_->offer_undo(mark_removed(gone_));
    Q_EMIT added(back);
  });
}

void TreatmentCard::show_marks(const std::vector<storage::TreatmentMark>& marks) {
  marks_ = marks;
  std::vector<QStringList> rows;
  for (const auto& mark : marks_)
    rows.push_back({translated_date(mark.on_date), treatment_words(mark.kind),
                    QString::fromStdString(mark.text)});
  list_->show_rows(rows);
}

void TreatmentCard::clear() {
  gone_.clear();
  list_->offer_undo({});
  show_marks({});
  date_->show_date(local_today());
  kind_->setCurrentIndex(0);
  text_->setText({});  // unlike clear() it cannot be taken back
  remark_->say({});
}

void TreatmentCard::add() {
  const auto date = date_->typed();
  if (!date.value) {
    remark_->warn(tr("Not added. %1").arg(date.problem));
    date_->setFocus();
    return;
  }
  date_->show_date(date.value);
  remark_->say({});
  Q_EMIT added({0, iso_text(*date.value), kind_->currentData().toString().toStdString(),
                text_->text().trimmed().toStdString()});
  text_->clear();
}

ScoreCard::ScoreCard(QWidget* parent) : Card({}, parent) {
  title_->setText(tr("Clinical scores"));
  date_ = entry_date("score_date", tr("Day of the score"), "Ctrl+Shift+S", Ahead::refused, this);
  scale_ = new ChoiceBox;
  scale_->setObjectName("score_scale");
  for (const auto& scale : storage::kClinicalScales) {
    const std::string name(scale.name);
    scale_->addItem(name == "sensation" ? tr("Sensation") : QString::fromStdString(name));
    scale_->setItemData(scale_->count() - 1, scale_words(scale.name), Qt::ToolTipRole);
  }
  describe(*scale_, tr("Clinical scale"), tr("Clinical scale (Alt+Down shows all)"));
  value_ = entry_text("score_value", tr("Score"), tr("Score"));
  text_ = entry_text("score_text", tr("Remark on the score"), tr("Muscle, side, remark"));
  auto* add = add_button("score_add", tr("Add this score"), this);
  remark_ = new Remark;
  remark_->setObjectName("score_remark");
  list_ = new DatedList("score", tr("Clinical scores"),
                        {tr("Date"), tr("Scale"), tr("Score"), tr("Remark")},
                        tr("No score is entered. Any scale that the clinic uses anyway helps to "
                           "read the trends."),
                        this);
  auto* entry = new QGridLayout;
  entry->setSpacing(6);
  entry->addWidget(date_, 0, 0);
  entry->addWidget(scale_, 0, 1);
  entry->addWidget(value_, 0, 2);
  entry->addWidget(remark_, 1, 0, 1, 3);
  entry->addWidget(text_, 2, 0, 1, 2);
  entry->addWidget(add, 2, 2);
  entry->setColumnStretch(1, 1);
  value_->setFixedWidth(scaled(84));
  column_->addWidget(list_);
  column_->addWidget(caption(tr("New score"), date_));
  column_->addLayout(entry);

  connect(add, &QPushButton::clicked, this, &ScoreCard::add);
  for (auto* field : {static_cast<QLineEdit*>(date_), value_, text_})
    connect(field, &QLineEdit::returnPressed, this, &ScoreCard::add);
  connect(date_, &QLineEdit::textEdited, this, [this] { read_value(false); });
  connect(value_, &QLineEdit::textEdited, this, [this] { read_value(false); });
  connect(value_, &QLineEdit::editingFinished, this, [this] { read_value(true); });
  connect(scale_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { read_value(true); });
  connect(list_, &DatedList::remove_pressed, this, [this](int row) {
    gone_.push_back(scores_[static_cast<std::size_t>(row)]);
    list_->offer_undo(score_removed(gone_));
    scores_.erase(scores_.begin() + row);  // at once, so that it cannot be removed twice
    show_scores(std::vector(scores_));
    Q_EMIT removed(gone_.back().id);
  });
  connect(list_, &DatedList::undo_pressed, this, [this] {
    const storage::ClinicalScore back = gone_.back();
    gone_.pop_back();
    list_->offer_undo(score_removed(gone_));
    Q_EMIT added(back);
  });
  read_value(false);
}

const storage::ClinicalScale& ScoreCard::scale() const {
  return storage::kClinicalScales.at(static_cast<std::size_t>(scale_->currentIndex()));
}

/// The range stands there from the start; once a score is complete, also why it cannot be.
void ScoreCard::read_value(bool complete) {
  const auto value = typed_score(value_->text(), scale());
  if (complete && !value.value && !value_->text().trimmed().isEmpty())
    remark_->warn(value.problem);
  else
    remark_->say(range_words(scale()));
}

void ScoreCard::show_scores(const std::vector<storage::ClinicalScore>& scores) {
  scores_ = scores;
  std::vector<QStringList> rows;
  for (const auto& score : scores_)
    rows.push_back(
        {translated_date(score.on_date),
         score.scale == "sensation" ? tr("Sensation") : QString::fromStdString(score.scale),
         score_words(score), QString::fromStdString(score.text)});
  list_->show_rows(rows);
}

void ScoreCard::clear() {
  gone_.clear();
  list_->offer_undo({});
  show_scores({});
  date_->show_date(local_today());
  scale_->setCurrentIndex(0);
  value_->setText({});  // unlike clear() it cannot be taken back
  text_->setText({});
  read_value(false);
}

void ScoreCard::add() {
  const auto date = date_->typed();
  const auto value = typed_score(value_->text(), scale());
  if (!date.value || !value.value) {
    (date.value ? value_ : date_)->setFocus();  // leaving a field says its own remark
    remark_->warn(tr("Not added. %1").arg(date.value ? value.problem : date.problem));
    return;
  }
  date_->show_date(date.value);
  Q_EMIT added({0, iso_text(*date.value), std::string(scale().name), *value.value,
                text_->text().trimmed().toStdString()});
  value_->clear();
  text_->clear();
  read_value(false);
  value_->setFocus();
}

}  // namespace isograsp::gui
