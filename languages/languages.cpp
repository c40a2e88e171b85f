// SPDX-License-Identifier: GPL-3.0-or-later
#include "languages/languages.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <span>

#include "languages/catalogue.hpp"
#include "languages/compiled.hpp"

namespace isograsp::languages {

namespace {

/// "de_CH.UTF-8" is "de".
std::string_view code_of(std::string_view locale) {
  return locale.substr(0, locale.find_first_of("_.@"));
}

/// Of every language but English.
std::map<std::string_view, Catalogue> catalogues() {
  std::map<std::string_view, Catalogue> all;
  for (const LanguageFacts& one : std::span(kLanguages).subspan(1))
    all.try_emplace(one.code, texts_of(one.code), Forms{one.decimal_sign, one.day});
  return all;
}

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

bool is_language(std::string_view code) noexcept {
  return std::any_of(kLanguages.begin(), kLanguages.end(),
                     [&](const LanguageFacts& language) { return code == language.code; });
}

const Language& language(std::string_view code) {
  static const Language kEnglish;
  static const std::map<std::string_view, Catalogue> kCatalogues = catalogues();
  const auto one = kCatalogues.find(code);
  return one == kCatalogues.end() ? kEnglish : one->second;
}

std::string desktop_language() {
  std::string_view locale;
  for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (locale.empty()) locale = setting(name);
  if (locale.empty() || locale == "C" || locale == "POSIX") return "en";
  // A list in the order of preference; without a locale it is ignored (gettext does the same).
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
