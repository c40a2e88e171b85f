// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tracker is connected whose camera will look at the person: on which lawful basis, and the
// press that records one.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <string>
#include <vector>

#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "storage/person/consent.hpp"

namespace isograsp::gui {

class BasisView final : public QWidget {
  Q_OBJECT

 public:
  BasisView(SessionPresenter& presenter, Staff& staff, QWidget* parent = nullptr);

 private:
  void refresh();
  void read();
  void show_recorded(const Result<std::vector<storage::Consent>>& recorded);
  void ask();

  SessionPresenter& presenter_;
  Staff& staff_;
  std::string code_;  ///< whose is shown; empty: nobody's yet
  QLabel* words_;
  QPushButton* record_;
};

}  // namespace isograsp::gui
