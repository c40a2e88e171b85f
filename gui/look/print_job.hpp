// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of a report on their way to a printer: asks which, then paints them in steps between the
// window's other events. One at a time. GUI thread.
#pragma once

#include <QString>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "reports/paper/report_pages.hpp"

class QPrinter;

namespace isograsp::gui {

class PrintJob final : public QObject {
  Q_OBJECT

 public:
  /// The question stands above `window`, which owns the job.
  explicit PrintJob(QWidget* window);
  ~PrintJob() override;

  /// From this page on (from 0). Ignored while others are printed.
  void ask(std::shared_ptr<const reports::ReportPages> pages, const QString& name,
           int first_page = 0);
  void hold(bool wait);  ///< a trial needs its even picture
  [[nodiscard]] bool running() const noexcept { return printing_ != nullptr; }

 Q_SIGNALS:
  void progress(int page, int pages);          ///< of what is printed, from 1
  void ended(const QString& name, bool done);  ///< `done`: the printer has taken all of it

 private:
  void print_next();
  void end(bool done);

  QWidget* window_;
  bool held_ = false;
  int first_page_ = 0;
  std::shared_ptr<const reports::ReportPages> pages_;
  std::unique_ptr<QPrinter> printer_;
  std::unique_ptr<reports::PagePrinter> printing_;
  QTimer between_events_;
};

}  // namespace isograsp::gui
