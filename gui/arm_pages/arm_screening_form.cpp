// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/arm_screening_form.hpp"

#include <QGridLayout>
#include <QSignalBlocker>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kLeastPassive_deg = -90;
constexpr int kMostPassive_deg = 180;
constexpr std::array<tasks::Effort, 3> kRanges{tasks::Effort::maximum, tasks::Effort::comfortable,
                                               tasks::Effort::none};
}  // namespace

ArmScreeningForm::ArmScreeningForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  make_questions(*column);
  make_ranges(*column);
  make_decision(*column);
  advice_ = new QLabel;
  advice_->setObjectName("arm_screening_advice");
  advice_->setWordWrap(true);
  column->addWidget(advice_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ArmScreeningForm::refresh);
  refresh();
}

void ArmScreeningForm::make_questions(QVBoxLayout& column) {
  nothing_ = new QPushButton(tr("Can do both, no &pain"));
  nothing_->setObjectName("arm_screening_clear");
  describe(*nothing_, tr("Can do both, no pain, nothing else: own range"),
           tr("No shoulder pain, no contracture, no tape allergy; turns by 10° and holds for 10 s "
              "(Alt+P)"));
  column.addWidget(nothing_);
  connect(nothing_, &QPushButton::clicked, this, [this] {
    ArmScreening answers;
    for (const ArmQuestion able : {ArmQuestion::turns, ArmQuestion::holds})
      answers.yes[static_cast<std::size_t>(able)] = true;
    answers.pain = 0;
    answers.passive = presenter_.state().choices.today.arm_screening.passive;
    answers.allowed = tasks::Effort::maximum;
    presenter_.choices().answer_screening(answers);
  });
  for (const ArmQuestion question : kArmQuestions) {
    auto* box = new QCheckBox(words_of(question));
    box->setObjectName(QStringLiteral("arm_screening_%1").arg(QLatin1String(name_of(question))));
    describe(*box, words_of(question), tr("%1 (Tab, then space)").arg(details_of(question)));
    questions_[static_cast<std::size_t>(question)] = box;
    column.addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, question](bool on) {
      answer([&](ArmScreening& all) { all.yes[static_cast<std::size_t>(question)] = on; });
    });
  }
  column.addWidget(new QLabel(tr("Pain now, at rest")));
  pain_ = new ScoreRow("arm_screening_pain", tr("Pain now"));
  column.addWidget(pain_);
  connect(pain_, &ScoreRow::chosen, this,
          [this](int pain) { answer([&](ArmScreening& all) { all.pain = pain; }); });
}

/// How far somebody else turns the joints of this arm, from neutral to either side.
void ArmScreeningForm::make_ranges(QVBoxLayout& column) {
  column.addWidget(new QLabel(tr("Passive range, as far as measured")));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(4);
  constexpr int kIndent_px = 22;
  grid->setColumnMinimumWidth(0, scaled(kIndent_px));
  for (const int column_of_angle : {1, 2}) grid->setColumnStretch(column_of_angle, 1);
  for (std::size_t j = 0; j < kPassiveJointCount; ++j) {
    const PassiveJoint& joint = passive_joints()[j];
    const auto title = words_of(joint);
    const auto name = QLatin1String(joint.name);
    JointRow& row = joints_[j];
    row.measured = new QCheckBox(title);
    row.measured->setObjectName(QStringLiteral("passive_%1").arg(name));
    describe(*row.measured, tr("%1: passive range measured").arg(title),
             tr("No target goes beyond this range (Tab, then space)"));
    const auto make_angle = [&](const QString& way, const char* end) {
      auto* angle = new QSpinBox;
      angle->setObjectName(QStringLiteral("passive_%1_%2").arg(name, QLatin1String(end)));
      angle->setRange(kLeastPassive_deg, kMostPassive_deg);
      angle->setSuffix(tr("°"));
      angle->setButtonSymbols(QAbstractSpinBox::NoButtons);
      describe(*angle, tr("%1, passive, in degrees").arg(way),
               tr("From neutral, thumb up; negative: neutral is not reached (Tab, arrow keys)"));
      return angle;
    };
    row.negative = make_angle(negative_words(joint), "negative");
    row.positive = make_angle(positive_words(joint), "positive");
    // The angles stand below their box: beside it there is no room for the words.
    const auto at = 2 * static_cast<int>(j);
    grid->addWidget(row.measured, at, 0, 1, 3);
    grid->addWidget(row.negative, at + 1, 1);
    grid->addWidget(row.positive, at + 1, 2);
    const auto set_range = [this, j] {
      const JointRow& from = joints_[j];
      answer([&](ArmScreening& all) {
        all.passive[j].reset();
        if (from.measured->isChecked())
          all.passive[j] = PassiveDegrees{from.negative->value(), from.positive->value()};
      });
    };
    connect(row.measured, &QCheckBox::toggled, this, set_range);
    connect(row.negative, QOverload<int>::of(&QSpinBox::valueChanged), this, set_range);
    connect(row.positive, QOverload<int>::of(&QSpinBox::valueChanged), this, set_range);
  }
  column.addLayout(grid);
}

void ArmScreeningForm::make_decision(QVBoxLayout& column) {
  column.addWidget(new QLabel(tr("You decide for this arm")));
  for (const tasks::Effort range : kRanges) {
    auto* button = new QPushButton(range_words(range));
    button->setObjectName(QStringLiteral("arm_screening_allow_%1")
                              .arg(QString::fromStdString(std::string(tasks::name_of(range)))));
    button->setCheckable(true);
    describe(*button, range_words(range),
             tr("%1 of this arm today (Tab, then space)").arg(range_words(range)));
    ranges_[static_cast<std::size_t>(range)] = button;
    column.addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, range] {
      ArmScreening answers = presenter_.state().choices.today.arm_screening;
      answers.allowed = range;
      presenter_.choices().answer_screening(answers);
    });
  }
}

void ArmScreeningForm::answer(const std::function<void(ArmScreening&)>& change) {
  ArmScreening answers = presenter_.state().choices.today.arm_screening;
  change(answers);
  answers.allowed.reset();
  presenter_.choices().answer_screening(answers);
}

void ArmScreeningForm::refresh() {
  const bool arm = presenter_.state().measures_arm();
  show_part(*this, arm);
  // The key belongs to the form that is shown.
  const QString words = tr("Can do both, no &pain");
  nothing_->setText(arm ? words : QString(words).remove(QLatin1Char('&')));
  const auto& answers = presenter_.state().choices.today.arm_screening;
  const auto& view = presenter_.flow().view();
  setEnabled(view.may_change_hand);
  const bool next = view.press == NextPress::screening;
  mark_choice(*nothing_, next && answers == ArmScreening{});
  for (const ArmQuestion question : kArmQuestions) {
    auto* box = questions_[static_cast<std::size_t>(question)];
    const QSignalBlocker quiet(box);
    box->setChecked(answers.is(question));
  }
  pain_->show_value(answers.pain);
  for (std::size_t j = 0; j < kPassiveJointCount; ++j) {
    const JointRow& row = joints_[j];
    const auto& range = answers.passive[j];
    const QSignalBlocker quiet_measured(row.measured);
    const QSignalBlocker quiet_negative(row.negative);
    const QSignalBlocker quiet_positive(row.positive);
    row.measured->setChecked(range.has_value());
    // Nothing is filled in beforehand: a range that nobody measured would be no limit.
    const PassiveDegrees shown = range.value_or(PassiveDegrees{});
    row.negative->setValue(shown.negative);
    row.positive->setValue(shown.positive);
    show_part(*row.negative, range.has_value());
    show_part(*row.positive, range.has_value());
  }
  const auto proposal = suggested(answers);
  for (const tasks::Effort range : kRanges) {
    auto* button = ranges_[static_cast<std::size_t>(range)];
    const bool possible = range == tasks::Effort::none || answers.offered();
    button->setEnabled(answers.pain.has_value() && answers.ranges_hold() && possible);
    button->setChecked(answers.allowed == range);
    mark_choice(*button, next && proposal == range && !answers.allowed);
  }
  advice_->setText(advice(answers));
  advice_->setVisible(!advice_->text().isEmpty());
}

}  // namespace isograsp::gui
