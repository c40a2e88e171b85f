// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/candump_log.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::candump_log_test {
namespace {

CandumpEntry parse(std::string_view line) {
  const auto entry = parse_candump_line(line);
  EXPECT_TRUE(entry.ok()) << line;
  EXPECT_TRUE(entry.value().has_value()) << line;
  return **entry;
}

TEST(CandumpLog, RoundTripsEveryKindOfFrame) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20'000; ++i) {
    BusFrame frame;
    frame.extended = random() % 3 == 0;
    frame.error = !frame.extended && random() % 5 == 0;
    frame.remote = !frame.error && random() % 4 == 0;
    frame.id = static_cast<std::uint32_t>(random()) &
               (frame.extended || frame.error ? 0x1FFFFFFFU : 0x7FFU);
    frame.length = static_cast<std::uint8_t>(random() % 9);
    if (!frame.remote)
      for (std::size_t k = 0; k < frame.length; ++k)
        frame.data[k] = static_cast<std::uint8_t>(random());
    const Timestamp time = std::chrono::microseconds(random() % 4'000'000'000'000'000);
    const auto line = format_candump_line(time, "can0", frame);
    const auto entry = parse(line);
    ASSERT_EQ(entry.frame, frame) << line;
    ASSERT_EQ(entry.wall_time, time) << line;
    ASSERT_EQ(entry.interface, "can0");
  }
}

TEST(CandumpLog, ReadsWhatCandumpWrites) {
  auto e = parse("(1795262457.666439) vcan0 064#0B00000000000000");
  EXPECT_EQ(e.time_text, "1795262457.666439");
  EXPECT_EQ(e.interface, "vcan0");
  EXPECT_EQ(e.frame.id, 0x64u);
  EXPECT_FALSE(e.frame.extended);
  EXPECT_EQ(e.frame.length, 8);
  EXPECT_EQ(e.frame.data[0], 0x0B);

  e = parse("(1795262457.681791) vcan0 12345678#DEADBEEF");
  EXPECT_TRUE(e.frame.extended);
  EXPECT_EQ(e.frame.id, 0x12345678u);
  EXPECT_EQ(e.frame.length, 4);

  EXPECT_TRUE(parse("(1795262457.688772) vcan0 123#R").frame.remote);
  EXPECT_EQ(parse("(1795262457.688772) vcan0 123#R5").frame.length, 5);
  EXPECT_TRUE(parse("(0000000001.000000) can0 20000004#0001000000000000").frame.error);
  EXPECT_EQ(parse("(0000000001.000000) can0 20000004#0001000000000000").frame.id, 4u);
  EXPECT_EQ(parse("(0000000001.000000) can0 123#11.22.33").frame.length, 3);
  EXPECT_EQ(parse("(0000000001.000000) can0 123#").frame.length, 0);
  EXPECT_EQ(parse("(0000000001.000000) can0 123#1122334455667788_E").frame.length, 8);
  EXPECT_TRUE(parse("(0000000001.000000) can0 123##11122334455667788990011").flexible_data_rate);
  EXPECT_EQ(parse("(0000000001.123456789)   can0   123#11 T\r").wall_time.count(), 1'123'456'789);
  EXPECT_EQ(parse("(0000000001.000001) can0 123#11 R").wall_time.count(), 1'000'001'000);
}

TEST(CandumpLog, SkipsLinesThatAreNoFrames) {
  for (const char* line : {"", "\r", "DROPCOUNT: dropped 5 CAN frames on 'can0' socket", "# note"})
    EXPECT_FALSE(parse_candump_line(line).value().has_value()) << line;
}

TEST(CandumpLog, RefusesDamagedLines) {
  for (const char* line : {"(1",
                           "(1.0) can0 123#11",
                           "(1.000000)",
                           "(1.000000) can0",
                           "(1.000000) can0 123",
                           "(1.000000) can0 12#11",
                           "(1.000000) can0 1234#11",
                           "(1.000000) can0 FFF#11",
                           "(1.000000) can0 123#1",
                           "(1.000000) can0 123#GG",
                           "(1.000000) can0 123#112233445566778899",
                           "(1.000000) can0 123#R9",
                           "(1.000000) can0 123#11_9",
                           "(1.000000) can0 123#1122334455667788_8",
                           "(1.000000) can0 123##",
                           "(1.000000) can0 FFFFFFFF#11",
                           "(1.000000) can0 123#11 X",
                           "(-1.000000) can0 123#11",
                           "(1.00000x) can0 123#11",
                           "(99999999999.000000) can0 123#11"})
    EXPECT_FALSE(parse_candump_line(line).ok()) << line;
}

TEST(CandumpLog, RefusesTimesThatNanosecondsCannotCount) {
  EXPECT_TRUE(parse_candump_line("(9223372035.999999999) can0 123#11").ok());
  EXPECT_FALSE(parse_candump_line("(9223372036.000000) can0 123#11").ok());
  EXPECT_FALSE(parse_candump_line("(9999999999.000000) can0 123#11").ok());
}

TEST(CandumpLog, NamesFileAndLineOfADamagedEntry) {
  const test::TemporaryFolder folder;
  const auto path =
      folder.write("x.log", "(1.000000) can0 123#11\nDROPCOUNT: 1\n(1.000000) can0 12\n");
  auto log = CandumpReader::open(path);
  ASSERT_TRUE(log.ok());
  CandumpEntry entry;
  EXPECT_TRUE(log->next(entry).value());
  const auto second = log->next(entry);
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().file, path);
  EXPECT_EQ(second.error().line, 3);
  EXPECT_FALSE(CandumpReader::open(folder.path("absent.log")).ok());
}

TEST(CandumpLog, RefusesALineWithoutAnEnd) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("x.log", "(1.000000) can0 123#11\r\n(1.000000) can0 123#12");
  auto log = CandumpReader::open(path);
  CandumpEntry entry;
  EXPECT_TRUE(log->next(entry).value());
  EXPECT_TRUE(log->next(entry).value()) << "the last line has no end";
  EXPECT_EQ(entry.frame.data[0], 0x12);
  EXPECT_FALSE(log->next(entry).value());
  // Two gibibytes of zeros that take no room on the disk.
  std::filesystem::resize_file(path, std::uintmax_t{2} << 30);
  auto endless = CandumpReader::open(path);
  EXPECT_TRUE(endless->next(entry).value());
  const auto refused = endless->next(entry);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().line, 2);
  EXPECT_NE(refused.error().message().find("longer than 256 KiB"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::candump_log_test
