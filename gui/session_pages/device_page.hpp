// SPDX-License-Identifier: GPL-3.0-or-later
// The connected device: what it is, the guided check of its supports, what its sensors counted, and
// the faults of this session.
#pragma once

#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "gui/look/card.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/rules/guided_check.hpp"
#include "gui/session_pages/state_light.hpp"
#include "gui/session_pages/support_picture.hpp"

namespace isograsp::gui {

class DevicePage final : public QWidget {
  Q_OBJECT

 public:
  explicit DevicePage(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  [[nodiscard]] QWidget* make_state();
  [[nodiscard]] QWidget* make_check();
  [[nodiscard]] QWidget* make_sensors();
  [[nodiscard]] QWidget* make_faults();
  void toggle_check();
  /// The platform that is checked, of two.
  [[nodiscard]] std::optional<Hand> checked_side() const;
  void look();
  void refresh();
  void refresh_check();
  void refresh_sensors();

  SessionPresenter& presenter_;
  GuidedCheck check_;
  int polls_ = 0;
  StateLight* light_;
  QLabel* words_;
  QLabel* details_;
  QLabel* instruction_;
  SupportPicture* picture_;
  ChoiceBox* side_;  ///< which of two platforms is checked
  QPushButton* begin_;
  QListWidget* results_;
  QTableWidget* sensors_;
  QListWidget* faults_;
  QLabel* no_faults_;
  Card* state_card_;
  QWidget* check_card_;
  Card* counted_card_;  ///< its title says whose counters these are
  QLabel* cameras_;     ///< in place of the sensors
};

}  // namespace isograsp::gui
