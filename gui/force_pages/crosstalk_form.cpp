// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/crosstalk_form.hpp"

#include <QLocale>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

using State = CrossTalkCheck::State;

QString words_of_crosstalk(const CrossTalkCheck& check) {
  switch (check.state()) {
    case State::press_left:
      return CrossTalkForm::tr("Press the left platform with at least 20 N for half a second.");
    case State::press_right:
      return CrossTalkForm::tr("Now press the right platform with at least 20 N.");
    case State::skipped: return CrossTalkForm::tr("Skipped; this is stored with the session.");
    case State::idle:
      return CrossTalkForm::tr(
          "Do the platforms move each other? Both empty, press one, then the "
          "other.");
    case State::over: break;
  }
  const auto moved = QLocale().toString(check.moved_percent(), 'f', 1);
  if (*check.coupled())
    return CrossTalkForm::tr(
               "They move each other by %1 %: mount them apart. This session has no "
               "shares.")
        .arg(moved);
  return CrossTalkForm::tr("✓ They stand apart: %1 % at most.").arg(moved);
}

}  // namespace

CrossTalkForm::CrossTalkForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  words_ = new QLabel;
  words_->setObjectName("crosstalk_words");
  words_->setWordWrap(true);
  check_ = new QPushButton;
  check_->setObjectName("crosstalk_check");
  skip_ = new QPushButton(tr("Skip this check"));
  skip_->setObjectName("crosstalk_skip");
  describe(*skip_, skip_->text(),
           tr("Nobody knows then whether one platform moves the other; stored with the session "
              "(Tab, then space)"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  for (QWidget* widget :
       {static_cast<QWidget*>(words_), static_cast<QWidget*>(check_), static_cast<QWidget*>(skip_)})
    column->addWidget(widget);
  connect(check_, &QPushButton::clicked, this,
          [this] { presenter_.preparing().check_platforms(); });
  connect(skip_, &QPushButton::clicked, this,
          [this] { presenter_.preparing().skip_platforms_check(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &CrossTalkForm::refresh);
  refresh();
}

void CrossTalkForm::refresh() {
  const SessionState& state = presenter_.state();
  const FlowView& view = presenter_.flow().view();
  show_part(*this, state.open && measures_both(state) && state.snapshot().zeroed);
  const CrossTalkCheck check = state.open ? state.open->crosstalk : CrossTalkCheck{};
  words_->setText(words_of_crosstalk(check));
  check_->setText(check.running()   ? tr("Stop the check")
                  : check.settled() ? tr("Check the platforms again")
                                    : tr("Check the platforms"));
  describe(*check_, check_->text(),
           tr("Each is pressed, empty, with 20 N; the other one may feel 1 % of it (Tab, then "
              "space)"));
  check_->setEnabled(view.may_check_platforms);
  mark_next(*check_, view.press == NextPress::platforms);
  skip_->setEnabled(view.may_check_platforms && !check.settled());
}

}  // namespace isograsp::gui
