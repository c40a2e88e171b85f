// SPDX-License-Identifier: GPL-3.0-or-later
// A report as PDF: A4, vector plots, text that can be searched.
#pragma once

#include <memory>
#include <string>

#include "reports/paper/page_furniture.hpp"
#include "reports/paper/page_layout.hpp"
#include "reports/paper/report_writer.hpp"

namespace isograsp::reports {

/// Laid out once, then painted text by text, row by row, plot by plot.
class PdfReport final : public ReportWriter {
 public:
  explicit PdfReport(ReportContent content, const Language& language = kEnglish);
  /// Any other report: its blocks hold what they paint.
  PdfReport(PageFurniture furniture, std::vector<Block> blocks);
  ~PdfReport() override;

  [[nodiscard]] int pages() const noexcept;
  [[nodiscard]] int page() const noexcept;  ///< that the next step paints on, from 1
  [[nodiscard]] int steps() const noexcept override;
  [[nodiscard]] int steps_done() const noexcept override;
  [[nodiscard]] Text words() const override;
  void paint_next() override;
  [[nodiscard]] std::string take() override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Writes the whole file or nothing. Errors: failed, if `path` cannot be written or the watcher
/// wants to stop. Needs a QApplication (ensure_qt_application()); main thread.
[[nodiscard]] Result<void> write_pdf(const ReportContent& content, const std::string& path,
                                     const Progress& progress = {},
                                     const Language& language = kEnglish);

}  // namespace isograsp::reports
