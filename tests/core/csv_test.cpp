// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp {
namespace {

using test::TemporaryFolder;

TEST(Numbers, EveryDoubleReadsBackToTheSameBits) {
  std::mt19937_64 bits(1);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t word = bits();
    double value = 0.0;
    static_assert(sizeof value == sizeof word);
    std::memcpy(&value, &word, sizeof value);
    if (!std::isfinite(value)) continue;
    double read = 0.0;
    ASSERT_TRUE(parse_number(format_number(value), read));
    ASSERT_EQ(std::memcmp(&value, &read, sizeof value), 0) << format_number(value);
  }
}

TEST(Numbers, TextNanInfinityAndTrailingCharactersAreNotNumbers) {
  double value = 7.0;
  for (const char* text : {"", "abc", "nan", "NaN", "inf", "-inf", "1.0x", "1 2", "0x10", "1e999"})
    EXPECT_FALSE(parse_number(text, value)) << text;
  EXPECT_EQ(value, 7.0);
}

TEST(Signals, WrittenAndReadBackAreEqualAndMissingStaysMissing) {
  const TemporaryFolder folder;
  Signals signals({"t_s", "actual_force_N"});
  signals.append_row(std::array{0.0, 1.0 / 3.0});
  signals.append_row(std::array{0.01, std::numeric_limits<double>::quiet_NaN()});
  signals.append_row(std::array{0.02, -0.0});
  ASSERT_TRUE(write_signals(signals, folder.path("a.csv")));
  const auto read = read_signals(folder.path("a.csv"));
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->names(), signals.names());
  EXPECT_EQ(read->column("actual_force_N")[0], 1.0 / 3.0);
  EXPECT_TRUE(std::isnan(read->column("actual_force_N")[1]));
  EXPECT_TRUE(std::signbit(read->column("actual_force_N")[2]));
}

struct BadFile {
  const char* text;
  const char* message;  ///< must occur in the error
};

TEST(Signals, BadFilesAreRefusedNamingLineAndColumn) {
  const TemporaryFolder folder;
  const BadFile bad[] = {
      {"", "no header"},
      {"x_m\n1\n2\n", "t_s: the column is missing"},
      {"t_s,x_m\n0,1\n0.01,abc\n", ":3: x_m: 'abc' is not a finite number"},
      {"t_s,x_m\n0,1\n0.01,nan\n", ":3: x_m: 'nan' is not a finite number"},
      {"t_s,x_m\n0,1\n0.01\n", ":3: x_m: the line ends before this column"},
      {"t_s,x_m\n0,1\n0.01,1,2\n", ":3: the line has more fields"},
      {"t_s,x_m\n0.01,1\n0,1\n", ":3: t_s: time does not increase"},
      {"t_s,x_m\n0,1\n0,1\n", ":3: t_s: time does not increase"},
      {"t_s,x_m\n0,1\n", "fewer than two rows"},
      {"t_s,t_s\n0,1\n", ":1: t_s: the column appears twice"},
  };
  for (const auto& [text, message] : bad) {
    const auto read = read_signals(folder.write("bad.csv", text));
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().message().find(message), std::string::npos) << read.error().message();
    EXPECT_EQ(read.error().code, Error::Code::bad_input);
  }
  EXPECT_FALSE(read_signals(folder.path("absent.csv")));
  EXPECT_FALSE(read_signals(folder.path()));
}

TEST(Csv, WindowsLineEndsByteOrderMarkAndCommentsAreAccepted) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("w.csv", "\xEF\xBB\xBF# made elsewhere\r\nt_s,x_m\r\n0,1\r\n1,+2\r\n");
  const auto read = read_signals(path);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(read->column("x_m")[1], 2.0);
  EXPECT_EQ(CsvReader::open(path)->comments().at(0), "made elsewhere");
}

}  // namespace
}  // namespace isograsp
