// SPDX-License-Identifier: GPL-3.0-or-later
// The box plots of a group report.
#pragma once

#include "reports/paper/plots.hpp"
#include "reports/study/study_report.hpp"

namespace isograsp::reports {

/// Boxes side by side; a dot for each subject, at the same place in every box; thin lines follow
/// the subjects from condition to condition. Size in points.
[[nodiscard]] PlotView study_plot(const StudyPlot& plot, QSizeF size, double unit);

}  // namespace isograsp::reports
