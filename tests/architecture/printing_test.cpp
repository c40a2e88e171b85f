// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the sources: who may write on the terminal.
#include <string>

#include <gtest/gtest.h>

#include "tests/architecture/house.hpp"
#include "tests/support/every.hpp"

namespace isograsp::printing_test {
namespace {

using namespace architecture;

/// What stands in files reaches the terminal through app/console only, where control characters are
/// written out.
TEST(Printing, OnlyTheConsoleWritesOnTheTerminal) {
  int files = 0;
  for (const Source& source : test::every(all_sources())) {
    if (source.folder == "gui" || source.file.starts_with("app/console.")) continue;
    ++files;
    int number = 0;
    for (const std::string& line : test::every(source.lines)) {
      ++number;
      for (const char* way : {"std::printf", "std::fprintf", "std::puts", "std::fputs",
                              "std::putchar", "std::cout", "std::cerr", "std::clog", " printf("})
        EXPECT_EQ(line.find(way), std::string::npos)
            << source.file << ":" << number << ": use app/console.hpp, not " << way;
    }
  }
  EXPECT_GT(files, 300);
}

}  // namespace
}  // namespace isograsp::printing_test
