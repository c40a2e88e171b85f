// SPDX-License-Identifier: GPL-3.0-or-later
// A tracked hand while the session runs: how well it is seen, each digit with the pull that would
// let it go, the numbers that decide whether a grasp is helped, and the key that lets the object
// go.
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <array>

#include "gui/hand_rules/hand_live.hpp"
#include "gui/look/card.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class HandPanel final : public Card {
  Q_OBJECT

 public:
  explicit HandPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  struct DigitRow {
    QLabel* state;
    QProgressBar* pull;
    QLabel* pull_words;
  };
  struct CriterionRow {
    QLabel* value;
    QLabel* limit;
    QLabel* verdict;
  };
  void make_head();
  void make_digits();
  void make_criteria();
  void refresh();
  void refresh_part();
  void show_no_hand();
  void show_tracker(const OpenSession& open);
  void show_task(const OpenSession& open, const std::optional<GraspLive>& live);
  void show_digits(const std::optional<GraspLive>& live);
  void show_criteria(const std::optional<GraspLive>& live);

  SessionPresenter& presenter_;
  QPushButton* let_go_;
  QLabel* camera_;
  QLabel* tracker_;
  QLabel* task_;
  std::array<DigitRow, kDigitCount> digits_{};
  std::array<CriterionRow, 3> criteria_{};
  QLabel* grasp_;
  QLabel* gap_;
  int polls_ = 0;
};

}  // namespace isograsp::gui
