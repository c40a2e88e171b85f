// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/hand_screening_form.hpp"

#include <QSignalBlocker>

#include "gui/look/look.hpp"

namespace isograsp::gui {

HandScreeningForm::HandScreeningForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  make_hand_questions(*column);
  make_hand_decision(*column);
  advice_ = new QLabel;
  advice_->setObjectName("hand_screening_advice");
  advice_->setWordWrap(true);
  column->addWidget(advice_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &HandScreeningForm::refresh);
  refresh();
}

void HandScreeningForm::make_hand_questions(QVBoxLayout& column) {
  nothing_ = new QPushButton;
  nothing_->setObjectName("hand_screening_clear");
  describe(*nothing_, tr("Nothing applies, no pain: the hand may move"),
           tr("None of the reasons below, no pain, forearm as ticked (Alt+P)"));
  column.addWidget(nothing_);
  connect(nothing_, &QPushButton::clicked, this, [this] {
    HandScreening answers;
    answers.pain = 0;
    answers.forearm_supported = forearm_->isChecked();
    answers.may_move = true;
    presenter_.choices().answer_screening(answers);
  });
  for (const HandQuestion question : kHandQuestions) {
    auto* box = new QCheckBox(words_of(question));
    box->setObjectName(QStringLiteral("hand_screening_%1").arg(QLatin1String(name_of(question))));
    describe(*box, words_of(question), tr("%1 (Tab, then space)").arg(details_of(question)));
    questions_[static_cast<std::size_t>(question)] = box;
    column.addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, question](bool on) {
      answer([&](HandScreening& all) { all.yes[static_cast<std::size_t>(question)] = on; });
    });
  }
  column.addWidget(new QLabel(tr("Pain now, at rest")));
  pain_ = new ScoreRow("hand_screening_pain", tr("Pain now"));
  column.addWidget(pain_);
  connect(pain_, &ScoreRow::chosen, this,
          [this](int pain) { answer([&](HandScreening& all) { all.pain = pain; }); });
  forearm_ = new QCheckBox(tr("Forearm supported"));
  forearm_->setObjectName("forearm_supported");
  describe(*forearm_, tr("Forearm supported"),
           tr("It lies on the table or a rest while the hand works; stored with the session (Tab, "
              "then space)"));
  column.addWidget(forearm_);
  connect(forearm_, &QCheckBox::toggled, this, [this](bool on) {
    HandScreening answers = presenter_.state().choices.today.hand_screening;
    answers.forearm_supported = on;  // no reason to decide anew
    presenter_.choices().answer_screening(answers);
  });
}

void HandScreeningForm::make_hand_decision(QVBoxLayout& column) {
  column.addWidget(new QLabel(tr("You decide for this hand")));
  const auto make = [&](const char* name, const QString& words, bool may_move) {
    auto* button = new QPushButton(words);
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    describe(*button, words, tr("%1: this hand, today (Tab, then space)").arg(words));
    column.addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, may_move] {
      HandScreening answers = presenter_.state().choices.today.hand_screening;
      answers.may_move = may_move;
      presenter_.choices().answer_screening(answers);
    });
    return button;
  };
  moves_ = make("hand_screening_moves", tr("It may move"), true);
  rests_ = make("hand_screening_rests", tr("No movement"), false);
}

void HandScreeningForm::answer(const std::function<void(HandScreening&)>& change) {
  HandScreening answers = presenter_.state().choices.today.hand_screening;
  change(answers);
  answers.may_move.reset();
  presenter_.choices().answer_screening(answers);
}

void HandScreeningForm::refresh() {
  const bool shown = presenter_.state().measures_hand();
  show_part(*this, shown);
  // The key belongs to the form that is shown.
  const QString words = tr("Nothing applies, no &pain");
  nothing_->setText(shown ? words : QString(words).remove(QLatin1Char('&')));
  const auto& answers = presenter_.state().choices.today.hand_screening;
  const auto& view = presenter_.flow().view();
  setEnabled(view.may_change_hand);
  const bool next = view.press == NextPress::screening;
  HandScreening untouched;
  untouched.forearm_supported = answers.forearm_supported;
  mark_choice(*nothing_, next && answers == untouched);
  for (const HandQuestion question : kHandQuestions) {
    auto* box = questions_[static_cast<std::size_t>(question)];
    const QSignalBlocker quiet(box);
    box->setChecked(answers.is(question));
  }
  pain_->show_value(answers.pain);
  {
    const QSignalBlocker quiet(forearm_);
    forearm_->setChecked(answers.forearm_supported);
  }
  const auto proposal = suggested(answers);
  for (auto* button : {moves_, rests_}) {
    const bool moves = button == moves_;
    button->setEnabled(answers.pain.has_value());
    button->setChecked(answers.may_move == moves);
    mark_choice(*button, next && proposal == moves && !answers.may_move);
  }
  advice_->setText(advice(answers));
  advice_->setVisible(!advice_->text().isEmpty());
}

}  // namespace isograsp::gui
