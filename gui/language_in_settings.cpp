// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/application.hpp"
#include "gui/clinic/settings.hpp"

namespace isograsp::gui {

std::string language_in_settings() {
  return SettingsFile(SettingsFile::usual_path()).now().language;
}

}  // namespace isograsp::gui
