// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/entry_form.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/hand_pages/hand_words.hpp"
#include "gui/hand_pages/size_offer.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// What the running test asks for.
QString asked_words(const session::EntryShown& entry) {
  if (entry.stage == session::HandEntry::Stage::rest)
    return EntryForm::tr("At rest: the hand lies still for ten seconds.");
  const auto now = entry.open ? EntryForm::tr("Now open wide.") : EntryForm::tr("Now close.");
  return EntryForm::tr("%1 Opened %2 of %3 times.")
      .arg(now)
      .arg(entry.openings)
      .arg(session::HandEntry::kOpenings);
}

QString widest_words(double opening_m) {
  return EntryForm::tr("Opens %1 mm: objects up to %2 mm are offered.")
      .arg(in_whole_mm(opening_m), in_whole_mm(session::HandEntry::kLargestOfOpening * opening_m));
}

}  // namespace

EntryForm::EntryForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  light_ = new StateLight(22);
  light_->setObjectName("entry_light");
  words_ = new QLabel;
  words_->setObjectName("entry_words");
  words_->setWordWrap(true);
  size_ = new QLabel;
  size_->setObjectName("entry_size");
  size_->setProperty("role", "quiet");
  size_->setWordWrap(true);
  begin_ = new QPushButton;
  begin_->setObjectName("entry_test");
  progress_ = new QProgressBar;
  progress_->setObjectName("entry_progress");
  progress_->setRange(0, 100);
  describe(*progress_, tr("Entry test"),
           tr("Entry test: ten seconds at rest, then three openings"));
  progress_->hide();
  result_ = new QLabel;
  result_->setObjectName("entry_result");
  result_->setWordWrap(true);
  auto* state = new QHBoxLayout;
  state->setSpacing(8);
  state->addWidget(light_, 0, Qt::AlignTop);
  state->addWidget(words_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  column->addLayout(state);
  column->addWidget(size_);
  column->addWidget(progress_);
  column->addWidget(result_);
  column->addWidget(begin_);
  connect(begin_, &QPushButton::clicked, this, [this] { presenter_.preparing().set_zero(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &EntryForm::refresh);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &EntryForm::refresh_light);
  refresh();
}

void EntryForm::refresh() {
  const auto& view = presenter_.flow().view();
  show_part(*this, view.hand_entry);
  size_->setText(size_words(presenter_.state()));
  size_->setVisible(!size_->text().isEmpty());
  const auto& open = presenter_.state().open;
  const Text refusal = open ? open->preparation.zero_refusal : Text();
  const bool passed = open && open->hand && open->hand->opening_m > 0.0;
  begin_->setText(passed || !refusal.empty() ? tr("Once more") : tr("Begin the entry test"));
  describe(*begin_, tr("Entry test"),
           tr("Ten seconds at rest, then open and close three times: says whether virtual objects "
              "are for this hand, and how wide ones (Tab, then space)"));
  begin_->setEnabled(view.may_zero);
  mark_next(*begin_, view.press == NextPress::zero);
  result_->setText(!refusal.empty() ? translated(refusal)
                   : passed         ? widest_words(open->hand->opening_m)
                                    : QString());
  result_->setVisible(!result_->text().isEmpty() && progress_->isHidden());
  refresh_light();
}

void EntryForm::refresh_light() {
  const auto& open = presenter_.state().open;
  if (!open || !open->hand) {
    light_->show_mood(Mood::off);
    words_->setText(tr("Ten seconds at rest on the table, then open and close three times."));
    progress_->hide();
    return;
  }
  const session::HandSnapshot& now = *open->hand;
  const bool runs = now.entry.has_value();
  if (progress_->isVisibleTo(this) != runs) refresh_running(runs);
  progress_->setValue(static_cast<int>(100.0 * now.zero_progress));
  const Mood mood = now.hand.held ? Mood::attention : runs ? Mood::busy : Mood::ready;
  if (light_->mood() != mood) light_->show_mood(mood);
  words_->setText(now.hand.held ? tr("The hand is not seen: bring it before the tracker.")
                  : runs        ? asked_words(*now.entry)
                                : tr("The hand is seen."));
}

/// While the test runs its progress stands in the place of button and result.
void EntryForm::refresh_running(bool runs) {
  progress_->setVisible(runs);
  begin_->setVisible(!runs);
  if (runs) result_->hide();
}

}  // namespace isograsp::gui
