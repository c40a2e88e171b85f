// SPDX-License-Identifier: GPL-3.0-or-later
// What is stored about the patient: one measure at a time as table and trend.
#pragma once

#include <QComboBox>
#include <QTableWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/history.hpp"
#include "gui/look/card.hpp"
#include "gui/look/plot_view.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class HistoryPanel final : public Card {
  Q_OBJECT

 public:
  HistoryPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void fill();
  void show_series(int index);
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  std::vector<HistorySeries> series_;
  storage::RowId newest_trial_ = 0;
  QComboBox* choice_;
  QTableWidget* table_;
  TrendPlot* trend_;
  QLabel* nothing_;  ///< why there is nothing to see
};

}  // namespace isograsp::gui
