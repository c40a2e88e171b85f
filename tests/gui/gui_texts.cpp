// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the texts of the layers below as a source that lupdate reads: scripts/translations.
#include <cstdio>
#include <string>

#include "tests/gui/texts_below.hpp"

int main() {
  const std::string source = ISOGRASP_SOURCE_DIR;
  std::puts("static const char* const kTexts[] = {");
  for (const std::string& text : isograsp::texts_below(source + "/library", source)) {
    std::string literal;
    for (const char c : text) {
      if (c == '"' || c == '\\') literal += '\\';
      literal += c;
    }
    std::printf("    QT_TRANSLATE_NOOP(\"Texts\", \"%s\"),\n", literal.c_str());
  }
  std::puts("};");
}
