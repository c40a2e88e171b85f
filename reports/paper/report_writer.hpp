// SPDX-License-Identifier: GPL-3.0-or-later
// A report while it is written: plots must be painted on the GUI thread, so the work comes in steps
// of some milliseconds, and a window can live between them.
#pragma once

#include <memory>
#include <string>

#include "core/progress.hpp"
#include "core/result.hpp"
#include "reports/findings/report_content.hpp"
#include "reports/findings/wording.hpp"

namespace isograsp::reports {

/// Needs a QApplication (ensure_qt_application()). GUI thread.
class ReportWriter {
 public:
  virtual ~ReportWriter() = default;
  ReportWriter(const ReportWriter&) = delete;
  ReportWriter& operator=(const ReportWriter&) = delete;

  [[nodiscard]] virtual int steps() const noexcept = 0;
  [[nodiscard]] virtual int steps_done() const noexcept = 0;
  [[nodiscard]] bool complete() const noexcept { return steps_done() == steps(); }
  /// Where the work is: "page 3 of 7".
  [[nodiscard]] virtual Text words() const = 0;
  /// @pre !complete()
  virtual void paint_next() = 0;
  /// The whole file; may be written on any thread. @pre complete(), called once
  [[nodiscard]] virtual std::string take() = 0;

 protected:
  ReportWriter() = default;
};

/// In a language, which must outlive the writer; HTML if `path` ends in ".html", PDF otherwise.
/// Lays the report out, writes nothing.
[[nodiscard]] std::unique_ptr<ReportWriter> make_report_writer(ReportContent content,
                                                               const std::string& path,
                                                               const Language& language = kEnglish);

/// All steps, then the whole file or nothing. Errors: failed, if `path` cannot be written or the
/// watcher wants to stop.
[[nodiscard]] Result<void> write_all(ReportWriter& writer, const std::string& path,
                                     const Progress& progress = {});

}  // namespace isograsp::reports
