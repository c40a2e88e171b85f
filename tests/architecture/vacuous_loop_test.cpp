// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the tests: one whose assertions all stand in a loop over something computed proves nothing
// on the day when that is empty, unless the loop says every() or an AtLeast counts.
#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::vacuous_loop_test {
namespace {

using namespace architecture;

/// Where the bracket closes that opens at `open`; the end of the code if it does not.
std::size_t closing(const std::string& code, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < code.size(); ++at) {
    if (std::string("([{").find(code[at]) != std::string::npos) ++depth;
    if (std::string(")]}").find(code[at]) != std::string::npos && --depth == 0) return at;
  }
  return code.size();
}

/// The end of the statement that begins at `at`: its semicolon, or the brace that closes its block.
std::size_t end_of_statement(const std::string& code, std::size_t at) {
  for (; at < code.size() && code[at] != ';'; ++at) {
    const bool block = code[at] == '{';
    if (block || code[at] == '(' || code[at] == '[') at = closing(code, at);
    if (block) return at;
  }
  return at;
}

struct Loop {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string range;  ///< what it runs over

  [[nodiscard]] bool holds(std::size_t at) const { return begin < at && at < end; }
};

/// The loops over ranges of the body of a test, inner ones too.
std::vector<Loop> loops_of(const std::string& body) {
  static const std::regex kFor(R"(\bfor\s*\()");
  static const std::regex kRange(R"(^[^;]*?[^:]:(?!:)\s*([^]*?)\s*$)");
  std::vector<Loop> loops;
  for (std::sregex_iterator at(body.begin(), body.end(), kFor), end; at != end; ++at) {
    const auto begin = static_cast<std::size_t>(at->position());
    const std::size_t open = begin + at->str().size() - 1;
    const std::size_t close = closing(body, open);
    const std::string head = body.substr(open + 1, close - open - 1);
    std::smatch range;
    if (std::regex_search(head, range, kRange))
      loops.push_back({begin, end_of_statement(body, close + 1), range[1]});
  }
  return loops;
}

/// False for a list that is written out, here or in a constant, and for every().
bool may_be_empty(const std::string& range, const std::string& body) {
  static const std::regex kFull(R"(^(\{|(test::)?every\(|std::(to_)?array\b|(\w+::)*k[A-Z]\w*$))");
  static const std::regex kName(R"(^\w+$)");
  if (std::regex_search(range, kFull)) return false;
  if (!std::regex_match(range, kName)) return true;
  const std::regex made_of_a_list(
      "\\b" + range + R"((\[\w*\])?\s*(=\s*)?((test::)?every\(|std::array\b|\{\s*[^}\s]))");
  const std::regex made_an_array(R"(std::array[^;]*\b)" + range + "\\b");
  return !std::regex_search(body, made_of_a_list) && !std::regex_search(body, made_an_array);
}

/// What loops run over that may be empty, if all assertions of this body stand in such loops.
std::vector<std::string> unproven(const std::string& body) {
  static const std::regex kAssertion(R"(\b(EXPECT_|ASSERT_|FAIL|SUCCEED|expect_)\w*\s*\()");
  if (body.find("AtLeast") != std::string::npos) return {};
  std::vector<Loop> loops = loops_of(body);
  std::erase_if(loops, [&](const Loop& loop) { return !may_be_empty(loop.range, body); });
  std::vector<std::string> ranges;
  for (std::sregex_iterator at(body.begin(), body.end(), kAssertion), end; at != end; ++at) {
    const auto around = std::find_if(loops.begin(), loops.end(), [&](const Loop& loop) {
      return loop.holds(static_cast<std::size_t>(at->position()));
    });
    if (around == loops.end()) return {};
    ranges.push_back(around->range);
  }
  return ranges;
}

struct Body {
  std::string name;
  std::string code;
};

std::vector<Body> bodies_of(const std::string& text) {
  static const std::regex kTest(R"(\bTEST(?:_F|_P)?\s*\(([^)]*)\)\s*\{)");
  const std::string code = code_of(text);
  std::vector<Body> bodies;
  for (std::sregex_iterator at(code.begin(), code.end(), kTest), end; at != end; ++at) {
    const auto open = static_cast<std::size_t>(at->position()) + at->str().size() - 1;
    bodies.push_back({(*at)[1], code.substr(open + 1, closing(code, open) - open - 1)});
  }
  return bodies;
}

TEST(Loops, ThatHoldAllAssertionsOfATestFailIfTheyRunOverNothing) {
  test::AtLeast bodies(1500);  // there are more; fewer: the tests were not read
  for (const Source& source : test::every(all_tests()))
    for (const Body& body : bodies_of(source.text())) {
      ++bodies;
      for (const std::string& range : unproven(body.code))
        ADD_FAILURE() << source.file << ": " << body.name << " asserts only where " << range
                      << " is not empty: write test::every(" << range << "), or count with AtLeast";
    }
}

TEST(Loops, ThatProveNothingAreToldFromThoseThatProveSomething) {
  const auto found = [](const std::string& body) {
    return unproven(bodies_of("TEST(A, B) {" + body + "}").at(0).code);
  };
  using Ranges = std::vector<std::string>;
  EXPECT_EQ(found("for (const auto& x : read()) EXPECT_EQ(x, 1);"), Ranges{"read()"});
  EXPECT_EQ(found("for (const a::B& x : read()) { if (x.y) { EXPECT_EQ(x, 1); } }"),
            Ranges{"read()"});
  EXPECT_EQ(found("const auto all = f(); for (auto x : all) for (auto y : {1}) EXPECT_EQ(x, y);"),
            Ranges{"all"});
  EXPECT_EQ(found("for (auto x : {1}) for (auto y : x.parts) EXPECT_EQ(x, y);"), Ranges{"x.parts"});
  for (const char* proves :
       {"for (const auto& x : test::every(read())) EXPECT_EQ(x, 1);",
        "for (const auto& x : read()) EXPECT_EQ(x, 1); EXPECT_EQ(n, 3);",
        "for (const auto& x : read()) { n += x; } EXPECT_EQ(n, 3);",
        "for (const auto x : {1, 2}) EXPECT_EQ(x, 1);", "for (auto f : kFingers) EXPECT_EQ(f, 1);",
        "const std::vector<int> all{1, 2}; for (auto x : all) EXPECT_EQ(x, 1);",
        "const std::array all{1, 2}; for (auto x : all) EXPECT_EQ(x, 1);",
        "test::AtLeast n(1); for (auto x : read()) { EXPECT_EQ(x, 1); ++n; }",
        "for (int i = 0; i < 3; ++i) EXPECT_EQ(a::b(i), 1);", "run();"})
    EXPECT_EQ(found(proves), Ranges{}) << proves;
}

}  // namespace
}  // namespace isograsp::vacuous_loop_test
