// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: a column of a trial is named by its constant, so that a renamed column does
// not compile where it is read.
#include <string>

#include <gtest/gtest.h>

#include "hand/columns.hpp"
#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::column_test {
namespace {

using namespace architecture;

/// What a line says between quotes.
std::vector<std::string> quoted(const std::string& line) {
  std::vector<std::string> all;
  for (std::size_t begin = line.find('"'); begin != std::string::npos;) {
    const std::size_t end = line.find('"', begin + 1);
    if (end == std::string::npos) break;
    all.push_back(line.substr(begin + 1, end - begin - 1));
    begin = line.find('"', end + 1);
  }
  return all;
}

/// Measures, answers and facts of a trial are called like columns, too: those without a unit, and
/// all in the files that write such facts; sessions have a delay of the device, too. Traits of
/// simulated people and the axes of foreign files, too.
TEST(Columns, NobodyReadsOneByASpelledName) {
  test::AtLeast lines(40000);
  for (const Source& source : test::every(all_sources())) {
    if (source.file == "core/column.hpp" || source.file == "hand/columns.hpp" ||
        source.file == "hand/hand_columns.hpp" || source.file == "hand/two_hands_columns.hpp" ||
        source.file == "exports/export_facts.cpp" || source.file == "app/db/person_export.cpp" ||
        source.folder == "virtual_patient" || source.folder == "device")
      continue;
    int number = 0;
    for (const std::string& line : test::every(source.lines)) {
      ++number;
      ++lines;
      if (line.find("//") != std::string::npos) continue;
      for (const std::string& word : quoted(line)) {
        const bool spelled = columns::find(word) != nullptr && !unit_of(word).empty() &&
                             word != columns::t_s && word != columns::display_delay_s &&
                             word != columns::device_delay_s;
        EXPECT_FALSE(spelled) << source.file << ":" << number << ": name the constant of \"" << word
                              << "\" (hand/columns.hpp)";
      }
    }
  }
  // The look itself finds one.
  ASSERT_EQ(quoted(R"(column("thumb_fz_N") + "x")"), (std::vector<std::string>{"thumb_fz_N", "x"}));
  EXPECT_NE(columns::find("thumb_fz_N"), nullptr);
}

}  // namespace
}  // namespace isograsp::column_test
