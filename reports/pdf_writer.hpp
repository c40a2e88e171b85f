// SPDX-License-Identifier: GPL-3.0-or-later
// A progress report as PDF: A4, vector plots, text that can be searched.
#pragma once

#include <string>

#include "core/result.hpp"
#include "reports/report_content.hpp"

namespace isograsp {

/// Writes the whole file or nothing. Errors: failed, if `path` cannot be written. Needs a
/// QApplication (ensure_qt_application()); main thread.
[[nodiscard]] Result<void> write_pdf(const ReportContent& content, const std::string& path);

}  // namespace isograsp
