// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/text_patterns.hpp"

#include <QRegularExpression>

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

std::string pattern_of(std::string_view english) {
  QStringList numbers;
  const auto text = QString::fromUtf8(english.data(), static_cast<int>(english.size()));
  return without_numbers(text, numbers).toStdString();
}

TextPattern::TextPattern(const QString& text) : text_(text) {
  int from = 0;
  for (int number = 1;; ++number) {
    const int at = text.indexOf(place_mark(number), from);
    if (at < 0) break;
    fixed_ << text.mid(from, at - from);
    from = at + place_mark(number).size();
  }
  fixed_ << text.mid(from);
  for (const auto& part : fixed_) length_ += part.size();
}

bool TextPattern::is_quoted(int place_mark) const {
  const auto& before = fixed_[place_mark];
  return before.endsWith(QLatin1Char('\'')) || before.endsWith(QLatin1Char('"'));
}

std::optional<QStringList> TextPattern::values_in(const QString& text) const {
  const int end = text.size() - fixed_.back().size();
  int from = fixed_.front().size();
  if (end < from || !text.startsWith(fixed_.front()) || !text.endsWith(fixed_.back()))
    return std::nullopt;
  QStringList values;
  for (int i = 1; i < fixed_.size(); ++i) {
    const int at = i + 1 == fixed_.size() ? end : text.indexOf(fixed_[i], from);
    if (at < from || at > end) return std::nullopt;
    values << text.mid(from, at - from);
    from = at + fixed_[i].size();
  }
  return values;
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

}  // namespace isograsp::gui
