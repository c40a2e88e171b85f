// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/session_page.hpp"

#include <QGridLayout>
#include <QVBoxLayout>

#include "gui/arm_pages/arm_panel.hpp"
#include "gui/force_pages/both_hands_panel.hpp"
#include "gui/force_pages/live_panel.hpp"
#include "gui/hand_pages/hand_panel.hpp"
#include "gui/look/look.hpp"
#include "gui/session_pages/prepare_panel.hpp"
#include "gui/session_pages/questions_panel.hpp"
#include "gui/session_pages/run_panel.hpp"
#include "gui/session_pages/score_panel.hpp"

namespace isograsp::gui {

SessionPage::SessionPage(SessionPresenter& presenter, const SettingsFile& settings, Staff& staff,
                         QWidget* parent)
    : QWidget(parent) {
  // With large letters what is watched stands below the two columns of what is done.
  constexpr int kLargestInARow_percent = 115;
  const bool in_a_row = scaled(100) <= kLargestInARow_percent;
  auto* grid = new QGridLayout(this);
  const int apart_px = in_a_row ? 12 : 8;  // large letters need the room
  grid->setContentsMargins(apart_px, apart_px, apart_px, apart_px);
  grid->setSpacing(apart_px);
  const auto make_column = [](int least_px, int most_px) {
    auto* holder = new QWidget;
    holder->setMinimumWidth(scaled(least_px));
    if (most_px > 0) holder->setMaximumWidth(scaled(most_px));
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    return column;
  };
  auto* prepare = new PreparePanel(presenter, staff);
  connect(prepare, &PreparePanel::other_patient, this, &SessionPage::other_patient);
  auto* left = make_column(in_a_row ? 290 : 260, in_a_row ? 360 : 0);
  left->addWidget(prepare);
  auto* watch = make_column(400, 0);
  watch->addWidget(new LivePanel(presenter, settings), 3);  // one of the four is shown
  watch->addWidget(new BothHandsPanel(presenter), 3);
  watch->addWidget(new ArmPanel(presenter), 5);
  watch->addWidget(new HandPanel(presenter), 3);
  watch->addWidget(new QuestionsPanel(presenter));
  watch->addWidget(new ScorePanel(presenter), 2);
  auto* run = make_column(in_a_row ? 290 : 250, in_a_row ? 400 : 0);
  auto* now = new RunPanel(presenter);
  connect(now, &RunPanel::report_wanted, this, &SessionPage::report_wanted);
  run->addWidget(now, 1);
  run->addWidget(new RatingPanel(presenter));
  grid->addWidget(left->parentWidget(), 0, 0);
  grid->addWidget(run->parentWidget(), 0, in_a_row ? 2 : 1);
  if (in_a_row) {
    grid->addWidget(watch->parentWidget(), 0, 1);
    grid->setColumnStretch(1, 5);
    grid->setColumnStretch(2, 2);
  } else {
    watch->parentWidget()->setMinimumHeight(scaled(470));
    grid->addWidget(watch->parentWidget(), 1, 0, 1, 2);
    grid->setColumnStretch(1, 2);
  }
  grid->setColumnStretch(0, 2);
}

}  // namespace isograsp::gui
