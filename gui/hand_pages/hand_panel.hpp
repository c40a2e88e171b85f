// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand while the session runs: how well it is seen, each digit with the pull that would
// let it go, the numbers that decide whether a grasp is helped, and the key that lets the object
// go.
#pragma once

#include <QLabel>
#include <QPushButton>

#include "gui/arm_pages/picture_check_view.hpp"
#include "gui/hand_pages/grasp_view.hpp"
#include "gui/look/card.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/rules/hand_live.hpp"

namespace isograsp::gui {

class HandPanel final : public Card {
  Q_OBJECT

 public:
  explicit HandPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void make_head();
  void refresh();
  void refresh_part();
  void show_no_hand();
  void show_tracker(const OpenSession& open);
  void show_task(const OpenSession& open, const std::optional<GraspLive>& live);

  SessionPresenter& presenter_;
  PictureCheckView* check_;
  QPushButton* let_go_;
  QLabel* camera_;
  QLabel* tracker_;
  QLabel* task_;
  GraspView* grasp_;
  QLabel* gap_;
  int polls_ = 0;
};

}  // namespace isograsp::gui
