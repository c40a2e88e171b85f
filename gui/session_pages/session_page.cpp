// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/session_page.hpp"

#include <QApplication>
#include <QVBoxLayout>

#include "gui/arm_pages/arm_panel.hpp"
#include "gui/force_pages/both_hands_panel.hpp"
#include "gui/force_pages/live_panel.hpp"
#include "gui/hand_pages/hand_panel.hpp"
#include "gui/look/look.hpp"
#include "gui/session_pages/closing_panel.hpp"
#include "gui/session_pages/prepare_panel.hpp"
#include "gui/session_pages/questions_panel.hpp"
#include "gui/session_pages/run_panel.hpp"
#include "gui/session_pages/score_panel.hpp"

namespace isograsp::gui {

namespace {

/// With large letters what is watched stands below the two columns of what is done.
constexpr int kLargestInARow_percent = 115;
/// The column of steps, at least: beside what is watched of a hand in German and a scroll bar,
/// which comes with the card of a fault, nothing scrolls sideways.
constexpr int kSteps_px = 284;

QVBoxLayout* make_column(int least_px, int most_px) {
  auto* holder = new QWidget;
  holder->setMinimumWidth(scaled(least_px));
  if (most_px > 0) holder->setMaximumWidth(scaled(most_px));
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(12);
  return column;
}

}  // namespace

SessionPage::SessionPage(Clinic& clinic, SessionPresenter& presenter, SettingsFile& settings,
                         Staff& staff, QWidget* parent)
    : QWidget(parent), presenter_(presenter), in_a_row_(scaled(100) <= kLargestInARow_percent) {
  grid_ = new QGridLayout(this);
  const int apart_px = in_a_row_ ? 12 : 8;  // large letters need the room
  grid_->setContentsMargins(8, apart_px, 8, apart_px);
  grid_->setSpacing(apart_px);
  prepare_ = new PreparePanel(presenter, settings, staff);
  watch_ = make_closing(clinic, make_watch(clinic, settings));
  run_ = make_run();
  if (!in_a_row_) watch_->setMinimumHeight(scaled(470));
  arrange();
  connect(prepare_, &PreparePanel::other_patient, this, &SessionPage::other_patient);
  connect(prepare_, &PreparePanel::head_pressed, this, [this] {
    fold(false);
    asked_for_ = true;
  });
  connect(prepare_, &PreparePanel::opened, this,
          [this] { asked_for_ = asked_for_ && prepare_->any_open(); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &SessionPage::refresh);
  refresh();
}

QWidget* SessionPage::make_watch(Clinic& clinic, const SettingsFile& settings) {
  auto* watch = make_column(400, 0);
  watch->addWidget(new LivePanel(presenter_, settings), 3);  // one of the four is shown
  watch->addWidget(new BothHandsPanel(presenter_), 3);
  watch->addWidget(new ArmPanel(presenter_), 5);
  watch->addWidget(new HandPanel(presenter_), 3);
  watch->addWidget(new QuestionsPanel(presenter_));
  watch->addWidget(new ScorePanel(clinic, presenter_), 1);
  return watch->parentWidget();
}

/// What is watched, or the end of it.
QWidget* SessionPage::make_closing(Clinic& clinic, QWidget* watch) {
  auto* either = new QStackedWidget;
  closing_ = new ClosingPanel(clinic, presenter_);
  either->addWidget(watch);
  either->addWidget(closing_);
  const auto show = [this, either] {
    either->setCurrentIndex(presenter_.flow().view().closes ? 1 : 0);
  };
  connect(closing_, &ClosingPanel::shown_or_hidden, this, show);
  connect(closing_, &ClosingPanel::report_wanted, this, &SessionPage::report_wanted);
  connect(closing_, &ClosingPanel::end_wanted, this, &SessionPage::end_wanted);
  connect(closing_, &ClosingPanel::sent, this, &SessionPage::sent);
  show();
  return either;
}

bool SessionPage::printing() const {
  return closing_->printing();
}

QWidget* SessionPage::make_run() {
  auto* run = make_column(in_a_row_ ? 290 : 250, in_a_row_ ? 400 : 0);
  auto* now = new RunPanel(presenter_);
  connect(now, &RunPanel::report_wanted, this, &SessionPage::report_wanted);
  run->addWidget(now, 1);
  run->addWidget(new RatingPanel(presenter_));
  return run->parentWidget();
}

void SessionPage::arrange() {
  for (QWidget* part : {static_cast<QWidget*>(prepare_), watch_, run_}) grid_->removeWidget(part);
  prepare_->setMinimumWidth(folded_ ? 0 : scaled(in_a_row_ ? kSteps_px : 260));
  prepare_->setMaximumWidth(folded_ || !in_a_row_ ? QWIDGETSIZE_MAX : scaled(360));
  const int columns = in_a_row_ ? 3 : 2;
  grid_->addWidget(prepare_, folded_ ? 0 : 1, 0, 1, folded_ ? columns : 1);
  // What is watched takes the place of the folded steps, with large letters what is run does.
  const int first = folded_ ? 0 : 1;
  const int wide = folded_ ? 2 : 1;
  if (in_a_row_) {
    grid_->addWidget(watch_, 1, first, 1, wide);
    grid_->addWidget(run_, 1, 2);
    grid_->setColumnStretch(1, 5);
    grid_->setColumnStretch(2, 2);
  } else {
    grid_->addWidget(run_, 1, first, 1, wide);
    grid_->addWidget(watch_, 2, 0, 1, columns);
    grid_->setColumnStretch(1, 2);
  }
  grid_->setColumnStretch(0, 2);
}

void SessionPage::refresh() {
  const FlowView& view = presenter_.flow().view();
  if (view.may_stop && !in_trial_) asked_for_ = false;  // a trial begins
  in_trial_ = view.may_stop;
  // Nothing moves away under the hands of somebody who types.
  const QWidget* focus = QApplication::focusWidget();
  const bool used =
      !folded_ && focus != nullptr && prepare_->isAncestorOf(focus) && focus->inherits("QLineEdit");
  fold(view.steps_fold && !asked_for_ && !used);
}

void SessionPage::fold(bool folded) {
  if (folded == folded_) return;
  folded_ = folded;
  prepare_->fold(folded);
  arrange();
}

}  // namespace isograsp::gui
