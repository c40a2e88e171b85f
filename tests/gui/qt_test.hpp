// SPDX-License-Identifier: GPL-3.0-or-later
// Tests with Qt: one application, and every warning that Qt logs fails the running test.
#pragma once

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QTest>
#include <QWidget>
#include <functional>

#include <gtest/gtest.h>

#include "gui/look/look.hpp"

namespace isograsp::test {}  // namespace isograsp::test

namespace isograsp::gui::test {

using namespace isograsp::test;

inline void fail_on_warning(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtDebugMsg || type == QtInfoMsg) return;
  // A remark on the test platform, of every dialog.
  if (text.contains("propagateSizeHints")) return;
  // A remark on the machine: nobody is logged in.
  if (text.contains("XDG_RUNTIME_DIR")) return;
  // So is this one: without a window manager a new window may not be there yet when it is to get
  // the focus.
  if (text.contains("SetInputFocus")) return;
  ADD_FAILURE() << "Qt: " << text.toStdString();
}

/// The one application of this process, on the platform of the environment or else offscreen.
inline QApplication& application() {
  static QApplication* const kApplication = [] {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && qEnvironmentVariableIsEmpty("DISPLAY"))
      qputenv("QT_QPA_PLATFORM", "offscreen");
    static int argc = 1;
    static char name[] = "tests_gui";
    static char* argv[] = {name, nullptr};
    auto* made = new QApplication(argc, argv);
    qInstallMessageHandler(fail_on_warning);
    dress(*made);
    return made;
  }();
  return *kApplication;
}

class QtTest : public ::testing::Test {
 protected:
  QtTest() { application(); }
};

/// Lets events happen until `reached` or the time is over; true if reached. A limit for broken
/// programs only: no test depends on how fast the machine is.
inline bool wait_until(const std::function<bool()>& reached, int limit_s = 60) {
  QElapsedTimer timer;
  timer.start();
  while (!reached()) {
    if (timer.elapsed() > 1000LL * limit_s) return false;
    QTest::qWait(10);
  }
  return true;
}

/// The widget of that name; without one nothing can go on.
template <class Widget>
[[nodiscard]] Widget& widget_called(const char* name, const QWidget& in) {
  auto* widget = in.findChild<Widget*>(name);
  if (widget == nullptr) {
    ADD_FAILURE() << "no widget is called " << name;
    std::abort();
  }
  return *widget;
}

/// Until the layouts are made: a round of events moves no widget of the window any more.
inline bool laid_out(const QWidget& window) {
  const auto places = [&] {
    QList<QRect> all{window.geometry()};
    for (const auto* widget : window.findChildren<QWidget*>()) all << widget->geometry();
    return all;
  };
  return wait_until([&] {
    const auto before = places();
    QCoreApplication::sendPostedEvents();
    QCoreApplication::processEvents();
    return places() == before;
  });
}

/// A picture of the widget, where pictures are asked for: in the folder ISOGRASP_TEST_PICTURES.
inline void keep_picture(QWidget& widget, const QString& name) {
  const auto folder = qEnvironmentVariable("ISOGRASP_TEST_PICTURES");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  EXPECT_TRUE(laid_out(widget));
  EXPECT_TRUE(widget.grab().save(folder + "/" + name + ".png"));
}
inline void keep_pictures_of_both_sizes(QWidget& window, const QString& name) {
  if (qEnvironmentVariableIsEmpty("ISOGRASP_TEST_PICTURES")) return;
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
    window.resize(size);
    keep_picture(window, QStringLiteral("%1_%2").arg(name).arg(size.height()));
  }
  window.resize(1280, 720);
}

}  // namespace isograsp::gui::test
