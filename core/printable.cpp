// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/printable.hpp"

#include <cstdint>

namespace isograsp {

namespace {

/// One character at the front of some bytes.
struct Utf8 {
  std::size_t bytes = 0;  ///< 0: these bytes are no UTF-8
  std::uint32_t code = 0;
};

Utf8 front_of(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first < 0x80) return {1, first};
  const std::size_t bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < bytes) return {};
  std::uint32_t code = first & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0) != 0x80) return {};
    code = code << 6 | (next & 0x3FU);
  }
  const bool shortest = code >= (bytes == 2 ? 0x80U : bytes == 3 ? 0x800U : 0x10000U);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return shortest && !surrogate && code <= 0x10FFFF ? Utf8{bytes, code} : Utf8{};
}

bool is_harmless(std::uint32_t code) {
  const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  const bool turns = code == 0x061C || code == 0x200E || code == 0x200F ||
                     (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  const bool breaks = code == 0x2028 || code == 0x2029;
  return !control && !turns && !breaks;
}

void append_hex(std::string& text, std::uint32_t value, int digits) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  while (digits-- > 0) text += kHexDigits[value >> (4 * digits) & 0xF];
}

void append_escape(std::string& text, std::uint32_t code) {
  switch (code) {
    case '\n': text += "\\n"; return;
    case '\r': text += "\\r"; return;
    case '\t': text += "\\t"; return;
    default: break;
  }
  text += code < 0x100 ? "\\x" : "\\u";
  append_hex(text, code, code < 0x100 ? 2 : 4);
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Utf8 character = front_of(text);
    const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
    const bool keep = character.bytes != 0 && (is_harmless(character.code) ||
                                               kept.find(text.front()) != std::string_view::npos);
    if (keep)
      shown += text.substr(0, bytes);
    else
      append_escape(
          shown, character.bytes == 0 ? static_cast<unsigned char>(text.front()) : character.code);
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace

std::string printable(std::string_view words) {
  return escaped(words, {});
}

std::string printable_lines(std::string_view text) {
  return escaped(text, "\n\t");
}

}  // namespace isograsp
