// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: one full name stands for one class. Two that share a name compile and link,
// and the program then runs the functions of one on objects of the other.
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::names_test {
namespace {

using namespace architecture;

/// Full names of the classes and enumerations that a file defines where others could define them,
/// too: in namespaces that have a name.
std::vector<std::string> defined_in(const std::string& text) {
  static const std::regex kNamespace(R"(\bnamespace(?:\s+([\w:]+))?\s*$)");
  static const std::regex kType(
      R"((?:^|[;}>\s])(?:class|struct|union|enum(?:\s+class|\s+struct)?)(?:\s*\[\[[^\]]*\]\])*)"
      R"((?:\s+alignas\([^)]*\))?\s+([\w:]+)(?:\s+final)?(?:\s*:[^;(]*)?\s*$)");
  const std::string code = code_of(text);
  std::vector<std::string> names;
  std::vector<std::string> open;  ///< the name of each open namespace; else nothing to look into
  constexpr const char* kClosed = "-";
  std::size_t begin = 0;  ///< of the words before the next brace
  for (std::size_t at = 0; at < code.size(); ++at) {
    if (code[at] == ';') begin = at + 1;
    if (code[at] != '{' && code[at] != '}') continue;
    const std::string words = code.substr(begin, at - begin);
    begin = at + 1;
    if (code[at] == '}') {
      if (!open.empty()) open.pop_back();
      continue;
    }
    std::smatch match;
    if (std::regex_search(words, match, kNamespace)) {
      open.push_back(match[1].matched ? match[1].str() : kClosed);
      continue;
    }
    std::string scope;
    bool visible = true;
    for (const auto& name : open) {
      visible = visible && name != kClosed;
      scope += name + "::";
    }
    if (visible && std::regex_search(words, match, kType)) names.push_back(scope + match[1].str());
    open.emplace_back(kClosed);
  }
  return names;
}

using Files = std::set<std::string>;

TEST(Names, NoTwoFilesDefineOneFullName) {
  std::map<std::string, Files> defined;
  for (const Source& source : all_sources())
    for (const auto& name : defined_in(source.text())) defined[name].insert(source.file);
  constexpr std::size_t kFewest = 500;  // the house has more; fewer: the sources were not read
  EXPECT_GT(defined.size(), kFewest);
  EXPECT_TRUE(defined.contains("isograsp::gui::TherapistWindow"));
  for (const auto& [name, files] : test::every(defined)) {
    std::string where;
    for (const auto& file : files) where += "\n  " + file;
    EXPECT_EQ(files.size(), 1U) << name << " is defined in" << where;
  }
}

TEST(Names, StandInTheNamespaceOfTheirFolderAndThoseThatAreInstalledInOne) {
  const Names installed{"core", "hand", "kinematics", "device", "grasp_model"};
  test::AtLeast names(500);
  for (const Source& source : test::every(all_sources())) {
    std::string own = "isograsp::";
    if (!installed.contains(source.folder)) own += source.folder + "::";
    for (const auto& name : defined_in(source.text())) {
      EXPECT_TRUE(name.starts_with(own)) << source.file << " defines " << name;
      ++names;
    }
  }
}

/// What a .cpp file defines for itself alone: names of constants and classes, heads of functions.
std::vector<std::string> hidden_in(const Source& source) {
  static const std::regex kConstant(
      R"(^(?:constexpr|const|static) .*?\b(k[A-Z]\w*)(?:\[\w*\])?(?: =|\{).*)");
  static const std::regex kClass(R"(^(?:class|struct|enum class) (\w+)\b.*\{.*)");
  static const std::regex kFunction(R"(^([a-z][\w:<>,&* ]* \w+\([^;]*\).*\{).*)");
  std::vector<std::string> names;
  bool hidden = false;
  for (const std::string& line : source.lines) {
    if (line == "namespace {") hidden = true;
    if (line == "}  // namespace") hidden = false;
    std::smatch match;
    for (const auto* const pattern : {&kConstant, &kClass, &kFunction})
      if (hidden && std::regex_match(line, match, *pattern)) {
        names.push_back(match[1].str());
        break;
      }
  }
  return names;
}

TEST(Names, OfOneFolderAreHiddenOnceSoThatItsFilesCompileTogetherInAnyBatch) {
  std::map<std::string, Files> defined;  // "tasks kNoForce"
  for (const Source& source : all_sources())
    if (!source.is_header())
      for (const auto& name : hidden_in(source))
        defined[source.folder + " " + name].insert(source.file);
  constexpr std::size_t kFewest = 2000;  // the house has more; fewer: the sources were not read
  EXPECT_GT(defined.size(), kFewest);
  for (const auto& [name, files] : test::every(defined)) {
    std::string where;
    for (const auto& file : files) where += "\n  " + file;
    EXPECT_EQ(files.size(), 1U) << name << " is hidden in" << where;
  }
}

TEST(Names, ThatAreHiddenAreConstantsClassesAndHeadsOfFunctions) {
  Source source;
  source.lines = {"constexpr int kSeen = 1;",
                  "namespace {",
                  "constexpr double kLength_m = 0.1;",
                  "const char* const kWords[] = {",
                  "constexpr std::array<int, 2> kPair{1, 2};",
                  "class Reader final : public Base {",
                  "struct Declared;",
                  "template <class Sink>",
                  "void put_place(Sink& sink, const Vec3& p) {",
                  "  constexpr int kLocal = 2;",
                  "double declared(double x);",
                  "}  // namespace",
                  "void Reader::read(int row) {"};
  const std::vector<std::string> expected{"kLength_m", "kWords", "kPair", "Reader",
                                          "void put_place(Sink& sink, const Vec3& p) {"};
  EXPECT_EQ(hidden_in(source), expected);
}

TEST(Names, OfClassesStructsAndEnumerationsAreFoundWhereOthersCouldDefineThem) {
  const std::vector<std::string> expected{"a::One", "a::Two", "a::b::Three", "a::Four", "a::Five"};
  EXPECT_EQ(
      defined_in("namespace a {\n"
                 "class One final : public Base { struct Inner { int x; }; };\n"
                 "template <class T>\nstruct [[nodiscard]] Two { void f() { struct L {}; } };\n"
                 "struct Declared;\n"
                 "namespace {\nstruct Hidden {};\n}\n"
                 "namespace b {\nenum class Three : int { x };\n}\n"
                 "// struct Comment {\nconst char* text = \"struct Text {\";\n"
                 "struct alignas(16) Four {};\n"
                 "void g(struct Parameter* p) { if (p) { } }\n"
                 "union Five { int i; };\n}\n"),
      expected);
}

}  // namespace
}  // namespace isograsp::names_test
