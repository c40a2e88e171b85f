// SPDX-License-Identifier: GPL-3.0-or-later
// Reports are painted with Qt, which wants an application object even though no window is shown.
#pragma once

namespace isograsp::reports {

/// Makes sure that a QApplication exists until the program ends; unless QT_QPA_PLATFORM says
/// otherwise it is one that needs no display. Main thread.
void ensure_qt_application();

}  // namespace isograsp::reports
