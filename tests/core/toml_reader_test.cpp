// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toml_reader.hpp"

#include <gtest/gtest.h>

namespace isograsp::toml_reader_test {
namespace {

constexpr const char* kFormat = "example-1";

/// Reads number a, optional text b, table c with vector v, list d of {n}.
Result<void> read_example(const std::string& text) {
  auto root = TomlReader::parse("format = \"example-1\"\n" + text, "x.toml", kFormat);
  if (!root) return root.error();
  root->number("a");
  root->text("b", "none");
  auto c = root->table("c", false);
  if (root->has("c")) c.vec3("v");
  for (auto& d : root->tables("d")) d.integer("n");
  return root->finish();
}

TEST(TomlReader, AcceptsWhatTheGettersAskFor) {
  const auto done =
      read_example("a = 1\nb = \"t\"\n[c]\nv = [1, 2.5, 3]\n[[d]]\nn = 1\n[[d]]\nn = 2\n");
  EXPECT_TRUE(done) << done.error().message();
}

TEST(TomlReader, ReadsOneTextOrSeveralAndListsOfPoints) {
  auto root = TomlReader::parse(
      "format = \"f\"\none = \"a\"\nmany = [\"a\", \"b\"]\npoints = [[1, 2, 3], [4.5, 5, 6]]\n",
      "p.toml", "f");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->text_or_texts("one"), std::vector<std::string>{"a"});
  EXPECT_EQ(root->text_or_texts("many"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(root->vec3s("points"), (std::vector<Vec3>{{1, 2, 3}, {4.5, 5, 6}}));
  EXPECT_TRUE(root->finish());
  for (const char* bad : {"[[1, 2]]", "[1, 2, 3]", "[[1, 2, \"x\"]]", "[[1, 2, nan]]", "1"}) {
    auto wrong = TomlReader::parse("format = \"f\"\npoints = " + std::string(bad), "p.toml", "f");
    ASSERT_TRUE(wrong);
    static_cast<void>(wrong->vec3s("points"));
    ASSERT_FALSE(wrong->finish()) << bad;
    EXPECT_NE(wrong->finish().error().message().find("p.toml:2: points:"), std::string::npos)
        << bad;
  }
}

TEST(TomlReader, TellsTheKeysOfATableWhoseNamesTheFileGives) {
  auto root = TomlReader::parse("format = \"f\"\n[names]\n\"left hand.1\" = \"A\"\nB = \"C\"\n",
                                "n.toml", "f");
  ASSERT_TRUE(root);
  auto names = root->table("names");
  EXPECT_EQ(names.keys(), (std::vector<std::string>{"B", "left hand.1"}));
  EXPECT_EQ(names.text("left hand.1"), "A");
  EXPECT_FALSE(root->finish()) << "B was not asked for";
  EXPECT_TRUE(root->table("absent", false).keys().empty());
}

TEST(TomlReader, NamesFileLineFieldAndRemedyOfTheFirstProblem) {
  const std::pair<const char*, const char*> bad[] = {
      {"", "x.toml:1: a: is missing; add it"},
      {"a = \"1\"\n", "x.toml:2: a: is text, not a finite number; write a number"},
      {"a = nan\n", "x.toml:2: a: is a number, not a finite number; write a number"},
      {"a = 1\nz = 2\n", "x.toml:3: z: unknown key; remove it or correct its spelling"},
      {"a = 1\n[c]\nv = [1, 2]\n",
       "x.toml:4: c.v: is 2 values, not an array of 3 numbers; write 3 numbers in brackets"},
      {"a = 1\n[c]\nv = [1, 2, 3]\nw = 1\n",
       "x.toml:5: c.w: unknown key; remove it or correct its spelling"},
      {"a = 1\n[[d]]\nn = 1\n[[d]]\nn = 1.5\n",
       "x.toml:6: d[2].n: is a number, not an integer; write a whole number"},
      {"a = \n", "x.toml:2: not valid TOML"},
  };
  for (const auto& [text, message] : bad) {
    const auto done = read_example(text);
    ASSERT_FALSE(done) << text;
    EXPECT_EQ(done.error().message().rfind(message, 0), 0u) << done.error().message();
  }
}

TEST(TomlReader, AHeaderWithoutAKeyIsAnError) {
  for (const char* text : {"a = 1\n[ = 2]\n", "a = 1\n[[ = 2]]\n", "a = 1\n[   \"\" ]\n[#]\n"}) {
    const auto done = read_example(text);
    ASSERT_FALSE(done) << text;
    EXPECT_NE(english(done.error().what).find("not valid TOML"), std::string::npos) << text;
  }
}

TEST(TomlReader, LettersBeyondAsciiOutsideOfTextAreErrors) {
  for (const char* letter : {"\xC3\xA4", "\xD1\x87", "\xEF\xB3\xBF", "\xE2\x82\xAC"})
    for (const std::string before : {"", "a = 1", "a", "a = [1 "}) {
      const auto done = read_example(before + letter + " = 2\n");
      ASSERT_FALSE(done) << before << letter;
      EXPECT_NE(english(done.error().what).find("not valid TOML"), std::string::npos)
          << before << letter;
    }
}

TEST(TomlReader, AnotherFormatIsRefused) {
  const auto read = TomlReader::parse("format = \"other-1\"\n", "x.toml", kFormat);
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message().find("'other-1' is not the expected format"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::toml_reader_test
