// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_page.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "gui/live_panel.hpp"
#include "gui/prepare_panel.hpp"
#include "gui/run_panel.hpp"
#include "gui/score_panel.hpp"

namespace isograsp {

SessionPage::SessionPage(SessionPresenter& presenter, QWidget* parent) : QWidget(parent) {
  auto* columns = new QHBoxLayout(this);
  columns->setContentsMargins(12, 12, 12, 12);
  columns->setSpacing(12);
  const auto add_column = [&](int stretch, int least_px, int most_px) {
    auto* holder = new QWidget;
    holder->setMinimumWidth(least_px);
    if (most_px > 0) holder->setMaximumWidth(most_px);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    columns->addWidget(holder, stretch);
    return column;
  };
  auto* prepare = new PreparePanel(presenter);
  connect(prepare, &PreparePanel::other_patient, this, &SessionPage::other_patient);
  add_column(2, 270, 360)->addWidget(prepare);
  auto* watch = add_column(5, 400, 0);
  watch->addWidget(new LivePanel(presenter), 3);
  watch->addWidget(new ScorePanel(presenter), 2);
  auto* run = add_column(2, 290, 400);
  run->addWidget(new RunPanel(presenter), 1);
  run->addWidget(new RatingPanel(presenter));
}

}  // namespace isograsp
