// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/config/uri.hpp"

#include <algorithm>

#include "core/csv.hpp"

namespace isograsp {

namespace {

constexpr Words kUriShape = "write scheme://target?key=value&key=value"_text;

int hex_value(char c) noexcept {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Decodes %XX; false if an escape is cut off or not hexadecimal.
bool decode_percent(std::string_view text, std::string& out) {
  out.clear();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return false;
    const int high = hex_value(text[i + 1]);
    const int low = hex_value(text[i + 2]);
    if (high < 0 || low < 0) return false;
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return true;
}

bool is_scheme(std::string_view text) noexcept {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
  });
}

}  // namespace

Result<Uri> Uri::parse(std::string_view text) {
  Uri uri;
  uri.text = text;
  const auto colon = text.find("://");
  if (colon == std::string_view::npos || !is_scheme(text.substr(0, colon)))
    return refused("not a device URI"_text, kUriShape).at(uri.text);
  uri.scheme = text.substr(0, colon);

  std::string_view rest = text.substr(colon + 3);
  const auto question = rest.find('?');
  if (!decode_percent(rest.substr(0, question), uri.target))
    return refused("a '%' without two hexadecimal digits"_text, "write %25 for a percent sign"_text)
        .at(uri.text);
  if (question == std::string_view::npos) return uri;

  rest.remove_prefix(question + 1);
  while (true) {
    const auto ampersand = rest.find('&');
    const auto pair = rest.substr(0, ampersand);
    const auto equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0)
      return refused("not a parameter of the form key=value"_text, kUriShape)
          .at(uri.text)
          .about(std::string(pair));
    std::string key;
    std::string value;
    if (!decode_percent(pair.substr(0, equals), key) ||
        !decode_percent(pair.substr(equals + 1), value))
      return refused("a '%' without two hexadecimal digits"_text,
                     "write %25 for a percent sign"_text)
          .at(uri.text)
          .about(std::string(pair));
    if (!uri.parameters.emplace(key, value).second)
      return refused("the parameter is given twice"_text, "give it once"_text)
          .at(uri.text)
          .about(key);
    if (ampersand == std::string_view::npos) return uri;
    rest.remove_prefix(ampersand + 1);
  }
}

Result<void> Uri::require_known(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, value] : parameters) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    std::string names;
    for (const auto name : known) {
      if (!names.empty()) names += ", ";
      names += name;
    }
    return refused("unknown parameter of %1://"_text(scheme),
                   names.empty() ? "leave it out"_text : "use %1"_text(names))
        .at(text)
        .about(key);
  }
  return {};
}

std::string Uri::text_or(const std::string& key, std::string fallback) const {
  const auto found = parameters.find(key);
  if (found == parameters.end()) return fallback;
  return found->second;
}

Result<double> Uri::number_or(const std::string& key, double fallback, double least,
                              double most) const {
  const auto found = parameters.find(key);
  if (found == parameters.end()) return fallback;
  double value = 0.0;
  if (!parse_number(found->second, value) || value < least || value > most)
    return refused("'%1' is not a number that this parameter takes"_text(found->second),
                   "give one from %1 to %2"_text(shortest(least), shortest(most)))
        .at(text)
        .about(key);
  return value;
}

}  // namespace isograsp
