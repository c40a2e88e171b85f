// SPDX-License-Identifier: GPL-3.0-or-later
// A live arm: how near the object is to its target beside what counts as there, how far each link
// has turned, the arm from three sides, and what the cameras see of it.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <array>

#include "gui/arm_pages/arm_views.hpp"
#include "gui/arm_pages/marker_table.hpp"
#include "gui/arm_pages/picture_check_view.hpp"
#include "gui/look/card.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ArmPanel final : public Card {
  Q_OBJECT

 public:
  explicit ArmPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void make_check();
  void make_task();
  void make_links();
  void refresh();
  void refresh_task(const OpenSession& open);
  void refresh_links(const OpenSession& open);
  void refresh_cameras(const OpenSession& open);
  void show_nothing();

  SessionPresenter& presenter_;
  PictureCheckView* check_;
  QLabel* reached_;
  QLabel* error_;
  QLabel* practice_;
  struct LinkRow {
    QLabel* angle;
    QProgressBar* share;
  };
  std::array<LinkRow, kArmLinkCount> links_{};
  ArmViews* views_;
  MarkerTable* markers_;
  QLabel* remark_;
  QLabel* health_;
  bool shows_ = false;  ///< rows of the connected rig
  int polls_ = 0;
};

}  // namespace isograsp::gui
