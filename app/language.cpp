// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language.hpp"

#include <optional>
#include <string_view>

#include "gui/application.hpp"
#include "languages/languages.hpp"

namespace isograsp::app {

namespace {

const Language* spoken_now = nullptr;

/// Takes every --language and its value out of the words; the last value, or nothing if there is
/// none.
std::optional<std::string> taken_out(std::vector<const char*>& words) {
  constexpr std::string_view kOption = "--language";
  std::optional<std::string> code;
  for (std::size_t i = 1; i < words.size() && words[i] != std::string_view("--");) {
    const std::string_view word = words[i];
    const auto at = words.begin() + static_cast<std::ptrdiff_t>(i);
    if (word == kOption) {
      const bool given = i + 1 < words.size();
      code = given ? words[i + 1] : "";
      words.erase(at, at + (given ? 2 : 1));
    } else if (word.starts_with(kOption) && word.substr(kOption.size()).starts_with('=')) {
      code = word.substr(kOption.size() + 1);
      words.erase(at);
    } else {
      ++i;
    }
  }
  return code;
}

/// The language set in the windows; empty: that of the desktop.
std::string set_by_the_clinic() {
  const std::string set = gui::language_in_settings();
  return languages::is_language(set) ? set : "";
}

}  // namespace

const Language& spoken() {
  return spoken_now == nullptr ? languages::language("en") : *spoken_now;
}

std::string spoken(const Text& text) {
  return translated(text, spoken());
}

Result<void> choose_language(std::vector<const char*>& words) {
  const auto asked = taken_out(words);
  if (asked && languages::is_language(*asked)) {
    spoken_now = &languages::language(*asked);
    return {};
  }
  const std::string set = set_by_the_clinic();
  spoken_now = &languages::language(set.empty() ? languages::desktop_language() : set);
  if (!asked) return {};
  std::string codes;
  for (const auto& language : languages::kLanguages)
    codes += (codes.empty() ? "" : ", ") + std::string(language.code);
  return refused("'%1' is no language that is there"_text(*asked), "give one of: %1"_text(codes))
      .about("--language");
}

}  // namespace isograsp::app
