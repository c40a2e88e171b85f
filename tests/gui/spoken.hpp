// SPDX-License-Identifier: GPL-3.0-or-later
// Another language for the length of a test.
#pragma once

#include <QLocale>
#include <QTranslator>

#include "gui/words/language.hpp"
#include "qt_test.hpp"

namespace isograsp::gui::test {

class Spoken {
 public:
  explicit Spoken(const char* code) { speak(code); }
  ~Spoken() {
    speak("en");
    for (auto* left : application().findChildren<QTranslator*>("spoken")) delete left;
    QLocale::setDefault(before_);
  }
  Spoken(const Spoken&) = delete;
  Spoken& operator=(const Spoken&) = delete;

 private:
  QLocale before_;
};

}  // namespace isograsp::gui::test
