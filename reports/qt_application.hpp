// SPDX-License-Identifier: GPL-3.0-or-later
// Reports are painted with Qt, which wants an application object even where there is no display.
#pragma once

namespace isograsp {

/// Makes sure that a QApplication exists until the program ends; without a display (DISPLAY,
/// WAYLAND_DISPLAY) and without QT_QPA_PLATFORM it is one that needs none. Main thread.
void ensure_qt_application();

}  // namespace isograsp
