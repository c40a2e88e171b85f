// SPDX-License-Identifier: GPL-3.0-or-later
// What stands for the windows in a program that was built with ISOGRASP_WINDOWS=OFF.
#include "gui/application.hpp"

namespace isograsp::gui {

std::string language_in_settings() {
  return "";  // chosen in the windows only
}

Result<void> run_application(const ApplicationConfig& /*config*/) {
  return failed(
      "this program was built without its windows"_text,
      "build it with -DISOGRASP_WINDOWS=ON, or run a session without them: isograsp run"_text);
}

}  // namespace isograsp::gui
