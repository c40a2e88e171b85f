// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/application.hpp"

#include <QApplication>
#include <cstdlib>

#include "gui/look.hpp"
#include "gui/windows.hpp"

namespace isograsp {

namespace {
bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}
}  // namespace

Result<void> run_application(const ApplicationConfig& config) {
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") && !is_set("QT_QPA_PLATFORM"))
    return Error{Error::Code::failed,
                 "there is no display for the windows",
                 "start it from a desktop, or run a session without windows: isograsp run",
                 "",
                 0,
                 ""};
  int argc = 1;
  char name[] = "isograsp";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("IsoGrasp"));
  QApplication::setApplicationVersion(QString::fromStdString(config.software_version));
  dress(application);
  Windows windows({config.database, config.device_uri, config.library, config.software_version});
  windows.show();
  QApplication::exec();
  return {};
}

}  // namespace isograsp
