// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands while the session runs, each on its platform: fingers, grip forces as curves with what
// is asked of them, the share of the affected hand, the health of each platform.
#pragma once

#include <QLabel>
#include <array>

#include "gui/force_pages/live_panel.hpp"
#include "gui/look/card.hpp"
#include "gui/look/hands_plot.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class BothHandsPanel final : public Card {
  Q_OBJECT

 public:
  explicit BothHandsPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  struct Side {
    QLabel* grip = nullptr;
    std::array<FingerBar*, kFingerCount> fingers{};
    QLabel* health = nullptr;
  };
  void refresh();
  void show_words(const session::TwoPlatformsSnapshot* now);

  SessionPresenter& presenter_;
  OfHands<Side> of_;
  QLabel* share_;
  HandsPlot* plot_;
  int polls_ = 0;
};

}  // namespace isograsp::gui
