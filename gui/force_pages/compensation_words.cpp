// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/force_pages/compensation_words.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

struct CompensationTexts {
  Q_DECLARE_TR_FUNCTIONS(Compensation)
};

constexpr double kMm = 1000.0;  // in a metre

}  // namespace

QString compensation_words(const session::Compensation& compensation) {
  QStringList sentences;
  const auto push = compensation.push_percent();
  if (push && *push >= session::kRemarkablePush_percent)
    sentences += CompensationTexts::tr(
                     "This measures the shoulder, too: the arm pushes the platform with %1 % "
                     "of the grip. Let it rest on the support.")
                     .arg(QLocale().toString(*push, 'f', 0));
  for (const Finger finger : kFingers) {
    const auto shift_m = compensation.pad_shift_m(finger);
    if (shift_m && *shift_m > session::kRemarkablePadShift_m)
      sentences += CompensationTexts::tr("%1 moved %2 mm on its support: seat it anew.")
                       .arg(finger_title(finger), QLocale().toString(*shift_m * kMm, 'f', 0));
    if (compensation.slips(finger))
      sentences += CompensationTexts::tr("%1 slips: more force into the object, less along it.")
                       .arg(finger_title(finger));
  }
  return sentences.join(QLatin1Char(' '));
}

}  // namespace isograsp::gui
