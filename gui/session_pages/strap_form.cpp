// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/strap_form.hpp"

#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "gui/force_pages/safety_form.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// "chair with back, elbow 90°, …"
QString in_words(const SittingPosture& posture, bool without_seat) {
  QStringList words;
  for (const auto item : kPostureOrder) {
    if (posture.of(item).empty() || (without_seat && item == PostureItem::seat)) continue;
    const auto value = words_of(item, posture.of(item));
    words += item == PostureItem::seat
                 ? value
                 : StrapForm::tr("%1 %2").arg(in_sentence(words_of(item)), value);
  }
  return words.join(QStringLiteral(", "));
}

std::vector<Hand> hands_in(const SessionState& state) {
  if (measures_both(state)) return {Hand::left, Hand::right};
  return {state.choices.today.hand.value_or(Hand::right)};
}

bool all_as_last_time(SessionPresenter& presenter) {
  const Seating& seating = presenter.seating();
  const auto hands = hands_in(presenter.state());
  return std::all_of(hands.begin(), hands.end(), [&](Hand hand) {
    const SittingPosture& last = seating.last_posture(hand);
    return last.said() && seating.posture(hand) == last;
  });
}

/// With a place for the posture.
QString said_words(bool both, Hand hand, bool as_last_time) {
  if (!both) return as_last_time ? StrapForm::tr("As last time: %1.") : StrapForm::tr("Now: %1.");
  if (hand == Hand::left)
    return as_last_time ? StrapForm::tr("Left hand, as last time: %1.")
                        : StrapForm::tr("Left hand, now: %1.");
  return as_last_time ? StrapForm::tr("Right hand, as last time: %1.")
                      : StrapForm::tr("Right hand, now: %1.");
}
QString differing_words(bool both, Hand hand) {
  if (!both) return StrapForm::tr("Not as last time: %1.");
  return hand == Hand::left ? StrapForm::tr("Left hand, not as last time: %1.")
                            : StrapForm::tr("Right hand, not as last time: %1.");
}

}  // namespace

StrapForm::StrapForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  posture_ = new QLabel;
  posture_->setObjectName("posture");
  posture_->setWordWrap(true);
  edit_ = new QPushButton(tr("Posture an&d straps …"));
  edit_->setObjectName("posture_edit");
  edit_->setCheckable(true);
  describe(*edit_, tr("Posture and straps"),
           tr("Say how the patient sits and where the straps are (Alt+D)"));
  fields_ = new PostureFields(presenter_);
  fields_->hide();
  deviations_ = new QLabel;
  deviations_->setObjectName("posture_deviations");
  deviations_->setProperty("role", "problem");
  deviations_->setWordWrap(true);
  strapped_ = new QPushButton;
  strapped_->setObjectName("strapped");
  words_ = new QLabel;
  words_->setObjectName("strap_words");
  words_->setProperty("role", "quiet");
  words_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  for (QWidget* widget : {static_cast<QWidget*>(posture_), static_cast<QWidget*>(edit_),
                          static_cast<QWidget*>(fields_), static_cast<QWidget*>(deviations_),
                          static_cast<QWidget*>(new SafetyForm(presenter_)),
                          static_cast<QWidget*>(strapped_), static_cast<QWidget*>(words_)})
    column->addWidget(widget);
  connect(edit_, &QPushButton::toggled, fields_, &QWidget::setVisible);
  connect(strapped_, &QPushButton::clicked, this, [this] {
    edit_->setChecked(false);
    presenter_.preparing().mark_strapped();
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &StrapForm::refresh);
  refresh();
}

void StrapForm::refresh_posture() {
  const Seating& seating = presenter_.seating();
  const bool both = presenter_.flow().view().both_hands;
  QStringList said;
  QStringList differ;
  for (const Hand hand : hands_in(presenter_.state())) {
    const SittingPosture& posture = seating.posture(hand);
    const SittingPosture& last = seating.last_posture(hand);
    // The seat is that of the person, and said once.
    const auto words = in_words(posture, both && hand == Hand::right);
    if (!words.isEmpty()) said += said_words(both, hand, last.said() && posture == last).arg(words);
    if (const auto differs = deviations(posture, last); !differs.isEmpty())
      differ += differing_words(both, hand).arg(differs);
  }
  posture_->setText(said.join(QLatin1Char('\n')));
  posture_->setVisible(!said.isEmpty());
  deviations_->setText(differ.join(QLatin1Char('\n')));
  deviations_->setVisible(!differ.isEmpty());
}

void StrapForm::refresh() {
  const auto& view = presenter_.flow().view();
  fields_->refresh();
  refresh_posture();
  const bool both = view.both_hands;
  const bool as_last_time = all_as_last_time(presenter_);
  strapped_->setText(both && as_last_time ? tr("Both hands &in, as last time")
                     : both               ? tr("Both hands are &in")
                     : as_last_time       ? tr("Hand &in, strapped, as last time")
                                          : tr("Hand is &in and strapped"));
  describe(*strapped_, strapped_->text().remove(QLatin1Char('&')),
           tr("It is as said above. From now a minute to settle, then the resting force can be "
              "measured (Alt+I)"));
  strapped_->setEnabled(view.may_strap);
  mark_next(*strapped_, view.press == NextPress::strap);
  const auto rest = presenter_.state().rest_words();
  words_->setText(rest.empty() ? tr("After a minute of settling the resting force is measured.")
                               : translated(rest));
}

}  // namespace isograsp::gui
