// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/both_screening_form.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <utility>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

BothScreeningForm::BothScreeningForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (const Hand hand : kBothHands) {
    auto* head = heads_[hand] = new QPushButton;
    head->setObjectName(hand == Hand::left ? "screening_of_left" : "screening_of_right");
    head->setCheckable(true);
    row->addWidget(head);
    connect(head, &QPushButton::clicked, this, [this, hand] { show_hand(hand); });
    forms_[hand] = new ScreeningForm(presenter_, hand);
  }
  outcome_ = new QLabel;
  outcome_->setObjectName("both_screening_outcome");
  outcome_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(5);
  column->addLayout(row);
  for (const Hand hand : kBothHands) column->addWidget(forms_[hand]);
  column->addWidget(outcome_);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &BothScreeningForm::refresh);
  refresh();
}

void BothScreeningForm::show_hand(Hand hand) {
  shown_ = hand;
  refresh();
}

void BothScreeningForm::refresh() {
  const bool both = measures_both(presenter_.state());
  show_part(*this, both);
  const BothScreenings& answers = presenter_.state().choices.today.screenings;
  for (const Hand hand : kBothHands) {
    const bool done = answers[hand].complete();
    // The other hand follows; nobody has to look for what is still to be asked.
    if (done && !std::exchange(complete_[hand], done) && !answers[other_than(hand)].complete())
      shown_ = other_than(hand);
    complete_[hand] = done;
  }
  if (!complete_.left && !complete_.right && answers.right == Screening{}) shown_ = Hand::left;
  for (const Hand hand : kBothHands) {
    const auto name = hand == Hand::left ? tr("Left hand") : tr("Right hand");
    const bool done = complete_[hand];
    heads_[hand]->setText(done ? tr("✓ %1").arg(name) : name);
    describe(*heads_[hand], done ? tr("%1: answered").arg(name) : tr("%1: to be asked").arg(name),
             tr("The questions of this hand (Tab, then space)"));
    heads_[hand]->setChecked(shown_ == hand);
    forms_[hand]->show_form(both && shown_ == hand);
  }
  const bool known = both && complete(answers);
  outcome_->setVisible(known);
  if (known)
    outcome_->setText(tr("For both hands holds: %1.").arg(in_sentence(words_of(allowed(answers)))));
}

}  // namespace isograsp::gui
