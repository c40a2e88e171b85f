// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/hand_pages/size_offer.hpp"

#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

SizeOffer::SizeOffer(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  take_ = new QCheckBox;
  take_->setObjectName("size_of_other");
  from_ = new QLabel;
  from_->setObjectName("size_of_other_from");
  from_->setProperty("role", "quiet");
  from_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(take_);
  column->addWidget(from_);
  connect(take_, &QCheckBox::toggled, this,
          [this](bool on) { presenter_.choices().take_size_of_other(on); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &SizeOffer::refresh);
  refresh();
}

void SizeOffer::refresh() {
  const SessionState& state = presenter_.state();
  const Choices& choices = state.choices;
  const bool offered = state.measures_hand() && !choices.other_hand_measured_on.empty();
  show_part(*this, offered && presenter_.flow().view().may_change_device);
  const bool right = choices.today.hand == Hand::right;
  take_->setText(right ? tr("It has the size of the left hand")
                       : tr("It has the size of the right hand"));
  describe(*take_, take_->text(),
           tr("For a hand that cannot open: the other one, mirrored; stored with the session (Tab, "
              "then space)"));
  const QSignalBlocker quiet(take_);
  take_->setChecked(choices.today.size_of_other);
  from_->setText(tr("For a hand that cannot open. Measured in the entry test of %1.")
                     .arg(translated_date(choices.other_hand_measured_on)));
}

QString size_words(const SessionState& state) {
  const Choices& choices = state.choices;
  if (!state.measures_hand() || !choices.today.size_of_other) return {};
  const auto words = choices.today.hand == Hand::right
                         ? SizeOffer::tr("Size: that of the left hand, entry test of %1.")
                         : SizeOffer::tr("Size: that of the right hand, entry test of %1.");
  return words.arg(translated_date(choices.other_hand_measured_on));
}

}  // namespace isograsp::gui
