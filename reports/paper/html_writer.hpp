// SPDX-License-Identifier: GPL-3.0-or-later
// A progress report as one HTML file: the accessible form. Every plot (inline SVG) has its numbers
// in a table beside it; headings, language and descriptions are set; nothing is fetched.
#pragma once

#include <memory>
#include <string>

#include "reports/findings/wording.hpp"
#include "reports/paper/report_writer.hpp"

namespace isograsp::reports {

/// One step for the tables at the beginning and one for each task.
class HtmlReport final : public ReportWriter {
 public:
  explicit HtmlReport(ReportContent content, const Language& language = kEnglish);
  ~HtmlReport() override;

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
[[nodiscard]] Result<void> write_html(const ReportContent& content, const std::string& path,
                                      const Progress& progress = {},
                                      const Language& language = kEnglish);

}  // namespace isograsp::reports
