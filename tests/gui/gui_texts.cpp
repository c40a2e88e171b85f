// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the texts of the layers below as a source that lupdate reads; with --patterns one in a
// line those with places for any words: scripts/translations.
#include <cstdio>
#include <string>
#include <string_view>

#include "tests/gui/message_texts.hpp"
#include "tests/gui/texts_below.hpp"

int main(int argc, char** argv) {
  const std::string source = ISOGRASP_SOURCE_DIR;
  if (argc > 1 && std::string_view(argv[1]) == "--patterns") {
    for (const auto& pattern : isograsp::gui::patterns_of_messages(source))
      std::puts(pattern.c_str());
    return 0;
  }
  std::puts("static const char* const kTexts[] = {");
  for (const std::string& text : isograsp::gui::texts_below(source + "/library", source)) {
    std::string literal;
    for (const char c : text) {
      if (c == '"' || c == '\\') literal += '\\';
      literal += c;
    }
    std::printf("    QT_TRANSLATE_NOOP(\"Texts\", \"%s\"),\n", literal.c_str());
  }
  std::puts("};");
}
