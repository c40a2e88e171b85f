// SPDX-License-Identifier: GPL-3.0-or-later
// What a program says to people: English words that stand in a source, with places for what varies.
// A Text stays apart from its values until somebody reads it, so that each language can put them
// where they belong (docs/decisions/0009-texts.md):
//   Text text = "drifts by %1 N/s, the limit is %2 N/s"_text(fixed(drift, 2), fixed(limit, 2));
//   translated(text, language)
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/date.hpp"

namespace isograsp {

/// A number with the digits that people shall read, and '.' as decimal sign, which a language
/// replaces by its own.
struct Number {
  std::string digits;
  bool operator==(const Number&) const = default;
};
/// With so many digits behind the point.
[[nodiscard]] Number fixed(double value, int decimals);
/// The shortest that reads back to the same double.
[[nodiscard]] Number shortest(double value);

/// Words that no source has, such as the name of a task or what the system says of a failure:
/// looked up as a whole; those that a language does not know stay as they are.
struct Known {
  std::string words;
  bool operator==(const Known&) const = default;
};

class Argument;
template <std::size_t Places>
class Phrase;

/// Words with the values at their places. Equal: the same words with the same values.
class Text {
 public:
  /// Says nothing.
  Text() = default;
  /// Words that no source has (Known).
  Text(Known words);  // NOLINT: a name is a text

  [[nodiscard]] bool empty() const noexcept { return english_.empty(); }
  /// In the source, with the places.
  [[nodiscard]] std::string_view english() const noexcept { return english_; }
  [[nodiscard]] const std::vector<Argument>& arguments() const noexcept { return arguments_; }
  /// With names of `most` bytes at most, '…' behind one that was longer: they may come from a file.
  [[nodiscard]] Text with_names_up_to(std::size_t most) const;
  bool operator==(const Text& other) const;

 private:
  template <std::size_t>
  friend class Phrase;
  Text(std::string_view english, std::vector<Argument> arguments);

  std::string_view english_;  ///< of a literal: stands as long as the program
  std::vector<Argument> arguments_;
};

/// What stands at a place: a name, path or key as it is, a number, a day, or words with places of
/// their own.
class Argument {
 public:
  using Value = std::variant<std::string, Number, Date, Known, Text>;

  template <class V>
  requires std::constructible_from<std::string, V> &&(!std::integral<V>)Argument(V&& as_it_is)
      : value_(std::string(std::forward<V>(as_it_is))) {}  // NOLINT
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool> && !std::same_as<Whole, char>) Argument(Whole number)
      : value_(Number{std::to_string(number)}) {}         // NOLINT
  Argument(Number number) : value_(std::move(number)) {}  // NOLINT
  Argument(Date day) : value_(day) {}                     // NOLINT
  Argument(Known words) : value_(std::move(words)) {}     // NOLINT
  Argument(Text text) : value_(std::move(text)) {}        // NOLINT
  template <std::size_t Places>
  requires(Places == 0) Argument(const Phrase<Places>& words) : value_(Text(words)) {}  // NOLINT

  [[nodiscard]] const Value& value() const noexcept { return value_; }
  bool operator==(const Argument&) const = default;

 private:
  Value value_;
};

/// Words of a source with so many places %1, %2 … %9; a '%' before anything else, or before two
/// digits, is itself. Made by "…"_text alone, so that composed words do not compile. Without places
/// a Text; with them a function that makes one of as many values. Trivially copyable.
template <std::size_t Places>
class Phrase {
 public:
  constexpr explicit Phrase(const char* english) noexcept : english_(english) {}

  [[nodiscard]] constexpr const char* english() const noexcept { return english_; }
  operator Text() const  // NOLINT: words without places are a text
      requires(Places == 0) {
    return {std::string_view(english_), std::vector<Argument>()};
  }
  template <class... Values>
  requires(sizeof...(Values) == Places && Places > 0 &&
           (std::constructible_from<Argument, Values> && ...)) [[nodiscard]] Text
  operator()(Values&&... values) const {
    std::vector<Argument> arguments;
    arguments.reserve(Places);
    (arguments.emplace_back(std::forward<Values>(values)), ...);
    return {std::string_view(english_), std::move(arguments)};
  }
  bool operator==(const Phrase&) const = default;

 private:
  const char* english_;
};
/// Words without places: what tables hold.
using Words = Phrase<0>;

namespace text_detail {

/// The place that begins at text[at]: 1 to 9; 0: none.
constexpr std::size_t place_at(std::string_view text, std::size_t at) noexcept {
  const auto digit = [&](std::size_t i) {
    return i < text.size() && text[i] >= '0' && text[i] <= '9';
  };
  if (text[at] != '%' || !digit(at + 1) || text[at + 1] == '0' || digit(at + 2)) return 0;
  return static_cast<std::size_t>(text[at + 1] - '0');
}

template <std::size_t Size>
struct Literal {
  char characters[Size];
  consteval Literal(const char (&text)[Size]) {  // NOLINT: made of what stands before the suffix
    std::copy_n(text, Size, characters);
  }
  [[nodiscard]] consteval std::string_view text() const { return {characters, Size - 1}; }
  /// The highest place.
  [[nodiscard]] consteval std::size_t places() const {
    std::size_t most = 0;
    for (std::size_t i = 0; i + 1 < Size; ++i) most = std::max(most, place_at(text(), i));
    return most;
  }
};

}  // namespace text_detail

template <text_detail::Literal literal>
consteval auto operator""_text() {
  return Phrase<literal.places()>(literal.characters);
}

/// Its first `most` bytes, not cut within a character, and '…'; as it is if it has no more.
[[nodiscard]] std::string shortened(std::string text, std::size_t most);

/// The first and the rest behind it, with `between` from one to the next; empty ones are left out.
[[nodiscard]] Text joined(const std::vector<Text>& parts, Words between);
/// … with a blank.
[[nodiscard]] Text joined(const std::vector<Text>& parts);

/// How a language says words, numbers and days. This one is English. Any thread.
class Language {
 public:
  Language() = default;
  virtual ~Language() = default;
  Language(const Language&) = delete;
  Language& operator=(const Language&) = delete;

  /// The words in this language, their places in it; as they are if it does not know them.
  [[nodiscard]] virtual std::string_view words(std::string_view english) const { return english; }
  /// Digits with '.' as they are written.
  [[nodiscard]] virtual std::string number(std::string_view digits) const {
    return std::string(digits);
  }
  /// English-speaking countries order day and month in opposite ways: in English it is 2026-03-05.
  [[nodiscard]] virtual std::string day(Date date) const { return iso_text(date); }
};

[[nodiscard]] std::string translated(const Text& text, const Language& language);
[[nodiscard]] std::string english(const Text& text);

}  // namespace isograsp
