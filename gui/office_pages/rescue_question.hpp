// SPDX-License-Identifier: GPL-3.0-or-later
// At start: sessions whose database was taken away while they were recorded
// (storage/care/emergency.hpp).
#pragma once

#include <string>

namespace isograsp::gui {

/// Asks whether to take them in, and says what went wrong; nothing is asked if there are none, and
/// without a yes they stay. A protected database needs a login: what to do is said. GUI thread;
/// nobody else may work with the file.
void ask_about_emergency_files(const std::string& database);

}  // namespace isograsp::gui
