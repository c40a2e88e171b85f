// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/safety_form.hpp"

#include <QSignalBlocker>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

SafetyForm::SafetyForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  stop_ = new QLabel;
  stop_->setObjectName("stop_tested");
  stop_->setWordWrap(true);
  reach_ = new QPushButton;
  reach_->setObjectName("within_reach");
  reach_->setCheckable(true);
  supports_ = new QLabel;
  supports_->setObjectName("supports_words");
  supports_->setWordWrap(true);
  strapped_too_ = new QCheckBox;
  strapped_too_->setObjectName("other_strapped");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  for (QWidget* widget : {static_cast<QWidget*>(stop_), static_cast<QWidget*>(reach_),
                          static_cast<QWidget*>(supports_), static_cast<QWidget*>(strapped_too_)})
    column->addWidget(widget);
  connect(reach_, &QPushButton::clicked, this,
          [this](bool on) { presenter_.preparing().stay_within_reach(on); });
  connect(strapped_too_, &QCheckBox::toggled, this,
          [this](bool on) { presenter_.preparing().other_hand_strapped(on); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &SafetyForm::refresh);
  refresh();
}

void SafetyForm::refresh() {
  const SessionState& state = presenter_.state();
  const FlowView& view = presenter_.flow().view();
  show_part(*this, measures_both(state));
  const HandsSafety safety = state.open ? state.open->preparation.safety : HandsSafety{};
  stop_->setText(safety.stop_tested
                     ? tr("✓ The stop was pressed, and works.")
                     : tr("Press the pedal (F9) or the stop key (F10) once, as a test."));
  reach_->setText(safety.within_reach ? tr("✓ I stay within reach") : tr("I stay within reach"));
  describe(
      *reach_, tr("I stay within reach"),
      tr("As long as hands are strapped you can free them at any time; stored with the session "
         "(Tab, then space)"));
  reach_->setEnabled(view.may_promise_reach);
  mark_next(*reach_, view.press == NextPress::reach);
  supports_->setText(
      tr("The less affected hand lies unstrapped in its supports, so that it can help."));
  strapped_too_->setText(tr("It is strapped, too"));
  describe(*strapped_too_, tr("The less affected hand is strapped, too"),
           tr("Against the rule; stored with the session (Tab, then space)"));
  strapped_too_->setEnabled(view.may_strap || view.may_promise_reach);
  const QSignalBlocker quiet(strapped_too_);
  reach_->setChecked(safety.within_reach);
  strapped_too_->setChecked(safety.other_strapped);
}

}  // namespace isograsp::gui
