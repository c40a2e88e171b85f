// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/print_job.hpp"

#include <QPrintDialog>
#include <QPrinter>
#include <algorithm>
#include <utility>

namespace isograsp::gui {

PrintJob::PrintJob(QWidget* window) : QObject(window), window_(window) {
  between_events_.setInterval(0);
  connect(&between_events_, &QTimer::timeout, this, &PrintJob::print_next);
}

PrintJob::~PrintJob() = default;

void PrintJob::ask(std::shared_ptr<const reports::ReportPages> pages, const QString& name,
                   int first_page) {
  if (running() || pages == nullptr) return;
  printer_ = std::make_unique<QPrinter>(QPrinter::HighResolution);
  printer_->setPageSize(QPageSize(QPageSize::A4));
  printer_->setFullPage(true);
  printer_->setDocName(name);
  auto* dialog = new QPrintDialog(printer_.get(), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, qOverload<>(&QDialog::accepted), this,
          [this, pages = std::move(pages), first_page] {
            pages_ = pages;
            first_page_ = first_page;
            printing_ = std::make_unique<reports::PagePrinter>(*pages_, *printer_, first_page);
            between_events_.start();
          });
  dialog->open();
}

void PrintJob::hold(bool wait) {
  held_ = wait;
}

void PrintJob::print_next() {
  if (held_) return;
  if (!printing_->paint_next()) return end(false);
  const int pages = pages_->pages() - first_page_;
  Q_EMIT progress(std::min(printing_->page() - first_page_ + 1, pages), pages);
  if (printing_->complete()) end(true);
}

void PrintJob::end(bool done) {
  const QString name = printer_->docName();
  between_events_.stop();
  printing_.reset();
  printer_.reset();
  pages_.reset();
  Q_EMIT ended(name, done);
}

}  // namespace isograsp::gui
