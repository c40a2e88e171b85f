// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/next_bar.hpp"

#include <QEvent>
#include <QHBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kNextButton_px = 200;  // at least: it does not move with every other word
constexpr int kStopButton_px = 110;

/// What there is to choose. A choice is made where its answers stand.
QString choice_words(const FlowView& view) {
  switch (view.press) {
    case NextPress::patient: return NextBar::tr("Choose a patient");
    case NextPress::hand:
      return view.start_posture ? NextBar::tr("Choose the arm") : NextBar::tr("Choose the hand");
    case NextPress::screening: return NextBar::tr("Answer the screening");
    case NextPress::earlier: return NextBar::tr("Go on or anew?");
    case NextPress::device: return NextBar::tr("Choose the device");
    default: return {};
  }
}

}  // namespace

NextBar::NextBar(SessionPresenter& presenter, QWidget* parent)
    : QFrame(parent), presenter_(presenter) {
  setObjectName("next_bar");
  light_ = new StateLight(28);
  sentence_ = new QLabel;
  sentence_->setObjectName("sentence");
  sentence_->setWordWrap(true);
  sentence_->setToolTip(tr("The state of the session and the sensible next step"));
  next_ = new QPushButton;
  next_->setObjectName("next_thing");
  next_->setMinimumWidth(scaled(kNextButton_px));
  next_->installEventFilter(this);
  stop_ = new QPushButton(tr("Stop"));
  stop_->setObjectName("stop");
  stop_->setMinimumWidth(scaled(kStopButton_px));
  describe(*stop_, tr("Stop the trial"), tr("End the trial now; it is kept and marked (F10)"));
  auto* said = new QHBoxLayout;
  said->setSpacing(12);
  said->addWidget(light_);
  said->addWidget(sentence_, 1);
  auto* pressed = new QHBoxLayout;
  pressed->setSpacing(12);
  pressed->addWidget(next_, 1);
  pressed->addWidget(stop_);
  auto* row = new QBoxLayout(side_by_side(), this);
  row->setContentsMargins(16, 8, 16, 8);
  row->setSpacing(row->direction() == QBoxLayout::LeftToRight ? 12 : 6);
  row->addLayout(said, 1);
  row->addLayout(pressed);
  connect(next_, &QPushButton::clicked, this, &NextBar::press);
  connect(stop_, &QPushButton::clicked, this, [this] { presenter_.trials().stop(); });
}

void NextBar::follow(QWidget& page) {
  page_ = &page;
  refresh();
}

void NextBar::refresh() {
  const FlowView& view = presenter_.flow().view();
  light_->show_mood(view.mood);
  sentence_->setText(QString::fromStdString(view.sentence));
  stop_->setEnabled(view.may_stop);
  marked_ = first_ == nullptr ? nullptr : marked_next(*first_);
  if (marked_ == nullptr && page_ != nullptr) marked_ = marked_next(*page_);
  const auto* button = qobject_cast<QAbstractButton*>(marked_.data());
  say(button != nullptr && !is_choice(*button) ? button->text().remove(QLatin1Char('&'))
      : marked_ != nullptr                     ? choice_words(view)
                                               : QString());
}

void NextBar::say(const QString& words) {
  next_->setVisible(!words.isEmpty());
  if (words == next_->text()) return;
  next_->setText(words);
  describe(*next_, words, marked_ == nullptr ? QString() : tr("The next thing to do (F8)"));
}

void NextBar::press() {
  refresh();
  if (marked_ == nullptr) return;
  auto* button = qobject_cast<QAbstractButton*>(marked_.data());
  if (button == nullptr || is_choice(*button))
    Q_EMIT chooses(marked_);
  else
    button->click();
}

/// The second half of a double click would press what has come in the place of the first.
bool NextBar::eventFilter(QObject* watched, QEvent* event) {
  return event->type() == QEvent::MouseButtonDblClick || QFrame::eventFilter(watched, event);
}

}  // namespace isograsp::gui
