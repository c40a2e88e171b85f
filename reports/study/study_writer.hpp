// SPDX-License-Identifier: GPL-3.0-or-later
// A group report as one HTML file or as PDF, of the same blocks.
#pragma once

#include <string>

#include "reports/study/study_report.hpp"

namespace isograsp::reports {

/// Both need a QApplication (ensure_qt_application()); main thread.
[[nodiscard]] std::string study_html(const StudyReport& report);
[[nodiscard]] std::string study_pdf(const StudyReport& report);
/// One of its plots as a picture (PNG), 150 mm wide at 300 dots an inch.
[[nodiscard]] std::string study_png(const StudyPlot& plot);

}  // namespace isograsp::reports
