// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text.hpp"

#include <concepts>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

namespace isograsp::text_test {
namespace {

static_assert(std::convertible_to<Words, Text>);
static_assert(!std::constructible_from<Text, std::string>, "composed words are no text");
static_assert(!std::constructible_from<Text, const char*>);
static_assert(!std::constructible_from<Text, Phrase<1>>, "a place without its value");
static_assert(std::invocable<Phrase<2>, int, std::string>);
static_assert(!std::invocable<Phrase<2>, int>, "a place without its value");
static_assert(!std::invocable<Phrase<1>, double>, "how many digits has it?");
static_assert(!std::invocable<Phrase<1>, bool>);
static_assert(std::is_trivially_copyable_v<Words>, "may be handed from thread to thread");

/// Says what it is asked for in capitals, with a comma in its numbers.
class Capitals : public Language {
 public:
  [[nodiscard]] std::string_view words(std::string_view english) const override {
    if (english == "drifts by %1 N, limit %2") return "LIMIT %2, DRIFT %1 N";
    if (english == "none") return "NONE";
    if (english == "Sine") return "SINE";
    return english;
  }
  [[nodiscard]] std::string number(std::string_view digits) const override {
    std::string written(digits);
    if (const auto point = written.find('.'); point != std::string::npos) written[point] = ',';
    return written;
  }
  [[nodiscard]] std::string day(Date date) const override {
    return std::to_string(static_cast<int>(date.year()));
  }
};

constexpr Date kDay{std::chrono::year{2026}, std::chrono::month{3}, std::chrono::day{5}};

TEST(Text, PutsItsValuesWhereTheLanguageHasTheirPlaces) {
  const Text text = "drifts by %1 N, limit %2"_text(fixed(0.5, 2), "none"_text);
  EXPECT_EQ(english(text), "drifts by 0.50 N, limit none");
  EXPECT_EQ(translated(text, Capitals()), "LIMIT NONE, DRIFT 0,50 N");
}

TEST(Text, NamesStayAsTheyAreAndKnownWordsAreLookedUpAsAWhole) {
  const Text text = "%1 %2 %3"_text("none", Known{"Sine"}, Known{"None"});
  EXPECT_EQ(translated(text, Capitals()), "none SINE None");
  EXPECT_EQ(translated(Known{"Sine"}, Capitals()), "SINE");
}

TEST(Text, ValuesAreNeverTakenForPlaces) {
  EXPECT_EQ(english("%1 and %2"_text("%2", "%1")), "%2 and %1");
  EXPECT_EQ(english(Known{"100%1"}), "100%1");
}

TEST(Text, APercentSignBeforeNoPlaceOrTwoDigitsIsItself) {
  static_assert(std::same_as<decltype("63 % of 100%, %25, %0"_text), Words>);
  EXPECT_EQ(english("63 % of 100%, %25, %0"_text), "63 % of 100%, %25, %0");
}

TEST(Text, NumbersHaveTheDigitsThatTheyWereGiven) {
  EXPECT_EQ(english("%1 %2 %3 %4"_text(7, std::size_t{8}, shortest(0.1), fixed(-2.0, 1))),
            "7 8 0.1 -2.0");
}

TEST(Text, DaysFollowTheLanguage) {
  EXPECT_EQ(english("until %1"_text(kDay)), "until 2026-03-05");
  EXPECT_EQ(translated("until %1"_text(kDay), Capitals()), "until 2026");
}

TEST(Text, JoinedLeavesOutWhatSaysNothing) {
  EXPECT_EQ(english(joined({"a"_text, Text(), "b"_text, "c"_text})), "a b c");
  EXPECT_EQ(english(joined({"a"_text, "b"_text}, ", "_text)), "a, b");
  EXPECT_TRUE(joined({}).empty());
  EXPECT_TRUE(Text(Known{}).empty());
}

TEST(Text, NamesOfAFileCanBeCutOffWithoutTheWords) {
  const Text text = "'%1' of %2"_text("a\u00e4b", "%1 to %2"_text(1, "abcd"));
  EXPECT_EQ(english(text.with_names_up_to(2)), "'a…' of 1 to ab…") << "not within a character";
  EXPECT_EQ(text.with_names_up_to(4), text);
  EXPECT_EQ(shortened("abc", 3), "abc");
}

TEST(Text, IsEqualWithTheSameWordsAndValues) {
  EXPECT_EQ("holds %1"_text(3), "holds %1"_text(3));
  EXPECT_NE("holds %1"_text(3), "holds %1"_text("3"));
  EXPECT_NE("holds %1"_text(3), "has %1"_text(3));
}

}  // namespace
}  // namespace isograsp::text_test
