// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/qt_application.hpp"

#include <QApplication>
#include <QDir>
#include <QFile>

#include <unistd.h>

namespace isograsp::reports {

void ensure_qt_application() {
  if (QCoreApplication::instance() != nullptr) return;
  // Pages need no display: one that is named but cannot be reached would end the program.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // Without a login session (a server, a container) Qt would complain on standard error.
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) {
    const QString folder = QDir::temp().filePath(QString("isograsp-%1").arg(getuid()));
    QDir().mkpath(folder);
    QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    qputenv("XDG_RUNTIME_DIR", QFile::encodeName(folder));
  }
  static int argc = 1;
  static char name[] = "isograsp";
  static char* argv[] = {name, nullptr};
  // Never destroyed: at the end of the program some of Qt's own statics are gone before it.
  static auto* const kApplication = new QApplication(argc, argv);
  (void)kApplication;
}

}  // namespace isograsp::reports
