// SPDX-License-Identifier: GPL-3.0-or-later
// How every plot of the windows looks; for the sources of plots only.
#pragma once

class QCustomPlot;
class QWidget;

namespace isograsp::gui {

/// A plot that fills `parent`, takes no focus and lets the mouse through to it.
[[nodiscard]] QCustomPlot* make_plot(QWidget& parent);

}  // namespace isograsp::gui
