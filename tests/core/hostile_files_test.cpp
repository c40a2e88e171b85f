// SPDX-License-Identifier: GPL-3.0-or-later
// Files that were made to stop the program: refused in plain words, in little memory.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::hostile_files_test {
namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

std::string refusal_of(const std::string& toml) {
  const auto read =
      TomlReader::parse("format = \"isograsp-scene-1\"\n" + toml, "bomb.toml", "isograsp-scene-1");
  if (!read) return read.error().message();
  const auto finished = read->finish();
  return finished ? "" : finished.error().message();
}

/// Most memory that this program ever had.
long peak_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss >> 10;
}

constexpr long kMostGrowth_MiB = 64;

TEST(TomlBomb, DottedKeysDoNotOverflowTheStack) {
  const std::string deep = repeated("a.", 300'000);
  for (const std::string& bomb :
       {deep + "b = 1", "[" + deep + "b]", "[[" + deep + "b]]", "x = {" + deep + "b = 1}",
        "\n\n" + repeated("\"a\" . 'b' . ", 100'000) + "c = 1"}) {
    const std::string why = refusal_of(bomb);
    EXPECT_NE(why.find("a key of more than 64 parts"), std::string::npos) << why.substr(0, 200);
    EXPECT_LT(why.size(), 200u);
  }
  EXPECT_NE(refusal_of("\n\n" + deep + "b = 1").find("bomb.toml:4: "), std::string::npos);
}

TEST(TomlBomb, NestedValuesAreRefused) {
  for (const char* open : {"[", "{a = ", "{a.b.c = [", "[{a = "})
    EXPECT_NE(refusal_of("x = " + repeated(open, 100'000)).find("not valid TOML"),
              std::string::npos);
}

TEST(TomlBomb, WhatIsDeepButAllowedIsFreedWithoutHarm) {
  // 250 inline tables with keys of 60 parts: 15,000 tables in each other.
  const std::string key = repeated("a.", 59) + "a = ";
  const std::string deep = key + repeated("{" + key, 250) + "1" + repeated("}", 250);
  EXPECT_NE(refusal_of(deep), "");
}

TEST(TomlBomb, HugeKeysTablesAndFilesAreRefused) {
  for (const std::string& bomb :
       {std::string(3 << 20, 'k') + " = 1", "\"" + std::string(3 << 20, 'k') + "\" = 1",
        "format = \"" + std::string(3 << 20, 'k') + "\""}) {
    EXPECT_NE(refusal_of(bomb), "");
    EXPECT_LT(refusal_of(bomb).size(), 1000u) << "an error of megabytes";
  }
  EXPECT_NE(refusal_of(repeated("[[x]]\n", 300'000)), "");
  EXPECT_NE(refusal_of("x = [" + repeated("1,", 3 << 20) + "]").find("larger than 4 MiB"),
            std::string::npos);
  EXPECT_NE(refusal_of("x = 1" + std::string(1 << 20, '0')), "");
  EXPECT_NE(refusal_of("x = \"" + std::string(1 << 20, 'a')), "");
}

TEST(TomlKeys, DotsInStringsNumbersAndCommentsAreNoParts) {
  const std::string dots(1000, '.');
  EXPECT_EQ(refusal_of("# " + dots), "");
  for (const std::string& value :
       {"\"" + dots + "\"", "'" + dots + "'", "\"\"\"" + dots + "\n\\\"\\\\" + dots + "\"\"\"",
        "'''" + dots + "\n'" + dots + "'''", "[" + repeated("1.5, ", 1000) + "]"}) {
    const std::string why = refusal_of("x = " + value);
    EXPECT_EQ(why.find("parts"), std::string::npos) << why;
    EXPECT_EQ(why.find("not valid"), std::string::npos) << why;
  }
}

TEST(CsvBomb, ALineWithoutAnEndIsRefusedInLittleMemory) {
  const test::TemporaryFolder folder;
  const long before = peak_MiB();
  {
    // A file with a hole: 2 GiB of zeros that take no room on the disk.
    const std::string header = folder.write("header.csv", "x");
    std::filesystem::resize_file(header, std::uintmax_t{2} << 30);
    const auto read = CsvReader::open(header);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message().find("longer than 1 MiB"), std::string::npos);
    const std::string row = folder.write("row.csv", "t_s,force_N\n0,1\n");
    std::filesystem::resize_file(row, std::uintmax_t{2} << 30);
    const auto whole = read_signals(row);
    ASSERT_FALSE(whole.ok());
    EXPECT_NE(whole.error().message().find("row.csv:3: this line is longer than 1 MiB"),
              std::string::npos)
        << whole.error().message();
  }
  EXPECT_LT(peak_MiB() - before, kMostGrowth_MiB);
}

TEST(CsvBomb, AHeaderOfTooManyColumnsIsRefusedInOneLookAtIt) {
  const test::TemporaryFolder folder;
  const auto header = [](std::size_t columns) {
    std::string names = "t_s";
    for (std::size_t c = 1; c < columns; ++c) names += ",c" + std::to_string(c);
    return names + "\n";
  };
  const auto refused = CsvReader::open(folder.write("wide.csv", header(120'000)));
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("wide.csv:1: the header names 120000 columns; give at "
                                           "most 10000"),
            std::string::npos)
      << refused.error().message();
  const auto most = CsvReader::open(folder.write("most.csv", header(CsvReader::kMostColumns)));
  ASSERT_TRUE(most.ok());
  EXPECT_EQ(most->columns().size(), CsvReader::kMostColumns);
  EXPECT_EQ(most->find("c9999"), 9999);
  EXPECT_FALSE(CsvReader::open(folder.write("twice.csv", "a,b,a\n")).ok());
}

TEST(CsvBomb, BrokenTablesNameTheirLine) {
  const test::TemporaryFolder folder;
  const auto why = [&](const std::string& text) {
    const auto read = read_signals(folder.write("x.csv", text));
    return read ? "" : read.error().message();
  };
  EXPECT_NE(why(""), "");
  EXPECT_NE(why(std::string(1000, '\0')), "");
  EXPECT_NE(why("t_s,t_s\n0,1\n1,2\n"), "");
  EXPECT_NE(why("t_s," + repeated(",", 100'000) + "\n"), "");
  for (const char* field :
       {"nan", "inf", "1e999", "0x10", "1;2", "'; DROP TABLE x", "1 1", "\"1\""})
    EXPECT_NE(why("t_s,force_N\n0,1\n1," + std::string(field) + "\n").find("x.csv:3: "),
              std::string::npos)
        << field;
  EXPECT_NE(why("t_s,force_N\n0,1\n1,2,3\n").find("x.csv:3: "), std::string::npos);
  EXPECT_NE(why("t_s,force_N\n0,1\n1\n").find("x.csv:3: "), std::string::npos);
  EXPECT_NE(why("t_s,force_N\n1,1\n0,1\n").find("x.csv:3: "), std::string::npos);
}

}  // namespace
}  // namespace isograsp::hostile_files_test
