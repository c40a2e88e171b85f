// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::csv_test {
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
  for (const char* text :
       {"", "abc", "nan", "NaN", "inf", "-inf", "1.0x", "1 2", "0x10", "1e999", "+-1"})
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

TEST(Csv, EveryWayToWriteANumberGivesTheBitsOfFromChars) {
  std::vector<std::string> fields{
      // Halfway between two doubles: the even one.
      "9007199254740993", "9007199254740995", "9007199254740993.0", "4503599627370496.5",
      "4503599627370497.5", "9007199254740993.001", "9007199254740992",
      // Most digits and decimals, and one more.
      "9999999999999999999", "0.9999999999999999999", "0.0000000000000000001",
      "99999999999999999999", "0.00000000000000000001", "18446744073709551615",
      // Forms.
      "0", "-0", "0.0", "-0.000", "5.", ".5", "-.5", "1e3", "1.5e-7", "00012.50", "-1E+2"};
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    std::string field = random() % 2 == 0 ? "-" : "";
    const auto whole = random() % 8;
    for (std::uint64_t d = 0; d <= whole; ++d) field += static_cast<char>('0' + random() % 10);
    field += '.';
    const auto decimals = random() % 18;
    for (std::uint64_t d = 0; d <= decimals; ++d) field += static_cast<char>('0' + random() % 10);
    fields.push_back(field);
    fields.push_back(format_number(static_cast<double>(random() >> 11) * 0x1p-53));
  }
  const TemporaryFolder folder;
  std::string text = "a,b\n";
  for (const auto& field : fields) text += field + "," + field + "\n";
  auto reader = CsvReader::open(folder.write("n.csv", text));
  ASSERT_TRUE(reader) << reader.error().message();
  for (const auto& field : fields) {
    double expected = 0.0;
    std::from_chars(field.data(), field.data() + field.size(), expected);
    std::array<double, 2> row{};
    ASSERT_TRUE(reader->next(row)) << field;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(row[0]), std::bit_cast<std::uint64_t>(expected))
        << field;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(row[1]), std::bit_cast<std::uint64_t>(expected))
        << field;
  }
}

TEST(Csv, LinesOfAnyLengthAreWholeWhereverTheFileIsCut) {
  const TemporaryFolder folder;
  const std::string comment(200000, 'c');
  std::string text = "#" + comment + "\n# second\na,b\n";
  for (int i = 0; i < 20000; ++i)
    text += std::to_string(i) + "," + std::string(static_cast<std::size_t>(i % 13), ' ') + "7\n";
  text += "20000,7";  // the last line has no end
  auto reader = CsvReader::open(folder.write("l.csv", text));
  ASSERT_TRUE(reader) << reader.error().message();
  EXPECT_EQ(reader->comments(), (std::vector<std::string>{comment, "second"}));
  std::array<double, 2> row{};
  for (int i = 0; i <= 20000; ++i) {
    const auto more = reader->next(row);
    ASSERT_TRUE(more && *more) << i;
    ASSERT_EQ(row, (std::array{static_cast<double>(i), 7.0}));
    ASSERT_EQ(reader->line(), i + 4);
  }
  EXPECT_FALSE(*reader->next(row));
  EXPECT_FALSE(*reader->next(row));
}

TEST(Csv, OneColumnIsReadWithoutLookingAtTheOthers) {
  const TemporaryFolder folder;
  auto reader = CsvReader::open(folder.write("o.csv", "a,b,c\n1,2,x\n# no row\n\nx,,y\n5\n"));
  ASSERT_TRUE(reader);
  double value = 0.0;
  ASSERT_TRUE(*reader->next(1, value));
  EXPECT_EQ(value, 2.0);
  ASSERT_TRUE(*reader->next(1, value));
  EXPECT_TRUE(std::isnan(value));
  const auto shorter = reader->next(1, value);
  ASSERT_FALSE(shorter);
  EXPECT_NE(shorter.error().message().find(":6: b: the line ends before this column; give every "
                                           "line 3 fields"),
            std::string::npos)
      << shorter.error().message();
}

TEST(Csv, AFileThatCannotBeReadIsNotAnEmptyOne) {
  const auto reader = CsvReader::open("/proc/self/mem");  // opens, but page 0 cannot be read
  ASSERT_FALSE(reader);
  EXPECT_NE(reader.error().message().find("cannot be read"), std::string::npos);
}

TEST(CsvFormulas, AWordThatLooksLikeAFormulaIsDisarmedAndComesBack) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"=1+1", "'=1+1"},
      {"+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"},
      {"-2+3", "'-2+3"},
      {"@SUM(A1)", "'@SUM(A1)"},
      {"\t=1", "'\t=1"},
      {"\r=1", "\"'\r=1\""},
      {"=HYPERLINK(\"http://x\",\"y\")", "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\""},
      {"'=1", "''=1"},
      // No formulas: untouched.
      {"-1.5", "-1.5"},
      {"+2", "+2"},
      {"-1e-05", "-1e-05"},
      {"a=b", "a=b"},
      {"'quoted'", "'quoted'"},
      {"'", "'"},
      {"", ""}};
  for (const auto& [words, field] : cases) {
    EXPECT_EQ(csv_field(words), field) << words;
    EXPECT_EQ(with_formula(without_formula(words)), words);
  }
}

TEST(CsvFormulas, AColumnNamedLikeAFormulaIsReadBackAsItWas) {
  const test::TemporaryFolder folder;
  Signals signals({"t_s", "=cmd()", "'@x", "-1.5"});
  signals.append_row(std::vector<double>{0.0, -1.5, 2.0, -3e-5});
  signals.append_row(std::vector<double>{1.0, 4.0, -0.25, 1.0});
  ASSERT_TRUE(write_signals(signals, folder.path("a.csv")));
  EXPECT_EQ(test::read_file(folder.path("a.csv")),
            "t_s,'=cmd(),''@x,-1.5\n0,-1.5,2,-3e-05\n1,4,-0.25,1\n");
  const auto back = read_signals(folder.path("a.csv"));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->names(), signals.names());
}

}  // namespace
}  // namespace isograsp::csv_test
