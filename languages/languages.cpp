// SPDX-License-Identifier: GPL-3.0-or-later
#include "languages/languages.hpp"

#include <algorithm>
#include <cstdlib>

#include "languages/catalogue.hpp"
#include "languages/compiled.hpp"

namespace isograsp::languages {

namespace {

/// "de_CH.UTF-8" is "de".
std::string_view code_of(std::string_view locale) {
  return locale.substr(0, locale.find_first_of("_.@"));
}

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool is_language(std::string_view code) noexcept {
  return std::any_of(kLanguages.begin(), kLanguages.end(),
                     [&](const LanguageName& language) { return code == language.code; });
}

const Language& language(std::string_view code) {
  static const Language kEnglish;
  static const Catalogue kGerman(kGermanTexts, {',', "dd.MM.yyyy"});
  static const Catalogue kFrench(kFrenchTexts, {',', "dd/MM/yyyy"});
  if (code == "de") return kGerman;
  if (code == "fr") return kFrench;
  return kEnglish;
}

std::string desktop_language() {
  std::string_view locale;
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (locale.empty()) locale = setting(name);
  if (locale.empty() || locale == "C" || locale == "POSIX") return "en";
  // A list, the first wish first; without a locale it says nothing (gettext does the same).
  for (std::string_view wishes = setting("LANGUAGE"); !wishes.empty();) {
    const auto end = std::min(wishes.find(':'), wishes.size());
    if (const auto code = code_of(wishes.substr(0, end)); is_language(code))
      return std::string(code);
    wishes.remove_prefix(std::min(end + 1, wishes.size()));
  }
  const auto code = code_of(locale);
  return is_language(code) ? std::string(code) : "en";
}

}  // namespace isograsp::languages
