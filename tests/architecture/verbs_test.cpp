// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: three verbs turn a value into text. name_of() is for machines (files, JSON,
// databases), words_of() for people, translated() is what stands on a screen or on paper.
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::verbs_test {
namespace {

using namespace architecture;

/// Functions that return a text under one of the verbs that were given up. What returns nothing may
/// be called so: Session::shown() is told that a picture appeared.
std::vector<std::string> other_verbs(const std::string& text) {
  static const std::regex kFunction(
      R"((?:string|string_view|QString|Text|\w*Words|char\*|>)[&>]*\s+(?:\w+::)*)"
      R"((describe|title_of|words_for|text_of|shown|shown_\w+)\()");
  static const std::regex kLocal(
      R"(auto&?\s+(describe|title_of|words_for|text_of|shown)\s*=\s*\[)");
  const std::string code = code_of(text);
  std::vector<std::string> found;
  for (const std::regex* one : {&kFunction, &kLocal})
    for (std::sregex_iterator at(code.begin(), code.end(), *one), end; at != end; ++at)
      found.push_back((*at)[1]);
  return found;
}

TEST(Verbs, ThatTurnAValueIntoTextAreThree) {
  test::AtLeast files(500);
  for (const Source& source : test::every(all_sources())) {
    ++files;
    for (const std::string& verb : other_verbs(source.text()))
      ADD_FAILURE() << source.file << ": " << verb << "() returns a text: call it name_of() if a "
                    << "machine reads it, words_of() if people do, translated() if it is in the "
                    << "language of the reader";
  }
}

TEST(Verbs, ThatWereGivenUpAreFound) {
  const std::vector<std::string> expected{"describe",  "title_of",   "text_of",
                                          "words_for", "shown_date", "shown"};
  EXPECT_EQ(other_verbs("std::string describe(const Rest& rest);\n"
                        "QString Page::title_of(Step step) {\n}\n"
                        "[[nodiscard]] std::string_view text_of(Cue cue) noexcept;\n"
                        "CueWords words_for(Cue cue);\nQString shown_date(std::string_view iso);\n"
                        "void shown(const ScreenShown& screen);\nvoid describe(QWidget& widget);\n"
                        "// std::string describe(int)\n"
                        "const auto shown = [&](double value) { return fixed(value, 1); };\n"
                        "const auto shown = list.text();\nreturn words_of(step);\n"),
            expected);
}

}  // namespace
}  // namespace isograsp::verbs_test
