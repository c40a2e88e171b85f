// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/application.hpp"

#include <QApplication>
#include <cstdlib>
#include <utility>

#include <xcb/xcb.h>

#include "gui/background.hpp"
#include "gui/look.hpp"
#include "gui/texts.hpp"
#include "gui/windows.hpp"

namespace isograsp {

namespace {
std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Qt ends the program where it cannot reach the X server: so this asks before Qt does.
bool reaches_x_server() {
  xcb_connection_t* connection = xcb_connect(nullptr, nullptr);  // the one that DISPLAY names
  const bool reached = xcb_connection_has_error(connection) == 0;
  xcb_disconnect(connection);
  return reached;
}

Error no_display(const std::string& what) {
  return {Error::Code::failed,
          what,
          "start it from a desktop, or run a session without windows: isograsp run",
          "",
          0,
          ""};
}
}  // namespace

Result<void> run_application(const ApplicationConfig& config) {
  const auto display = variable("DISPLAY");
  const auto platform = variable("QT_QPA_PLATFORM");
  const bool wayland = !variable("WAYLAND_DISPLAY").empty();
  if (display.empty() && !wayland && platform.empty())
    return no_display("there is no display for the windows");
  if (platform == "xcb" || (platform.empty() && !wayland))
    if (!reaches_x_server())
      return no_display("the display \"" + display + "\" for the windows cannot be reached");
  int argc = 1;
  char name[] = "isograsp";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("IsoGrasp"));
  QApplication::setApplicationVersion(QString::fromStdString(config.software_version));
  std::string database = config.database;
  std::string device = config.device_uri;
  bool again = true;
  while (std::exchange(again, false)) {
    Windows windows({database, device, config.library, config.software_version,
                     config.operator_name, config.realtime,
                     SettingsFile::usual_path().toStdString()});
    Background maker;
    windows.open_demonstration = [&] {
      if (!config.make_demonstration) return;
      maker.run([make = config.make_demonstration] { return make(); },
                [&](const Result<std::string>& made) {
                  if (!made) return windows.therapist().demonstration_failed(shown(made.error()));
                  database = *made;
                  again = true;
                  windows.therapist().close();
                });
    };
    windows.show();
    QApplication::exec();
  }
  return {};
}

}  // namespace isograsp
