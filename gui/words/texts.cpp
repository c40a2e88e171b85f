// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/texts.hpp"

#include <QDate>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <optional>
#include <vector>

#include "gui/words/language.hpp"
#include "gui/words/text_patterns.hpp"

namespace isograsp::gui {

namespace {

QString qt(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

std::optional<QString> known(const QString& english) {
  if (english.isEmpty()) return QString();
  const QString words = qt(spoken_language().words(english.toStdString()));
  if (words == english) return std::nullopt;
  return words;
}

/// Whole, or with its numbers taken out and put in again.
std::optional<QString> known_with_numbers(const QString& english) {
  if (const auto whole = known(english)) return whole;
  QStringList numbers;
  const auto words = known(without_numbers(english, numbers));
  if (!words || numbers.isEmpty()) return std::nullopt;
  for (auto& number : numbers) number = shown_digits(number.toStdString());
  return filled(*words, numbers);
}

std::optional<QString> known_at_once(const QString& english);
std::optional<QString> found(const QString& english);

/// What stands at a place of a pattern: a number, words that are known, or something of its own.
/// Brackets and the like around it stay.
QString value_words(const QString& value) {
  static const QRegularExpression kCore(QStringLiteral("^([\\s(,]*)(.*?)([\\s)]*)$"),
                                        QRegularExpression::DotMatchesEverythingOption);
  if (const auto whole = found(value)) return *whole;
  const auto parts = kCore.match(value);
  const auto core = found(parts.captured(2));
  return core ? parts.captured(1) + *core + parts.captured(3) : value;
}

std::optional<QString> known_by_pattern(const QString& english) {
  for (const auto& pattern : patterns_below()) {
    auto values = pattern.values_in(english);
    // Behind a semicolon begins what to do about it: a text of its own.
    if (!values || values->join(QString()).contains(QLatin1String("; "))) continue;
    const auto words = known(pattern.text());
    if (!words) continue;
    for (int i = 0; i < values->size(); ++i)
      if (!pattern.is_quoted(i)) (*values)[i] = value_words((*values)[i]);
    return filled(*words, *values);
  }
  return std::nullopt;
}

/// A line of an error, "file:3: key: what is wrong; what to do": as much of it at once as is known.
std::optional<QString> known_in_parts(const QString& english) {
  static const QRegularExpression kMark(QStringLiteral("[;:] "));
  std::vector<int> ends;  // of the parts
  for (auto all = kMark.globalMatch(english); all.hasNext();)
    ends.push_back(all.next().capturedStart());
  constexpr std::size_t kMostParts = 12;  // what has more of them is no message
  if (ends.empty() || ends.size() >= kMostParts) return std::nullopt;
  constexpr int kMark_chars = 2;
  ends.push_back(english.size());
  bool any = false;
  QString words;
  for (std::size_t part = 0, from = 0; part < ends.size();) {
    const auto start = static_cast<int>(from);
    std::size_t last = ends.size() - 1;
    std::optional<QString> known_words;
    for (;; --last) {
      known_words = known_at_once(english.mid(start, ends[last] - start));
      if (known_words || last == part) break;
    }
    any = any || known_words;
    words += known_words.value_or(english.mid(start, ends[last] - start));
    words += english.mid(ends[last], kMark_chars);
    from = static_cast<std::size_t>(ends[last] + kMark_chars);
    part = last + 1;
  }
  return any ? std::optional(words) : std::nullopt;
}

std::optional<QString> known_at_once(const QString& english) {
  if (auto words = known_with_numbers(english)) return words;
  return known_by_pattern(english);
}

std::optional<QString> found(const QString& english) {
  if (auto words = known_at_once(english)) return words;
  return known_in_parts(english);
}

}  // namespace

QString shown(std::string_view english) {
  const QString text = qt(english);
  if (spoken() == "en") return text;
  if (auto words = known_with_numbers(text)) return *words;
  static const QRegularExpression kSentenceEnd(QStringLiteral("(?<=[.!?])(?<!e\\.g\\.) +"));
  const auto sentences = text.split(kSentenceEnd, Qt::SkipEmptyParts);
  QStringList words;
  for (const auto& sentence : sentences) words += found(sentence).value_or(sentence);
  return words.join(QLatin1Char(' '));
}

QString translated(const Text& text) {
  return QString::fromStdString(translated(text, spoken_language()));
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

}  // namespace isograsp::gui
