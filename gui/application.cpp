// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/application.hpp"

#include <QApplication>
#include <QTimer>
#include <cstdlib>
#include <utility>

#include <xcb/xcb.h>

#include "gui/clinic/background.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/file_in_use.hpp"
#include "gui/look/look.hpp"
#include "gui/office_pages/rescue_question.hpp"
#include "gui/windows.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {
std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Tries to reach the X server before Qt does, because Qt would end the program if it cannot.
bool reaches_x_server() {
  xcb_connection_t* connection = xcb_connect(nullptr, nullptr);  // the one that DISPLAY names
  const bool reached = xcb_connection_has_error(connection) == 0;
  xcb_disconnect(connection);
  return reached;
}

Error no_display(Text what) {
  return failed(std::move(what),
                "start it from a desktop, or run a session without windows: isograsp run"_text);
}

bool is_to_end(const ApplicationConfig& config) {
  return config.stop != nullptr && *config.stop;
}

/// Closes the windows as a therapist does, also below an open dialog; true once the session is
/// written to its end.
bool has_closed(Windows& windows) {
  windows.therapist().close();
  return !windows.presenter().state().busy();
}

}  // namespace

Result<void> run_application(const ApplicationConfig& config) {
  const auto display = variable("DISPLAY");
  const auto platform = variable("QT_QPA_PLATFORM");
  const bool wayland = !variable("WAYLAND_DISPLAY").empty();
  if (display.empty() && !wayland && platform.empty())
    return no_display("there is no display for the windows"_text);
  if (platform == "xcb" || (platform.empty() && !wayland))
    if (!reaches_x_server())
      return no_display("the display \"%1\" for the windows cannot be reached"_text(display));
  int argc = 1;
  char name[] = "isograsp";
  char* argv[] = {name, nullptr};
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("IsoGrasp"));
  QApplication::setApplicationVersion(QString::fromStdString(config.software_version));
  std::string database = config.database;
  std::string device = config.device_uri;
  Windows* open = nullptr;
  QTimer stopping;
  QObject::connect(&stopping, &QTimer::timeout, [&] {
    if (is_to_end(config) && (open == nullptr || has_closed(*open))) QApplication::quit();
  });
  constexpr int kLook_ms = 200;
  stopping.start(kLook_ms);
  bool again = true;
  while (std::exchange(again, false)) {
    const auto settings_path = SettingsFile::usual_path();
    {
      const SettingsFile settings(settings_path);  // of the looks of questions before the windows
      speak(settings.now().language);
      dress(application, settings.now().font_percent);
    }
    const auto file = file_to_open(database);
    if (!file || is_to_end(config)) break;
    if (!file->look_only) ask_about_emergency_files(file->database);
    if (is_to_end(config)) break;
    Windows windows({file->database, device, config.library, config.software_version,
                     config.operator_name, config.realtime, settings_path.toStdString(),
                     file->look_only});
    Background maker;
    windows.open_demonstration = [&] {
      if (!config.make_demonstration) return;
      maker.run([make = config.make_demonstration] { return make(); },
                [&](const Result<std::string>& made) {
                  if (!made)
                    return windows.therapist().demonstration_failed(translated(made.error()));
                  database = *made;
                  again = true;
                  windows.therapist().close();
                });
    };
    windows.show();
    open = &windows;
    QApplication::exec();
    open = nullptr;
    // Nobody may have looked at the screen.
    if (const auto& lost = windows.presenter().state().connection.lost; lost && is_to_end(config))
      return *lost;
  }
  return {};
}

}  // namespace isograsp::gui
