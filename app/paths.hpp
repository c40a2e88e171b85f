// SPDX-License-Identifier: GPL-3.0-or-later
// Where shipped content and the default database are (docs/file_formats.md).
#pragma once

#include <string>

namespace isograsp::app {

/// $ISOGRASP_LIBRARY, else the source tree of this build, else the installed folder.
[[nodiscard]] std::string library_folder();
/// $XDG_DATA_HOME/isograsp/clinic.db, else ~/.local/share/isograsp/clinic.db; makes the folder.
[[nodiscard]] std::string default_database();

}  // namespace isograsp::app
