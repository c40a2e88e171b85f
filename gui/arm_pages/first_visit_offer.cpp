// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/first_visit_offer.hpp"

#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "gui/library/session_library.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

FirstVisitOffer::FirstVisitOffer(SessionPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setProperty("confirm", true);
  words_ = new QLabel;
  words_->setObjectName("first_visit_words");
  words_->setWordWrap(true);
  take_ = new QPushButton(tr("Begin as a first &visit"));
  take_->setObjectName("take_first_visit");
  describe(*take_, tr("Choose the protocol of a first visit"),
           tr("It begins with practice in bouts (Alt+V)"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 6, 8, 8);
  column->addWidget(words_);
  column->addWidget(take_);
  connect(take_, &QPushButton::clicked, this, [this] {
    presenter_.choices().choose_protocol(
        first_visit_protocol(presenter_.state().library.protocols));
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &FirstVisitOffer::refresh);
  refresh();
}

void FirstVisitOffer::refresh() {
  const SessionState& state = presenter_.state();
  const auto offered = first_visit_protocol(state.library.protocols);
  const bool new_here = state.measures_arm() && state.choices.first_time;
  show_part(*this, new_here && presenter_.flow().view().may_change_hand && offered &&
                       offered != state.choices.protocol);
  if (!offered) return;
  constexpr double kMinute_s = 60.0;
  words_->setText(
      tr("This arm has not worked with the cameras before. “%1” begins with %2 minutes of "
         "practice.")
          .arg(translated(state.library.protocols[static_cast<std::size_t>(*offered)].spec.name))
          .arg(std::lround(kFirstVisit_s / kMinute_s)));
}

}  // namespace isograsp::gui
