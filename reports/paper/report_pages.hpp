// SPDX-License-Identifier: GPL-3.0-or-later
// A report laid out on A4 pages, ready to be painted on anything: the PDF file, a printer,
// pictures for a preview. What is seen there is what is written. Needs a QApplication; GUI thread.
#pragma once

#include <QImage>
#include <memory>
#include <optional>

#include "reports/paper/page_furniture.hpp"
#include "reports/paper/page_layout.hpp"

class QCPPainter;
class QPagedPaintDevice;

namespace isograsp::reports {

class ReportPages {
 public:
  /// The language must outlive them.
  explicit ReportPages(ReportContent content, const Language& language = kEnglish);
  /// Any other report: its blocks hold what they paint.
  ReportPages(PageFurniture furniture, std::vector<Block> blocks);
  ~ReportPages();
  ReportPages(const ReportPages&) = delete;
  ReportPages& operator=(const ReportPages&) = delete;

  [[nodiscard]] const PageFurniture& furniture() const noexcept;
  [[nodiscard]] int pages() const noexcept;
  /// The page for the patient, the last one of a progress report; nothing: there is none.
  [[nodiscard]] std::optional<int> patient_page() const noexcept;
  /// Steps of some milliseconds in which a page (from 0) is painted; at least one.
  [[nodiscard]] int steps(int page) const noexcept;
  [[nodiscard]] int steps() const noexcept;  ///< of all pages
  /// Paints one of them; the painter's unit is 1/1200 inch.
  void paint(QCPPainter& painter, int page, int step) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Size of a page [points].
[[nodiscard]] QSizeF report_page_size() noexcept;

/// All pages from one on (from 0) on a paged device, step by step.
class PagePrinter {
 public:
  /// Both must outlive it.
  PagePrinter(const ReportPages& pages, QPagedPaintDevice& device, int first_page = 0);
  ~PagePrinter();

  [[nodiscard]] int page() const noexcept { return page_; }  ///< that comes next, from 0
  [[nodiscard]] int steps_done() const noexcept { return done_; }
  [[nodiscard]] bool complete() const noexcept { return page_ == pages_.pages(); }
  /// False: the device takes nothing, a printer without paper for instance. @pre !complete()
  [[nodiscard]] bool paint_next();

 private:
  const ReportPages& pages_;
  QPagedPaintDevice& device_;
  int page_;
  int step_ = 0;
  int done_ = 0;
  std::unique_ptr<QCPPainter> painter_;
};

/// One page as a picture, step by step.
class PagePicture {
 public:
  /// `pages` must outlive it. `scale`: pixels per point.
  PagePicture(const ReportPages& pages, int page, double scale);
  ~PagePicture();

  [[nodiscard]] bool complete() const noexcept { return step_ == pages_.steps(page_); }
  /// @pre !complete()
  void paint_next();
  /// @pre complete()
  [[nodiscard]] const QImage& image() const noexcept { return image_; }

 private:
  const ReportPages& pages_;
  int page_;
  int step_ = 0;
  QImage image_;
  std::unique_ptr<QCPPainter> painter_;
};

}  // namespace isograsp::reports
