// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/screening_form.hpp"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kUsualCeiling_N = 20;
constexpr int kLeastCeiling_N = 1;
constexpr int kMostCeiling_N = 500;
constexpr std::array<tasks::Effort, 3> kEfforts{tasks::Effort::maximum, tasks::Effort::comfortable,
                                                tasks::Effort::none};
}  // namespace

ScreeningForm::ScreeningForm(SessionPresenter& presenter, std::optional<Hand> of, QWidget* parent)
    : QWidget(parent), presenter_(presenter), of_(of) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  make_questions(*column);
  make_decision(*column);
  make_limit(*column);
  advice_ = new QLabel;
  advice_->setObjectName(name_of_part("advice"));
  advice_->setWordWrap(true);
  column->addWidget(advice_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ScreeningForm::refresh);
  refresh();
}

/// "screening_clear", of one of both hands "left_screening_clear".
QString ScreeningForm::name_of_part(const QString& part) const {
  const auto name = QStringLiteral("screening_%1").arg(part);
  return of_ ? QStringLiteral("%1_%2").arg(*of_ == Hand::left ? "left" : "right", name) : name;
}

const Screening& ScreeningForm::answers() const {
  const auto& today = presenter_.state().choices.today;
  return of_ ? today.screenings[*of_] : today.screening;
}

/// What applies, and how much it hurts.
void ScreeningForm::make_questions(QVBoxLayout& column) {
  nothing_ = new QPushButton(tr("Nothing applies, no &pain"));
  nothing_->setObjectName(name_of_part("clear"));
  describe(*nothing_, tr("Nothing applies, no pain: maximum allowed"),
           tr("None of the reasons below, no pain: maximal effort is allowed (Alt+P)"));
  column.addWidget(nothing_);
  connect(nothing_, &QPushButton::clicked, this, [this] {
    Screening answers;
    answers.pain = 0;
    answers.allowed = tasks::Effort::maximum;
    answers.ceiling_N = this->answers().ceiling_N;
    answer(answers);
  });
  for (const Caution caution : kCautions) {
    auto* box = new QCheckBox(words_of(caution));
    box->setObjectName(name_of_part(QLatin1String(name_of(caution))));
    describe(*box, words_of(caution), tr("%1 (Tab, then space)").arg(details_of(caution)));
    cautions_[static_cast<std::size_t>(caution)] = box;
    column.addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, caution](bool on) {
      Screening answers = this->answers();
      answers.applies[static_cast<std::size_t>(caution)] = on;
      answers.allowed.reset();  // decided anew
      answer(answers);
    });
  }
  column.addWidget(new QLabel(tr("Pain now, at rest")));
  pain_ = new ScoreRow(name_of_part("pain"), tr("Pain now"));
  column.addWidget(pain_);
  connect(pain_, &ScoreRow::chosen, this, [this](int pain) {
    Screening answers = this->answers();
    answers.pain = pain;
    answers.allowed.reset();
    answer(answers);
  });
}

/// How much effort is allowed.
void ScreeningForm::make_decision(QVBoxLayout& column) {
  column.addWidget(new QLabel(tr("You decide for this hand")));
  for (const tasks::Effort effort : kEfforts) {
    auto* button = new QPushButton(words_of(effort));
    button->setObjectName(
        name_of_part(QStringLiteral("allow_%1")
                         .arg(QString::fromStdString(std::string(tasks::name_of(effort))))));
    button->setCheckable(true);
    describe(*button, words_of(effort),
             tr("%1 of this hand today (Tab, then space)").arg(words_of(effort)));
    efforts_[static_cast<std::size_t>(effort)] = button;
    column.addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, effort] {
      Screening answers = this->answers();
      answers.allowed = effort;
      answer(answers);
    });
  }
}

/// The largest force of a target.
void ScreeningForm::make_limit(QVBoxLayout& column) {
  limited_ = new QCheckBox(tr("No target above"));
  limited_->setObjectName(name_of_part("limited"));
  describe(*limited_, tr("Limit all targets"),
           tr("No target may exceed this force (Tab, then space)"));
  ceiling_ = new QSpinBox;
  ceiling_->setObjectName(name_of_part("ceiling"));
  ceiling_->setRange(kLeastCeiling_N, kMostCeiling_N);
  ceiling_->setValue(kUsualCeiling_N);
  ceiling_->setSuffix(tr(" N"));
  ceiling_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  describe(*ceiling_, tr("Largest target in newtons"),
           tr("No target may exceed this force (Tab, arrow keys)"));
  auto* limit = new QHBoxLayout;
  limit->addWidget(limited_);
  limit->addWidget(ceiling_);
  limit->addStretch(1);
  column.addLayout(limit);
  const auto set_ceiling = [this] {
    Screening answers = this->answers();
    answers.ceiling_N.reset();
    if (limited_->isChecked()) answers.ceiling_N = ceiling_->value();
    answer(answers);
  };
  connect(limited_, &QCheckBox::toggled, this, set_ceiling);
  connect(ceiling_, QOverload<int>::of(&QSpinBox::valueChanged), this, set_ceiling);
}

void ScreeningForm::answer(Screening answers) {
  presenter_.choices().answer_screening(answers, of_);
}

void ScreeningForm::show_form(bool shown) {
  show_part(*this, shown);
  // The key belongs to the form that is shown.
  const QString words = tr("Nothing applies, no &pain");
  nothing_->setText(shown ? words : QString(words).remove(QLatin1Char('&')));
}

void ScreeningForm::refresh() {
  const SessionState& state = presenter_.state();
  if (!of_) show_form(!state.measures_arm() && !state.measures_hand() && !measures_both(state));
  const Screening& answers = this->answers();
  const auto& view = presenter_.flow().view();
  setEnabled(view.may_change_hand);
  const bool next = view.press == NextPress::screening;
  const bool untouched = answers == Screening{};
  mark_choice(*nothing_, next && untouched);
  for (const Caution caution : kCautions) {
    auto* box = cautions_[static_cast<std::size_t>(caution)];
    const QSignalBlocker quiet(box);
    box->setChecked(answers.applies[static_cast<std::size_t>(caution)]);
  }
  pain_->show_value(answers.pain);
  const auto proposal = suggested(answers);
  for (const tasks::Effort effort : kEfforts) {
    auto* button = efforts_[static_cast<std::size_t>(effort)];
    button->setEnabled(answers.pain.has_value());
    button->setChecked(answers.allowed == effort);
    mark_choice(*button, next && proposal == effort && !answers.allowed);
  }
  {
    const QSignalBlocker quiet(limited_);
    limited_->setChecked(answers.ceiling_N.has_value());
  }
  if (!answers.ceiling_N) {
    const QSignalBlocker quiet(ceiling_);
    ceiling_->setValue(kUsualCeiling_N);  // not the limit of the patient before
  }
  ceiling_->setEnabled(limited_->isChecked());
  advice_->setText(advice(answers));
  advice_->setVisible(!advice_->text().isEmpty());
}

}  // namespace isograsp::gui
