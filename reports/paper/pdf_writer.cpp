// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/pdf_writer.hpp"

#include <QBuffer>
#include <QPdfWriter>
#include <algorithm>
#include <cassert>
#include <optional>

#include "reports/paper/pdf_page.hpp"
#include "reports/paper/report_pages.hpp"

namespace isograsp::reports {

using namespace pdf;

struct PdfReport::Parts {
  template <class... Content>
  explicit Parts(Content&&... content) : pages(std::forward<Content>(content)...) {
    file.open(QIODevice::WriteOnly);
    writer.emplace(&file);
    writer->setResolution(kResolution);
    writer->setPageSize(QPageSize(QPageSize::A4));
    writer->setPageMargins(QMarginsF(0, 0, 0, 0));
    writer->setTitle(qt(pages.furniture().kind + " " + pages.furniture().title));
    writer->setCreator("IsoGrasp " ISOGRASP_VERSION);
    printer.emplace(pages, *writer);
  }

  const ReportPages pages;
  QBuffer file;
  std::optional<QPdfWriter> writer;
  std::optional<PagePrinter> printer;  ///< goes before the writer
};

PdfReport::PdfReport(ReportContent content, const Language& language)
    : parts_(std::make_unique<Parts>(std::move(content), language)) {}
PdfReport::PdfReport(PageFurniture furniture, std::vector<Block> blocks)
    : parts_(std::make_unique<Parts>(std::move(furniture), std::move(blocks))) {}
PdfReport::~PdfReport() = default;

int PdfReport::pages() const noexcept {
  return parts_->pages.pages();
}
int PdfReport::page() const noexcept {
  return std::min(parts_->printer->page() + 1, pages());
}
int PdfReport::steps() const noexcept {
  return parts_->pages.steps();
}
int PdfReport::steps_done() const noexcept {
  return parts_->printer->steps_done();
}
Text PdfReport::words() const {
  return "page %1 of %2"_text(page(), pages());
}

void PdfReport::paint_next() {
  assert(!complete());
  [[maybe_unused]] const bool painted = parts_->printer->paint_next();
  assert(painted);  // writing into memory does not fail
}

std::string PdfReport::take() {
  assert(complete());
  return parts_->file.data().toStdString();
}

Result<void> write_pdf(const ReportContent& content, const std::string& path,
                       const Progress& progress, const Language& language) {
  PdfReport report(content, language);
  return write_all(report, path, progress);
}

}  // namespace isograsp::reports
