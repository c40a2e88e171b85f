// SPDX-License-Identifier: GPL-3.0-or-later
// docs/measures.md against the program: every measure has its section, of its version and class,
// and nothing is described that no task gives.
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "core/files.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tests/reports/emitted_measures.hpp"
#include "tests/support/every.hpp"

namespace isograsp::reports::measure_docs_test {
namespace {

using test::Emitted;
using test::emitted;
using test::own_name;

struct Documented {
  int version = 0;
  bool clinical = false;
  bool censored = false;
};

std::string text_of_docs() {
  const auto text = read_text(std::filesystem::path(ISOGRASP_SOURCE_DIR) / "docs" / "measures.md");
  EXPECT_TRUE(text);
  return text ? *text : "";
}

std::vector<std::string> split(const std::string& text, const std::string& at) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + at.size()) {
    end = text.find(at, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) break;
  }
  return parts;
}

/// Sections: "### name, other [unit] · version 1 · clinical · unit, censored".
std::map<std::string, Documented> sections() {
  std::map<std::string, Documented> found;
  std::istringstream lines(text_of_docs());
  for (std::string line; std::getline(lines, line);) {
    const std::string kHeading = "### ";
    if (!line.starts_with(kHeading)) continue;
    const auto parts = split(line.substr(kHeading.size()), " · ");
    if (parts.size() < 3) {
      ADD_FAILURE() << line;
      continue;
    }
    Documented section;
    EXPECT_TRUE(parts[1].starts_with("version ")) << line;
    section.version = std::atoi(parts[1].substr(std::string("version ").size()).c_str());
    EXPECT_TRUE(parts[2] == "clinical" || parts[2] == "research") << line;
    section.clinical = parts[2] == "clinical";
    section.censored = line.ends_with("censored");
    for (const std::string& name : test::every(split(parts[0], ", ")))
      EXPECT_TRUE(found.emplace(name.substr(0, name.find(" [")), section).second)
          << name << " has two sections";
  }
  return found;
}

/// The name whose section tells of this one: times after a cue have two companions.
std::string section_name(const std::string& name) {
  for (const std::string suffix : {"_share", "_restricted"})
    if (name.ends_with(suffix)) return name.substr(0, name.size() - suffix.size());
  return name;
}

std::vector<Measure> all_measures() {
  std::vector<Measure> all = tasks::score_pairs(
      Signals({"t_s", "target_force_N", "actual_force_N", "actual_x_m", "actual_y_m"}));
  const auto of_two_hands = tasks::score_two_hands(
      Signals({"t_s", "left_force_N", "right_force_N", "left_push_x_N", "left_push_y_N",
               "left_push_z_N", "right_push_x_N", "right_push_y_N", "right_push_z_N"}),
      {});
  all.insert(all.end(), of_two_hands.begin(), of_two_hands.end());
  for (const Emitted& task : emitted())
    all.insert(all.end(), task.measures.begin(), task.measures.end());
  return all;
}

TEST(MeasureDocs, EveryMeasureHasASectionOfItsVersionAndClass) {
  const auto documented = sections();
  for (const Measure& measure : test::every(all_measures())) {
    auto section = documented.find(measure.name);
    if (section == documented.end()) section = documented.find(section_name(measure.name));
    if (section == documented.end()) {
      ADD_FAILURE() << measure.name << " has no section";
      continue;
    }
    EXPECT_EQ(section->second.version, measure.version) << measure.name;
    EXPECT_EQ(section->second.clinical, tasks::words_of(measure.name, "").clinical) << measure.name;
    EXPECT_TRUE(section->first == measure.name || section->second.censored) << measure.name;
  }
}

TEST(MeasureDocs, EverySectionIsAboutAMeasureThatSomeTaskGives) {
  std::set<std::string> given;
  for (const Measure& measure : all_measures()) given.insert(measure.name);
  for (const auto& [name, section] : test::every(sections())) {
    EXPECT_TRUE(given.contains(name)) << name;
    EXPECT_NE(english(tasks::words_of(name, "").title), own_name(name)) << name << " has no words";
  }
}

TEST(MeasureDocs, TheTableNamesEveryMeasureOfATask) {
  const std::string text = text_of_docs();
  const std::set<std::string> below_the_table{"net_push", "net_push_time", "force_of_maximum"};
  for (const Emitted& task : test::every(emitted())) {
    const std::string kind(task.spec.kind->name);
    const auto begin = text.find("\n| " + kind + " |");
    ASSERT_NE(begin, std::string::npos) << kind;
    const std::string row = text.substr(begin, text.find('\n', begin + 1) - begin);
    std::istringstream words(row);
    std::set<std::string> named;
    for (std::string word; words >> word;)
      named.insert(word.substr(0, word.find_last_not_of(".,;:") + 1));
    for (const Measure& measure : test::every(task.measures))
      EXPECT_TRUE(below_the_table.contains(measure.name) || named.contains(measure.name) ||
                  named.contains(section_name(measure.name)))
          << measure.name << " of " << kind;
  }
}

}  // namespace
}  // namespace isograsp::reports::measure_docs_test
