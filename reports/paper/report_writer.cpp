// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/report_writer.hpp"

#include "core/files.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/pdf_writer.hpp"

namespace isograsp::reports {

std::unique_ptr<ReportWriter> make_report_writer(ReportContent content, const std::string& path,
                                                 const Language& language) {
  if (path.ends_with(".html")) return std::make_unique<HtmlReport>(std::move(content), language);
  return std::make_unique<PdfReport>(std::move(content), language);
}

Result<void> write_all(ReportWriter& writer, const std::string& path, const Progress& progress) {
  while (!writer.complete()) {
    const double fraction = static_cast<double>(writer.steps_done()) / writer.steps();
    if (!tell(progress, fraction, writer.words())) return cancelled();
    writer.paint_next();
  }
  return write_text(path, writer.take());
}

}  // namespace isograsp::reports
