// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/texts.hpp"

#include <QCoreApplication>
#include <QDate>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <optional>

namespace isograsp {

namespace {

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// A number that stands alone or before its unit, not a digit of a name.
const QRegularExpression& number() {
  static const QRegularExpression kNumber(
      QStringLiteral("(?<![\\w.%])[-\u2212]?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?(?![\\w])"));
  return kNumber;
}

/// The text with %1, %2 … for its numbers, which go into `numbers`.
QString taken_out(const QString& text, QStringList& numbers) {
  QString pattern;
  int from = 0;
  for (auto all = number().globalMatch(text); all.hasNext();) {
    const auto found = all.next();
    numbers += found.captured();
    pattern += text.mid(from, found.capturedStart() - from);
    pattern += QStringLiteral("%") + QString::number(numbers.size());
    from = found.capturedEnd();
  }
  return pattern + text.mid(from);
}

std::optional<QString> known(const QString& english) {
  if (english.isEmpty()) return QString();
  const QByteArray source = english.toUtf8();
  const QString translated = QCoreApplication::translate("Texts", source.constData());
  if (translated == english) return std::nullopt;
  return translated;
}

/// Whole, or with its numbers taken out and put in again.
std::optional<QString> known_with_numbers(const QString& english) {
  if (const auto whole = known(english)) return whole;
  QStringList numbers;
  const QString pattern = taken_out(english, numbers);
  if (numbers.isEmpty()) return std::nullopt;
  auto words = known(pattern);
  if (!words) return std::nullopt;
  // From the last one: %1 is also the beginning of %10.
  for (int i = numbers.size(); i > 0; --i)
    words->replace(QStringLiteral("%") + QString::number(i),
                   shown_digits(numbers[i - 1].toStdString()));
  return words;
}

}  // namespace

std::string pattern_of(std::string_view english) {
  QStringList numbers;
  return taken_out(qt(english), numbers).toStdString();
}

QString shown(std::string_view english) {
  const QString text = qt(english);
  if (auto words = known_with_numbers(text)) return *words;
  static const QRegularExpression kSentenceEnd(QStringLiteral("(?<=[.!?]) +"));
  const auto sentences = text.split(kSentenceEnd, Qt::SkipEmptyParts);
  if (sentences.size() < 2) return text;
  QStringList words;
  for (const auto& sentence : sentences) words += known_with_numbers(sentence).value_or(sentence);
  return words.join(QLatin1Char(' '));
}

QString shown(const Error& error) {
  Error words = error;
  words.what = shown(error.what).toStdString();
  words.remedy = shown(error.remedy).toStdString();
  return QString::fromStdString(words.message());
}

QString in_sentence(QString words) {
  if (!words.isEmpty() && QLocale().language() != QLocale::German) words[0] = words[0].toLower();
  return words;
}

QString shown_number(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

QString shown_digits(std::string_view digits) {
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

QString shown_date(std::string_view iso) {
  const auto day = QDate::fromString(qt(iso), Qt::ISODate);
  return day.isValid() ? QLocale().toString(day, date_form()) : qt(iso);
}

}  // namespace isograsp
