// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/texts.hpp"

#include <QDate>
#include <QLocale>

#include "gui/words/language.hpp"

namespace isograsp::gui {

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

QString translated(std::string_view english) {
  return translated(Known{std::string(english)});
}

QString translated(const Text& text) {
  return QString::fromStdString(translated(text, spoken_language()));
}

QString translated(const Error& error) {
  return QString::fromStdString(translated(error, spoken_language()));
}

QString in_sentence(QString words) {
  if (!words.isEmpty() && QLocale().language() != QLocale::German) words[0] = words[0].toLower();
  return words;
}

QString translated_number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

QString translated_digits(std::string_view digits) {
  return qt(digits).replace(QLatin1Char('.'), QLocale().decimalPoint());
}

QString date_form() {
  const auto language = QLocale().language();
  if (language == QLocale::English || language == QLocale::C) return QStringLiteral("yyyy-MM-dd");
  QString form = QLocale(language).dateFormat(QLocale::ShortFormat);
  if (!form.contains(QLatin1String("yyyy")))
    form.replace(QLatin1String("yy"), QLatin1String("yyyy"));
  return form;
}

QString translated_date(std::string_view iso) {
  const auto day = QDate::fromString(qt(iso), Qt::ISODate);
  return day.isValid() ? QLocale().toString(day, date_form()) : qt(iso);
}

}  // namespace isograsp::gui
