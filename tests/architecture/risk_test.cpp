// SPDX-License-Identifier: GPL-3.0-or-later
// Reads docs/risk.md: a proof that does not exist proves nothing.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"

namespace isograsp::risk_test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::set<std::string> matches(const std::string& text, const char* pattern, const char* format) {
  std::set<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
    found.insert(match->format(format));
  return found;
}

TEST(Risk, EveryProofThatIsNamedIsATest) {
  std::set<std::string> tests;
  for (const auto& file : fs::recursive_directory_iterator(ISOGRASP_SOURCE_DIR "/tests"))
    if (file.path().extension() == ".cpp")
      tests.merge(matches(content_of(file.path()),
                          R"re(\nTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))re", "$1.$2"));
  const auto risk = content_of(ISOGRASP_SOURCE_DIR "/docs/risk.md");
  const auto proofs = matches(risk, R"(`([A-Z]\w+\.[A-Z]\w+)`)", "$1");
  EXPECT_GT(proofs.size(), 60U);
  for (const auto& proof : test::every(proofs)) EXPECT_TRUE(tests.contains(proof)) << proof;
}

TEST(Risk, EveryHazardHasAProofOrIsLeftToTheClinicInWords) {
  std::istringstream lines(content_of(ISOGRASP_SOURCE_DIR "/docs/risk.md"));
  int hazards = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_search(line, std::regex(R"(^\| [WNPD]\d+ \|)"))) continue;
    ++hazards;
    const bool proved = std::regex_search(line, std::regex(R"(`[A-Z]\w+\.[A-Z]\w+` \|$)"));
    EXPECT_TRUE(proved || line.find("**clinic**") != std::string::npos) << line;
  }
  EXPECT_GT(hazards, 30);
}

}  // namespace
}  // namespace isograsp::risk_test
