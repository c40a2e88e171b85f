// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/report_pages.hpp"

#include <QPagedPaintDevice>
#include <cassert>
#include <cmath>

#include "reports/findings/report_text.hpp"
#include "reports/paper/pdf_content.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

using namespace pdf;

struct ReportPages::Parts {
  /// A part of a block at its height on the page [points].
  struct Step {
    std::size_t block = 0;
    std::size_t part = 0;
    double y = 0.0;
  };

  Parts(ReportContent of, const Language& language)
      : content(std::move(of)), furniture(furniture_of(content, language)) {
    const Speaker say(language);
    if (content.sections.empty()) blocks.push_back(text_block(qt(say(nothing_yet())), kBody, 0.0));
    add_panels(blocks, panels_above(content, language));
    add_glance(blocks, content, say);
    add_quality(blocks, content, say);
    add_panels(blocks, panels_between(content, language));
    add_sections(blocks, content, say);
    add_panels(blocks, panels_below(content, language));
    lay_out();
  }
  Parts(PageFurniture around, std::vector<Block> of)
      : furniture(std::move(around)), blocks(std::move(of)) {
    lay_out();
  }

  void lay_out() {
    constexpr double kEnd = kPageHeight - kBottom;
    for (const PageRange& range : break_into_pages(blocks, kEnd - kHeaderHeight, kEnd - kTop)) {
      auto& steps = pages.emplace_back();
      double y = pages.size() == 1 ? kHeaderHeight : kTop;
      const auto add = [&](std::size_t block) {
        for (std::size_t part = 0; part < blocks[block].parts.size(); ++part)
          steps.push_back({block, part, y});
        y += blocks[block].height;
      };
      for (std::size_t block = range.first; block < range.last; ++block) {
        if (block != range.first)
          y += blocks[block].gap_above;
        else if (blocks[block].below_head > 0)  // a table goes on under its head
          add(block - blocks[block].below_head);
        add(block);
      }
      all_steps += static_cast<int>(steps.size());
    }
  }

  const ReportContent content;  ///< blocks of a progress report refer to it
  const PageFurniture furniture;
  std::vector<Block> blocks;
  std::vector<std::vector<Step>> pages;
  int all_steps = 0;
};

ReportPages::ReportPages(ReportContent content, const Language& language)
    : parts_(std::make_unique<Parts>(std::move(content), language)) {}
ReportPages::ReportPages(PageFurniture furniture, std::vector<Block> blocks)
    : parts_(std::make_unique<Parts>(std::move(furniture), std::move(blocks))) {}
ReportPages::~ReportPages() = default;

const PageFurniture& ReportPages::furniture() const noexcept {
  return parts_->furniture;
}
int ReportPages::pages() const noexcept {
  return static_cast<int>(parts_->pages.size());
}
std::optional<int> ReportPages::patient_page() const noexcept {
  if (parts_->content.sessions.empty()) return std::nullopt;
  return pages() - 1;
}
int ReportPages::steps(int page) const noexcept {
  return static_cast<int>(parts_->pages[static_cast<std::size_t>(page)].size());
}
int ReportPages::steps() const noexcept {
  return parts_->all_steps;
}

void ReportPages::paint(QCPPainter& painter, int page, int step) const {
  const auto& one = parts_->pages[static_cast<std::size_t>(page)][static_cast<std::size_t>(step)];
  if (step == 0) draw_head(painter, parts_->furniture, page + 1);
  parts_->blocks[one.block].parts[one.part](painter, one.y);
  if (step + 1 == steps(page)) draw_foot(painter, parts_->furniture, page + 1, pages());
}

QSizeF report_page_size() noexcept {
  return {kPageWidth, kPageHeight};
}

PagePrinter::PagePrinter(const ReportPages& pages, QPagedPaintDevice& device, int first_page)
    : pages_(pages), device_(device), page_(first_page), painter_(std::make_unique<QCPPainter>()) {}
PagePrinter::~PagePrinter() = default;

bool PagePrinter::paint_next() {
  assert(!complete());
  if (done_ == 0) {
    if (!painter_->begin(&device_)) return false;
    // A printer has its own resolution.
    const double scale = static_cast<double>(device_.logicalDpiX()) / kResolution;
    if (scale != 1.0) painter_->scale(scale, scale);
  } else if (step_ == 0 && !device_.newPage()) {
    return false;
  }
  pages_.paint(*painter_, page_, step_);
  ++done_;
  if (++step_ == pages_.steps(page_)) {
    step_ = 0;
    if (++page_ == pages_.pages()) return painter_->end();
  }
  return true;
}

PagePicture::PagePicture(const ReportPages& pages, int page, double scale)
    : pages_(pages),
      page_(page),
      image_(static_cast<int>(std::lround(scale * kPageWidth)),
             static_cast<int>(std::lround(scale * kPageHeight)), QImage::Format_RGB32),
      painter_(std::make_unique<QCPPainter>()) {
  image_.fill(Qt::white);
  painter_->begin(&image_);
  painter_->setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing |
                           QPainter::SmoothPixmapTransform);
  painter_->scale(scale / kUnit, scale / kUnit);
}
PagePicture::~PagePicture() = default;

void PagePicture::paint_next() {
  assert(!complete());
  pages_.paint(*painter_, page_, step_++);
  if (complete()) painter_->end();
}

}  // namespace isograsp::reports
