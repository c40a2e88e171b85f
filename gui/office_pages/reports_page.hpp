// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves the program: the progress report with its preview, the research export; and the
// stored values as a table.
#pragma once

#include <QTabWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ReportPanel;

class ReportsPage final : public QWidget {
  Q_OBJECT

 public:
  ReportsPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

  [[nodiscard]] bool printing() const;
  void forget();  ///< what is shown; it is read again when it is shown again

 Q_SIGNALS:
  void sent(const QString& code, bool done);  ///< to the printer; `done`: all of the report
  void printed();                             ///< nothing is printed any more

 private:
  ReportPanel* report_;
};

}  // namespace isograsp::gui
