// SPDX-License-Identifier: GPL-3.0-or-later
// A progress report as one HTML file: the accessible form. Every plot (inline SVG) has its numbers
// in a table beside it; headings, language and descriptions are set; nothing is fetched.
#pragma once

#include <string>

#include "core/result.hpp"
#include "reports/report_content.hpp"

namespace isograsp {

/// Writes the whole file or nothing. Errors: failed, if `path` cannot be written. Needs a
/// QApplication (ensure_qt_application()); main thread.
[[nodiscard]] Result<void> write_html(const ReportContent& content, const std::string& path);

}  // namespace isograsp
