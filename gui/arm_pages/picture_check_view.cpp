// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/picture_check_view.hpp"

#include <algorithm>

#include "gui/arm_pages/arm_words.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

PictureCheckView::PictureCheckView(SessionPresenter& presenter, Moves moves, QWidget* card)
    : QObject(card),
      presenter_(presenter),
      moves_(moves),
      button_(new QPushButton(card)),
      words_(new QLabel(card)) {
  const auto of_hand = moves == Moves::hand ? QStringLiteral("hand_") : QString();
  button_->setObjectName(of_hand + QStringLiteral("picture_check"));
  words_->setObjectName(of_hand + QStringLiteral("picture_check_words"));
  words_->setWordWrap(true);
  connect(button_, &QPushButton::clicked, this, [this] { presenter_.preparing().check_picture(); });
}

void PictureCheckView::refresh() {
  const auto& open = presenter_.state().open;
  const FlowView& view = presenter_.flow().view();
  const bool running = open && open->picture_check.running();
  button_->setText(running ? tr("Stop the check") : tr("Check the picture"));
  describe(*button_, button_->text(),
           moves_ == Moves::hand
               ? tr("The hand is moved to the right, up and away, towards the screen; the picture "
                    "must do the same. Before the first object (Tab, then space)")
               : tr("You move the object to the right, up and away, towards the screen; the "
                    "picture must do the same. Before the first trial (Tab, then space)"));
  button_->setEnabled(running || view.may_watch_picture);
  mark_next(*button_, view.press == NextPress::picture);
  words_->setText(open ? words_of(open->picture_check) : QString());
  words_->setVisible(!words_->text().isEmpty());
}

QString PictureCheckView::way_words(PictureCheck::Way way) const {
  switch (way) {
    case PictureCheck::Way::right:
      return moves_ == Moves::hand
                 ? tr("The hand moves 10 cm to the right, and rests.")
                 : tr("Move the object 10 cm to the right, seen by the patient, and rest.");
    case PictureCheck::Way::up:
      return moves_ == Moves::hand ? tr("It moves 10 cm up, and rests.")
                                   : tr("Move it 10 cm up, and rest.");
    case PictureCheck::Way::away: break;
  }
  return moves_ == Moves::hand ? tr("It moves 10 cm away, towards the screen, and rests.")
                               : tr("Move it 10 cm away, towards the screen, and rest.");
}

QString PictureCheckView::words_of(const PictureCheck& check) const {
  const bool hand = moves_ == Moves::hand;
  if (const auto way = check.asked()) return way_words(*way);
  if (check.running())
    return hand ? tr("The hand is held still where the tracker sees it.")
                : tr("Hold the object still where the cameras see it.");
  if (!check.over()) return {};
  if (check.good())
    return hand ? tr("✓ The picture moves as the hand does.")
                : tr("✓ The picture moves as the object does.");
  double most_rad = 0.0;
  for (const auto& off_rad : check.off_rad()) most_rad = std::max(most_rad, *off_rad);
  return (hand ? tr("✗ In the picture it went %1° off. Once more; if it stays so, the tracker "
                    "stands another way than its program says: no object comes.")
               : tr("✗ In the picture it went %1° off. Once more; if it stays so, [view] of the "
                    "rig names other axes: nothing begins that is done by this picture."))
      .arg(in_degrees(most_rad));
}

}  // namespace isograsp::gui
