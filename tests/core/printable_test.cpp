// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/printable.hpp"

#include <gtest/gtest.h>

#include "core/result.hpp"

namespace isograsp::printable_test {
namespace {

TEST(Printable, WordsOfEveryLanguageStayAsTheyAre) {
  for (const char* words : {"", "P-0427", "Größe 5 µm — „gut“", "Ελληνικά", "日本語", "עברית", "😀",
                            "back\\slash", "l'index"}) {
    EXPECT_EQ(printable(words), words);
    EXPECT_EQ(printable_lines(words), words);
  }
}

TEST(Printable, WhatMovesACursorOrTurnsTheWritingIsWrittenOut) {
  using namespace std::string_view_literals;
  EXPECT_EQ(printable("a\x1b]0;title\a\x1b[2J"), "a\\x1b]0;title\\x07\\x1b[2J");
  EXPECT_EQ(printable("two\nlines\r\tand\0zero\x7f"sv), "two\\nlines\\r\\tand\\x00zero\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "\\x9b2J")
      << "the one-character control sequence introducer";
  EXPECT_EQ(printable("user\xE2\x80\xAE"
                      "fdp.exe"),
            "user\\u202efdp.exe");
  EXPECT_EQ(printable("a\xE2\x80\xA8z"), "a\\u2028z");
  EXPECT_EQ(printable_lines("two\n\tlines\x1b[2J"), "two\n\tlines\\x1b[2J");
}

TEST(Printable, BytesThatAreNoUtf8AreWrittenOut) {
  for (const char* bytes : {"\xff", "\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xC3",
                            "\xF4\x90\x80\x80", "\xE2\x80"}) {
    std::string expected;
    for (const char* c = bytes; *c != '\0'; ++c) {
      constexpr const char* kDigits = "0123456789abcdef";
      const auto byte = static_cast<unsigned char>(*c);
      expected += std::string("\\x") + kDigits[byte >> 4] + kDigits[byte & 0xF];
    }
    EXPECT_EQ(printable(bytes), expected);
  }
}

TEST(ErrorMessage, IsOneLineWhateverTheFileIsCalledAndHolds) {
  const Error error =
      refused("'%1' is not a number"_text("\x1b[31m"), "write one"_text).at("a\nb.csv", 3, "x\ry");
  EXPECT_EQ(error.message(), "a\\nb.csv:3: x\\ry: '\\x1b[31m' is not a number; write one");
}

}  // namespace
}  // namespace isograsp::printable_test
