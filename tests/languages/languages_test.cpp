// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that the program says lacks its words in a language, and they keep their places.
#include "languages/languages.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "languages/catalogue.hpp"
#include "tests/languages/source_texts.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"

namespace isograsp::languages::languages_test {
namespace {

using test::every;

std::map<std::string, std::string> words_of(const std::string& code) {
  const auto po = read_text(ISOGRASP_SOURCE_DIR "/languages/" + code + ".po");
  EXPECT_TRUE(po.ok());
  const auto all = read_translations(po ? *po : std::string());
  EXPECT_TRUE(all.ok()) << all.error().message();
  std::map<std::string, std::string> words;
  if (all)
    for (const auto& entry : *all) {
      EXPECT_TRUE(words.emplace(entry.english, entry.words).second)
          << code << ".po has twice: " << entry.english;
    }
  return words;
}

/// The places of a text, blanks at its ends and its first bracket or comma: what has to stay.
std::string kept(std::string_view text) {
  std::set<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i) places.insert(text_detail::place_at(text, i));
  places.erase(0);
  std::string marks;
  for (const auto place : places) marks += "%" + std::to_string(place);
  if (text.starts_with(' ')) marks = " " + marks;
  return text.ends_with(' ') ? marks + " " : marks;
}

class EachLanguage : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(, EachLanguage, ::testing::ValuesIn(test::translated_languages()),
                         test::code_of_language);

TEST_P(EachLanguage, SaysEveryTextOfTheSourcesTheLibraryAndTheSystem) {
  const auto words = words_of(GetParam());
  for (const auto& text : every(all_texts(ISOGRASP_SOURCE_DIR))) {
    const auto found = words.find(text);
    EXPECT_TRUE(found != words.end() && !found->second.empty())
        << text << " (run scripts/translations and give it its words)";
  }
}

TEST_P(EachLanguage, HasNoWordsForWhatNobodySays) {
  const auto texts = all_texts(ISOGRASP_SOURCE_DIR);
  for (const auto& [english, words] : every(words_of(GetParam())))
    EXPECT_TRUE(texts.contains(english)) << english << " (scripts/translations takes it away)";
}

TEST_P(EachLanguage, KeepsPlacesAndBlanks) {
  for (const auto& [english, words] : every(words_of(GetParam())))
    EXPECT_EQ(kept(words), kept(english)) << english << " = " << words;
}

TEST_P(EachLanguage, IsInTheProgramAsInItsFile) {
  const auto words = words_of(GetParam());
  for (const auto& [english, expected] : every(words))
    EXPECT_EQ(language(GetParam()).words(english), expected.empty() ? english : expected);
}

TEST(Languages, WriteNumbersAndDaysTheirWayAndNamesAsTheyAre) {
  const Date day{std::chrono::year{2026}, std::chrono::month{3}, std::chrono::day{5}};
  const Text text = "%1 of %2, %3"_text(fixed(1.25, 2), std::string("a 1.5.csv"), day);
  EXPECT_EQ(translated(text, language("en")), "1.25 of a 1.5.csv, 2026-03-05");
  EXPECT_EQ(translated(text, language("de")), "1,25 of a 1.5.csv, 05.03.2026");
  EXPECT_EQ(translated(text, language("fr")), "1,25 of a 1.5.csv, 05/03/2026");
}

/// What stands between `before` and `after` in the names of files of a folder.
std::set<std::string> codes_in(const std::string& folder, std::string_view before,
                               std::string_view after) {
  std::set<std::string> codes;
  for (const auto& entry : std::filesystem::directory_iterator(ISOGRASP_SOURCE_DIR + folder)) {
    const std::string name = entry.path().filename();
    if (name.starts_with(before) && name.ends_with(after))
      codes.insert(name.substr(before.size(), name.size() - before.size() - after.size()));
  }
  return codes;
}

TEST(Languages, AreThoseThatHaveFiles) {
  std::set<std::string> codes;
  for (const char* code : test::every_language()) codes.insert(code);
  EXPECT_EQ(codes_in("/gui/translations", "isograsp_", ".ts"), codes);
  codes.erase("en");
  EXPECT_EQ(codes_in("/languages", "", ".po"), codes);
}

TEST(Languages, AnotherCodeIsEnglish) {
  EXPECT_FALSE(is_language("tlh"));
  EXPECT_EQ(language("tlh").words("Pause"), "Pause");
  EXPECT_EQ(language("tlh").number("1.5"), "1.5");
}

/// Sets what the desktop says for as long as it lives.
class Desktop {
 public:
  Desktop(const char* locale, const char* wishes) {
    for (const auto& [name, value] : std::map<std::string, const char*>{
             {"LC_ALL", nullptr}, {"LC_MESSAGES", nullptr}, {"LANG", locale}, {"LANGUAGE", wishes}})
      change(name, value);
  }
  ~Desktop() {
    for (const auto& [name, value] : before_) set(name, value ? value->c_str() : nullptr);
  }
  Desktop(const Desktop&) = delete;
  Desktop& operator=(const Desktop&) = delete;

 private:
  static void set(const std::string& name, const char* value) {
    if (value == nullptr)
      unsetenv(name.c_str());
    else
      setenv(name.c_str(), value, 1);
  }
  void change(const std::string& name, const char* value) {
    const char* now = std::getenv(name.c_str());
    before_[name] = now == nullptr ? std::nullopt : std::optional<std::string>(now);
    set(name, value);
  }
  std::map<std::string, std::optional<std::string>> before_;
};

TEST(Languages, TheDesktopsIsTheFirstOfItsWishesThatIsThere) {
  const auto on = [](const char* locale, const char* wishes) {
    const Desktop desktop(locale, wishes);
    return desktop_language();
  };
  EXPECT_EQ(on("de_CH.UTF-8", nullptr), "de");
  EXPECT_EQ(on("fr", nullptr), "fr");
  EXPECT_EQ(on("tlh_CH.UTF-8", "rm:fr_CH:de"), "fr");
  EXPECT_EQ(on("tlh_CH.UTF-8", nullptr), "en");
  EXPECT_EQ(on("C", "de"), "en") << "a program that asks for the C locale gets English";
  EXPECT_EQ(on(nullptr, nullptr), "en");
}

TEST(Translations, AreReadAcrossLinesWithTheirEscapes) {
  const auto all = read_translations(
      "# a head\nmsgid \"\"\nmsgstr \"Language: de\\n\"\n\nmsgid \"a \\\"b\\\"\"\nmsgstr \"\"\n"
      "\"c\\\\\"\n\"\\nd\"\n");
  ASSERT_TRUE(all.ok());
  ASSERT_EQ(all->size(), 1U);
  EXPECT_EQ(all->front().english, "a \"b\"");
  EXPECT_EQ(all->front().words, "c\\\nd");
}

TEST(Translations, WhatIsNoLineOfAFileIsRefusedWithItsNumber) {
  for (const std::string& line :
       every(std::vector<std::string>{"msgid \"a", "msgid a", "msgstr \"a\"", "\"a\"",
                                      "msgid \"a\\q\"", "msgid \"a\"b\"", "words"})) {
    const auto all = read_translations("# a\n" + line + "\n");
    ASSERT_FALSE(all.ok()) << line;
    EXPECT_EQ(all.error().line, 2) << line;
  }
}

TEST(TextsInCode, AreTheLiteralsBeforeTheSuffixAsTheCompilerJoinsThem) {
  const std::set<std::string> expected{"one two", "a \"b\"", "%1 of %2", "1\u00a0N \u2013"};
  EXPECT_EQ(
      texts_in_code("f(\"one \"\n  // \"no\"_text\n  \"two\"_text, \"x\", '\"', 1'000);\n"
                    "\"y\" + \"a \\\"b\\\"\"_text; R\"(\"z\"_text)\"; \"%1 of %2\"_text(1, \"w\"); "
                    "\"1\\u00a0N \\u2013\"_text"),
      expected);
}

}  // namespace
}  // namespace isograsp::languages::languages_test
