// SPDX-License-Identifier: GPL-3.0-or-later
// The trend of one measure in words: slope per week, or success and ranks of a time that does not
// always come.
#pragma once

#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"

namespace isograsp::reports {

/// "+0.31 N per week (0.12 to 0.48)"; "reached 12 of 20, ranks −0.42 (−0.70 to −0.10)"; empty: too
/// few days. Intervals of 95 %.
[[nodiscard]] Text trend_words(const MeasureSeries& series,
                               const std::vector<ReportSession>& sessions);

}  // namespace isograsp::reports
