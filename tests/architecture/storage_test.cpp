// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: a session of any kind can be stored, because storage knows no finger.
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage_test {
namespace {

using namespace architecture;

bool names_a_finger(const std::string& line) {
  static const std::regex kFinger(R"(thumb|middle|index_threshold|kFinger|\bFinger\b)");
  return !line.starts_with("#include") && std::regex_search(line, kFinger);
}

/// Files of the formats 1 to 7 are about a platform of three fingers.
TEST(Storage, NamesNoFingerButInOldFormats) {
  test::AtLeast lines(8000);
  for (const Source& source : test::every(all_sources())) {
    if (source.folder != "storage" || source.file == "storage/file/old_formats.cpp") continue;
    int number = 0;
    for (const std::string& line : test::every(source.lines)) {
      ++lines;
      ++number;
      EXPECT_FALSE(names_a_finger(line)) << source.file << ":" << number << ": " << line;
    }
  }
  EXPECT_TRUE(names_a_finger("double thumb_threshold_N;"));
  EXPECT_TRUE(names_a_finger("std::array<double, kFingerCount> all;"));
  EXPECT_FALSE(names_a_finger("CREATE INDEX events_of_session ON events (session_id)"));
}

}  // namespace
}  // namespace isograsp::storage_test
