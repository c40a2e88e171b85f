// SPDX-License-Identifier: GPL-3.0-or-later
// The progress report of the chosen patient: which sessions, which format, the very pages that will
// be written, saved or printed from here.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <memory>
#include <stop_token>
#include <string>

#include "gui/clinic/clinic.hpp"
#include "gui/look/card.hpp"
#include "gui/look/page_view.hpp"
#include "gui/look/print_job.hpp"
#include "gui/look/work_progress.hpp"
#include "gui/office_pages/session_span.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ReportPanel final : public QWidget {
  Q_OBJECT

 public:
  ReportPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);
  ~ReportPanel() override;

  [[nodiscard]] bool printing() const noexcept { return printing_->running(); }
  void forget();  ///< what is shown; it is read again when it is shown again

 protected:
  void showEvent(QShowEvent* event) override;

 Q_SIGNALS:
  void sent(const QString& code, bool done);  ///< to the printer; `done`: all of the report
  void printed();                             ///< printing has ended, with or without success

 private:
  [[nodiscard]] QWidget* make_choices();
  [[nodiscard]] QWidget* make_preview();
  void connect_report();
  void look_again();
  void load_sessions();
  void load_pages();
  void show_pages(Result<reports::ReportContent> content);
  void ask_where();
  void ask_printer();
  void refresh();
  [[nodiscard]] reports::ReportScope scope() const { return {span_->first(), span_->last()}; }

  Clinic& clinic_;
  SessionPresenter& presenter_;
  std::string code_;  ///< whose pages are shown or being read
  bool stale_ = true;
  bool reading_ = false;
  std::stop_source reading_stop_;
  std::shared_ptr<const reports::ReportPages> pages_;
  PrintJob* printing_;
  QString at_;  ///< where the report is: "page 3 of 7"

  QLabel* patient_;
  SessionSpan* span_;
  QComboBox* format_;
  QLabel* format_remark_;
  QPushButton* report_;
  QPushButton* print_;
  WorkProgress* writing_;
  QLabel* remark_;   ///< what became of the report
  QLabel* nothing_;  ///< why there is nothing to see
  QLabel* where_;    ///< "Page 2 of 5"
  QPushButton* smaller_;
  QPushButton* larger_;
  QPushButton* fit_;
  PageView* view_;
};

}  // namespace isograsp::gui
