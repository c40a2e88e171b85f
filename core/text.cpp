// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text.hpp"

#include <cstdio>

#include "core/csv.hpp"

namespace isograsp {

Number fixed(double value, int decimals) {
  std::string digits(static_cast<std::size_t>(std::snprintf(nullptr, 0, "%.*f", decimals, value)),
                     '\0');
  std::snprintf(digits.data(), digits.size() + 1, "%.*f", decimals, value);
  return {digits};
}

Number shortest(double value) {
  return {format_number(value)};
}

Text::Text(std::string_view english, std::vector<Argument> arguments)
    : english_(english), arguments_(std::move(arguments)) {}

Text::Text(Known words) {
  if (words.words.empty()) return;
  *this = "%1"_text(std::move(words));
}

Text Text::with_names_up_to(std::size_t most) const {
  Text shorter(english_, {});
  for (const Argument& argument : arguments_) {
    const auto* name = std::get_if<std::string>(&argument.value());
    const auto* text = std::get_if<Text>(&argument.value());
    if (name != nullptr)
      shorter.arguments_.emplace_back(shortened(*name, most));
    else if (text != nullptr)
      shorter.arguments_.emplace_back(text->with_names_up_to(most));
    else
      shorter.arguments_.push_back(argument);
  }
  return shorter;
}

std::string shortened(std::string text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most) + "…";
}

bool Text::operator==(const Text& other) const {
  return english_ == other.english_ && arguments_ == other.arguments_;
}

Text joined(const std::vector<Text>& parts) {
  return joined(parts, " "_text);
}

Text joined(const std::vector<Text>& parts, Words between) {
  Text all;
  for (const Text& part : parts) {
    if (part.empty()) continue;
    all = all.empty() ? part : "%1%2%3"_text(std::move(all), between, part);
  }
  return all;
}

namespace {

struct Said {
  const Language& language;

  std::string operator()(const std::string& as_it_is) const { return as_it_is; }
  std::string operator()(const Number& number) const { return language.number(number.digits); }
  std::string operator()(Date day) const { return language.day(day); }
  std::string operator()(const Known& known) const {
    return std::string(language.words(known.words));
  }
  std::string operator()(const Text& text) const { return translated(text, language); }
};

}  // namespace

std::string translated(const Text& text, const Language& language) {
  const std::string_view words = language.words(text.english());
  std::string said;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t place = text_detail::place_at(words, i);
    if (place == 0 || place > text.arguments().size()) {
      said += words[i];
      continue;
    }
    said += std::visit(Said{language}, text.arguments()[place - 1].value());
    ++i;
  }
  return said;
}

std::string english(const Text& text) {
  return translated(text, Language());
}

}  // namespace isograsp
