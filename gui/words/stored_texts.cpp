// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/stored_texts.hpp"

#include <QRegularExpression>

#include "gui/words/language.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

QString place_mark(int number) {
  return QStringLiteral("%") + QString::number(number);
}

/// A number that stands alone or before its unit, not a digit of a name.
const QRegularExpression& number() {
  static const QRegularExpression kNumber(
      QStringLiteral("(?<![\\w.%])[-\u2212]?\\d+(?:\\.\\d+)?(?:e[-+]?\\d+)?(?![\\w])"));
  return kNumber;
}

std::optional<QString> known(const QString& english) {
  if (english.isEmpty()) return QString();
  const std::string asked = english.toStdString();  // words that are not known are these themselves
  const std::string_view words = spoken_language().words(asked);
  const auto found = QString::fromUtf8(words.data(), static_cast<int>(words.size()));
  return found == english ? std::nullopt : std::optional(found);
}

/// Whole, or with its numbers taken out and put in again.
std::optional<QString> known_with_numbers(const QString& english) {
  if (const auto whole = known(english)) return whole;
  QStringList numbers;
  const auto words = known(without_numbers(english, numbers));
  if (!words || numbers.isEmpty()) return std::nullopt;
  for (auto& number : numbers) number = translated_digits(number.toStdString());
  return filled(*words, numbers);
}

}  // namespace

QString without_numbers(const QString& text, QStringList& numbers) {
  QString pattern;
  int from = 0;
  for (auto all = number().globalMatch(text); all.hasNext();) {
    const auto found = all.next();
    numbers += found.captured();
    pattern += text.mid(from, found.capturedStart() - from) + place_mark(numbers.size());
    from = found.capturedEnd();
  }
  return pattern + text.mid(from);
}

QString filled(const QString& words, const QStringList& values) {
  QString text;
  for (int at = 0; at < words.size(); ++at) {
    int number = words[at] == QLatin1Char('%') ? values.size() : 0;
    while (number > 0 && words.midRef(at, place_mark(number).size()) != place_mark(number))
      --number;
    if (number == 0) {
      text += words[at];
      continue;
    }
    text += values[number - 1];
    at += place_mark(number).size() - 1;
  }
  return text;
}

QString stored_text(const QString& english) {
  if (const auto words = known_with_numbers(english)) return *words;
  static const QRegularExpression kSentenceEnd(QStringLiteral("(?<=[.!?])(?<!e\\.g\\.) +"));
  QStringList words;
  for (const auto& sentence : english.split(kSentenceEnd, Qt::SkipEmptyParts))
    words += known_with_numbers(sentence).value_or(sentence);
  return words.join(QLatin1Char(' '));
}

}  // namespace isograsp::gui
