// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a session, in the place of what was watched: today against last time, whether it was
// valid, effort and pain, what comes next; what is printed, and the end.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <memory>
#include <optional>
#include <stop_token>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/closing.hpp"
#include "gui/look/card.hpp"
#include "gui/look/print_job.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ClosingPanel final : public Card {
  Q_OBJECT

 public:
  ClosingPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);
  ~ClosingPanel() override;

  [[nodiscard]] bool printing() const noexcept { return printing_->running(); }

 Q_SIGNALS:
  void report_wanted();
  void end_wanted();                          ///< of the session; the next patient comes
  void sent(const QString& code, bool done);  ///< to the printer
  void shown_or_hidden();

 private:
  void make_table();
  void make_buttons();
  void refresh();
  void read();
  void show_closing(const Closing& closing);

  Clinic& clinic_;
  SessionPresenter& presenter_;
  storage::RowId session_ = 0;  ///< whose end is shown; 0: none is
  std::optional<Hand> hand_;    ///< of that session; nothing: both
  std::stop_source reading_;
  std::shared_ptr<const reports::ReportPages> pages_;
  PrintJob* printing_;
  QTableWidget* table_;
  QLabel* valid_;
  QLabel* felt_;
  QLabel* next_;
  QLabel* remark_;  ///< what became of the printing
  QPushButton* print_;
  QPushButton* report_;
  QPushButton* end_;
};

}  // namespace isograsp::gui
