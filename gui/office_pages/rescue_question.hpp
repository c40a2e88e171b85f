// SPDX-License-Identifier: GPL-3.0-or-later
// At start: sessions whose database was taken away while they were recorded
// (storage/care/emergency.hpp).
#pragma once

#include <string>

namespace isograsp::gui {

/// Asks whether to merge these sessions into the database, and says what went wrong. Asks nothing
/// if there are none; without a yes they stay where they are. A protected database needs a login
/// first: then it says what to do. GUI thread; nobody else may work with the file.
void ask_about_emergency_files(const std::string& database);

}  // namespace isograsp::gui
