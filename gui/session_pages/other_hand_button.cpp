// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/other_hand_button.hpp"

#include "gui/look/look.hpp"

namespace isograsp::gui {

OtherHandButton::OtherHandButton(SessionPresenter& presenter, const char* name, QWidget* parent)
    : QPushButton(parent), presenter_(presenter) {
  setObjectName(QLatin1String(name));
  connect(this, &QPushButton::clicked, &presenter_,
          [this] { presenter_.connecting().take_other_hand(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &OtherHandButton::refresh);
  hide();
  refresh();
}

void OtherHandButton::refresh() {
  const FlowView& view = presenter_.flow().view();
  show_part(*this, view.may_take_other_hand);
  const auto& open = presenter_.state().open;
  const std::optional<Hand> now = open ? open->session->known().record.hand : std::nullopt;
  // Without a session nobody sees it.
  const QString words =
      now == Hand::left    ? view.start_posture ? tr("Now the right arm") : tr("Now the right hand")
         : view.start_posture ? tr("Now the left arm")
                           : tr("Now the left hand");
  if (words == text()) return;
  setText(words);
  describe(*this, words,
           tr("What was done is kept; screening, zero and straps are asked anew, the device stays "
              "chosen (Tab, then space)"));
}

}  // namespace isograsp::gui
