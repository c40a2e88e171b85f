// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/pdf_writer.hpp"

#include <QBuffer>
#include <QPdfWriter>
#include <cassert>
#include <optional>

#include <qcustomplot.h>

#include "reports/pdf_content.hpp"
#include "reports/report_text.hpp"

namespace isograsp {

using namespace pdf;

struct PdfReport::Parts {
  explicit Parts(ReportContent of) : content(std::move(of)) {
    if (content.sections.empty()) blocks.push_back(text_block(text_of(nothing_yet()), kBody, 0.0));
    add_glance(blocks, content);
    add_quality(blocks, content);
    add_sections(blocks, content);
    constexpr double kEnd = kPageHeight - kBottom;
    pages = break_into_pages(blocks, kEnd - kHeaderHeight, kEnd - kTop);
    for (const Block& one : blocks) steps += static_cast<int>(one.parts.size());

    file.open(QIODevice::WriteOnly);
    writer.emplace(&file);
    writer->setResolution(kResolution);
    writer->setPageSize(QPageSize(QPageSize::A4));
    writer->setPageMargins(QMarginsF(0, 0, 0, 0));
    writer->setTitle("Progress report " + text_of(content.code));
    writer->setCreator("IsoGrasp " + text_of(content.software_version));
  }

  void begin_page() {
    if (page == 0)
      painter.begin(&*writer);
    else
      writer->newPage();
    draw_head(painter, content, static_cast<int>(page) + 1);
    y = page == 0 ? kHeaderHeight : kTop;
  }

  void end_page() {
    draw_foot(painter, content, static_cast<int>(page) + 1, static_cast<int>(pages.size()));
    if (++page == pages.size()) painter.end();
  }

  const ReportContent content;
  std::vector<Block> blocks;
  std::vector<PageRange> pages;
  int steps = 0;
  int steps_done = 0;
  // The next part to paint.
  std::size_t page = 0;
  std::size_t block = 0;
  std::size_t part = 0;
  double y = 0.0;  ///< of its block [points]
  QBuffer file;
  std::optional<QPdfWriter> writer;
  QCPPainter painter;  ///< goes before the writer
};

PdfReport::PdfReport(ReportContent content) : parts_(std::make_unique<Parts>(std::move(content))) {}
PdfReport::~PdfReport() = default;

int PdfReport::pages() const noexcept {
  return static_cast<int>(parts_->pages.size());
}
int PdfReport::page() const noexcept {
  return std::min(static_cast<int>(parts_->page) + 1, pages());
}
int PdfReport::steps() const noexcept {
  return parts_->steps;
}
int PdfReport::steps_done() const noexcept {
  return parts_->steps_done;
}
std::string PdfReport::words() const {
  return "page " + std::to_string(page()) + " of " + std::to_string(pages());
}

void PdfReport::paint_next() {
  assert(!complete());
  Parts& p = *parts_;
  const PageRange range = p.pages[p.page];
  const Block& block = p.blocks[p.block];
  if (p.part == 0) {
    if (p.block == range.first)
      p.begin_page();
    else
      p.y += block.gap_above;
  }
  block.parts[p.part](p.painter, p.y);
  ++p.steps_done;
  if (++p.part < block.parts.size()) return;
  p.part = 0;
  p.y += block.height;
  if (++p.block == range.last) p.end_page();
}

std::string PdfReport::take() {
  assert(complete());
  return parts_->file.data().toStdString();
}

Result<void> write_pdf(const ReportContent& content, const std::string& path,
                       const Progress& progress) {
  PdfReport report(content);
  return write_all(report, path, progress);
}

}  // namespace isograsp
