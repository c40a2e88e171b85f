// SPDX-License-Identifier: GPL-3.0-or-later
// Brings languages/*.po up to date (scripts/translations): new texts come in without words, what
// nobody says any more goes. With
// --missing it lists what has no words and fails if there is any.
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

#include "core/files.hpp"
#include "languages/catalogue.hpp"
#include "languages/languages.hpp"
#include "tests/languages/source_texts.hpp"

namespace {

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? "\\n" : std::string(1, c);
  }
  return quoted + '"';
}

}  // namespace

int main(int argc, char** argv) {
  using namespace isograsp;
  const std::string source = ISOGRASP_SOURCE_DIR;
  const bool only_list = argc > 1 && std::string_view(argv[1]) == "--missing";
  const auto texts = languages::all_texts(source);
  bool missing = false;
  for (const auto& [code, name, decimal_sign, day] : languages::kLanguages) {
    if (std::string_view(code) == "en") continue;
    const std::string path = source + "/languages/" + code + ".po";
    const auto po = read_text(path);
    const auto before = languages::read_translations(po ? *po : std::string());
    if (!po || !before) {
      std::fprintf(stderr, "%s: %s\n", path.c_str(),
                   (po ? before.error() : po.error()).message().c_str());
      return 1;
    }
    std::map<std::string, std::string> words;
    for (const auto& entry : *before) words[entry.english] = entry.words;
    std::string now = po->substr(0, po->find("\n\n") + 1);  // its head
    for (const auto& text : texts) {
      now += "\nmsgid " + in_quotes(text) + "\nmsgstr " + in_quotes(words[text]) + "\n";
      if (!words[text].empty()) continue;
      missing = true;
      std::printf("%s: %s\n", code, text.c_str());
    }
    if (!only_list && now != *po) std::ofstream(path) << now;
  }
  return only_list && missing ? 1 : 0;
}
