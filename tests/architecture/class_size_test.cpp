// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the headers: a class with many public functions is several classes, unless it is a table.
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"

namespace isograsp::class_size_test {
namespace {

using namespace architecture;

/// Of one class; more than that cannot be seen at a glance.
constexpr int kMostFunctions = 25;

/// Those that may have more, each with its reason.
const std::map<std::string, std::string>& larger_ones() {
  static const std::map<std::string, std::string> kLarger{
      {"SessionStore", "a table: the acts on records, two lines each"},
      {"ForwardingStore", "the same table"},
      {"SqliteStore", "the same table"},
      {"GuardedStore", "the same table, as far as rights matter"}};
  return kLarger;
}

struct Class {
  std::string name;
  int functions = 0;  ///< public ones; signals, defaulted and deleted ones do not count
};

/// Takes access labels from the front of a declaration; what they say is left in `is_public`.
std::string without_labels(std::string words, bool& is_public) {
  static const std::regex kLabel(
      R"(^\s*(?:Q_OBJECT\s*)?(public|protected|private|Q_SIGNALS)\s*:(?!:))");
  std::smatch label;
  while (std::regex_search(words, label, kLabel)) {
    is_public = label[1] == "public";
    words = label.suffix();
  }
  return words;
}

bool is_function(std::string words) {
  static const std::regex kAngles(R"(<[^<>]*>)");
  static const std::regex kNone(
      R"(^\s*(?:using|friend|static_assert)\b|=\s*(?:default|delete)\s*$)");
  for (std::string before; before != words;) {
    before = words;
    words = std::regex_replace(words, kAngles, "");
  }
  return words.find('(') != std::string::npos && !std::regex_search(words, kNone);
}

/// The classes that a header defines, nested ones too.
std::vector<Class> classes_in(const std::string& text) {
  static const std::regex kClass(
      R"((?:^|[;}>\s])(class|struct)(?:\s*\[\[[^\]]*\]\])*(?:\s+alignas\([^)]*\))?\s+([\w:]+))"
      R"((?:\s+final)?(?:\s*:[^;(]*)?\s*$)");
  static const std::regex kEnum(R"(\benum\s+(?:class|struct)\b)");
  struct Open {
    bool is_class = false;
    bool is_public = false;
    Class counted;
  };
  const std::string code = code_of(text);
  std::vector<Class> classes;
  std::vector<Open> open;
  std::size_t begin = 0;  ///< of the words before the next brace or semicolon
  for (std::size_t at = 0; at < code.size(); ++at) {
    if (code[at] != ';' && code[at] != '{' && code[at] != '}') continue;
    std::string words = code.substr(begin, at - begin);
    begin = at + 1;
    const bool member = !open.empty() && open.back().is_class;
    if (member) words = without_labels(words, open.back().is_public);
    std::smatch match;
    const bool is_class = code[at] == '{' && !std::regex_search(words, kEnum) &&
                          std::regex_search(words, match, kClass);
    if (member && !is_class && code[at] != '}' && open.back().is_public && is_function(words))
      ++open.back().counted.functions;
    if (code[at] == '{') {
      if (is_class)
        open.push_back({true, match[1] == "struct", {match[2].str(), 0}});
      else
        open.emplace_back();
    }
    if (code[at] == '}' && !open.empty()) {
      if (open.back().is_class) classes.push_back(open.back().counted);
      open.pop_back();
    }
  }
  return classes;
}

TEST(Classes, HaveAtMostTwentyFivePublicFunctionsUnlessTheyAreListedWithTheirReason) {
  std::map<std::string, int> larger;
  std::size_t read = 0;
  for (const Source& source : all_sources()) {
    if (!source.is_header()) continue;
    for (const Class& one : classes_in(source.text())) {
      ++read;
      if (one.functions <= kMostFunctions) continue;
      larger[one.name] = one.functions;
      EXPECT_TRUE(larger_ones().contains(one.name))
          << source.file << ": " << one.name << " has " << one.functions << " public functions";
    }
  }
  constexpr std::size_t kFewest = 300;  // the house has more; fewer: the headers were not read
  EXPECT_GT(read, kFewest);
  for (const auto& [name, reason] : larger_ones())
    EXPECT_TRUE(larger.contains(name)) << name << " is no longer large: take it from the list";
}

TEST(Classes, PublicFunctionsAreCountedWhereverTheyStand) {
  const auto found = classes_in(
      "class One final : public Base {\n  Q_OBJECT\n\n public:\n  One();  // f(\n"
      "  One(const One&) = delete;\n"
      "  int f() const { return g(1); }\n  std::function<void(int)> callback;\n"
      "  struct Inner { void h(); int x = 0; };\n"
      " Q_SIGNALS:\n  void told();\n public:\n  int y{0};\n  void i(int a);\n private:\n"
      "  void j();\n};\n"
      "struct Two { bool operator==(const Two&) const = default; void k(); };\n");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "Inner");
  EXPECT_EQ(found[0].functions, 1);
  EXPECT_EQ(found[1].name, "One");
  EXPECT_EQ(found[1].functions, 3);
  EXPECT_EQ(found[2].functions, 1);
}

}  // namespace
}  // namespace isograsp::class_size_test
