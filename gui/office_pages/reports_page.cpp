// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/reports_page.hpp"

#include <QTabBar>
#include <QVBoxLayout>

#include "gui/look/look.hpp"
#include "gui/office_pages/export_panel.hpp"
#include "gui/office_pages/report_panel.hpp"
#include "gui/record_pages/history_panel.hpp"

namespace isograsp::gui {

ReportsPage::ReportsPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent) {
  auto* tabs = new QTabWidget;
  tabs->setObjectName("report_tabs");
  tabs->setDocumentMode(true);
  const auto add = [&](QWidget* panel, const QString& title) {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(12, 10, 12, 12);
    column->addWidget(panel);
    tabs->addTab(page, title);
  };
  report_ = new ReportPanel(clinic, presenter);
  add(report_, tr("Report"));
  connect(report_, &ReportPanel::sent, this, &ReportsPage::sent);
  connect(report_, &ReportPanel::printed, this, &ReportsPage::printed);
  add(new ExportPanel(clinic, presenter), tr("Export"));
  add(new HistoryPanel(clinic, presenter), tr("Values"));
  for (QWidget* widget : {static_cast<QWidget*>(tabs), static_cast<QWidget*>(tabs->tabBar())})
    describe(*widget, tr("Report, export or values"),
             tr("What is written for people, for research, or looked at (Tab, arrow keys)"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs);
}

void ReportsPage::forget() {
  report_->forget();
}

bool ReportsPage::printing() const {
  return report_->printing();
}

}  // namespace isograsp::gui
