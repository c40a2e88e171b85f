// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of texts: what the translations know as "cannot be opened for %1" is also "cannot be
// opened for reading".
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <string_view>

namespace isograsp::gui {

/// The text with %1, %2 … for its numbers, which go behind those in `numbers`.
[[nodiscard]] QString without_numbers(const QString& text, QStringList& numbers);
/// The same, for who does not need the numbers: how the translations know the text.
[[nodiscard]] std::string pattern_of(std::string_view english);

/// A text in which %1, %2 … stand for any words, in this order, or for none.
class TextPattern {
 public:
  explicit TextPattern(const QString& text);

  [[nodiscard]] const QString& text() const noexcept { return text_; }
  /// How many fixed characters there are: of patterns that fit, the longest says the most.
  [[nodiscard]] int length() const noexcept { return length_; }
  /// Between quotation marks stands what somebody has written: no word of ours.
  [[nodiscard]] bool is_quoted(int place) const;
  /// What stands at the places, if the text is of this pattern as a whole.
  [[nodiscard]] std::optional<QStringList> values_in(const QString& text) const;

 private:
  QString text_;
  QStringList fixed_;  ///< before, between and behind the places
  int length_ = 0;
};

/// The words with `values` at their places %1, %2 …
[[nodiscard]] QString filled(const QString& words, const QStringList& values);

}  // namespace isograsp::gui
