// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/slcan_codec.hpp"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace isograsp::slcan_codec_test {
namespace {

using Kind = SlcanCommand::Kind;

std::string without_end(const SlcanText& text) {
  std::string line(text.view());
  EXPECT_EQ(line.back(), '\r');
  line.pop_back();
  return line;
}

BusFrame random_frame(std::mt19937_64& random) {
  BusFrame frame;
  frame.extended = random() % 2 == 0;
  frame.remote = random() % 4 == 0;
  frame.id = static_cast<std::uint32_t>(random() & (frame.extended ? 0x1FFFFFFFU : 0x7FFU));
  frame.length = static_cast<std::uint8_t>(random() % 9);
  if (!frame.remote)
    for (std::size_t k = 0; k < frame.length; ++k)
      frame.data[k] = static_cast<std::uint8_t>(random());
  return frame;
}

TEST(Slcan, EveryFrameComesBackFromItsLine) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 100'000; ++k) {
    const BusFrame frame = random_frame(random);
    const auto command = parse_slcan(without_end(format_slcan(frame)));
    ASSERT_TRUE(command);
    ASSERT_EQ(command->kind, Kind::frame);
    ASSERT_EQ(command->frame, frame);
  }
}

TEST(Slcan, LinesOfTheKernel) {
  const auto standard = parse_slcan("t06410B");
  ASSERT_TRUE(standard);
  EXPECT_EQ(standard->frame.id, 0x64u);
  EXPECT_EQ(standard->frame.length, 1);
  EXPECT_EQ(standard->frame.data[0], 0x0B);
  EXPECT_TRUE(standard->frame.is_standard());
  const auto extended = parse_slcan("T1234567820102");
  ASSERT_TRUE(extended);
  EXPECT_TRUE(extended->frame.extended);
  EXPECT_EQ(extended->frame.id, 0x12345678u);
  EXPECT_EQ(parse_slcan("C")->kind, Kind::close);
  EXPECT_EQ(parse_slcan("O")->kind, Kind::open);
  EXPECT_EQ(parse_slcan("L")->kind, Kind::listen);
  EXPECT_EQ(parse_slcan("S8")->bit_rate, 1'000'000u);
  EXPECT_EQ(parse_slcan("S5")->bit_rate, 250'000u);
}

TEST(Slcan, LinesToTheKernel) {
  BusFrame frame;
  frame.id = 0x001;
  frame.length = 8;
  frame.data = {0x0B, 0xFF, 0xFD, 0xFF, 0xFE, 0x00, 0x04, 0x00};
  EXPECT_EQ(format_slcan(frame).view(), "t00180BFFFDFFFE000400\r");
  EXPECT_EQ(format_slcan_state(SlcanState::warning, 97, 0).view(), "sw097000\r");
  EXPECT_EQ(format_slcan_state(SlcanState::passive, 128, 0).view(), "sp128000\r");
  EXPECT_EQ(format_slcan_state(SlcanState::bus_off, 256, 0).view(), "sb256000\r");
  EXPECT_EQ(format_slcan_state(SlcanState::active, 0, 0).view(), "sa000000\r");
  EXPECT_EQ(format_slcan_error(SlcanError::receive_overflow).view(), "e1o\r");
  EXPECT_EQ(format_slcan_answer(parse_slcan("t0010")).view(), "z\r");
  EXPECT_EQ(format_slcan_answer(parse_slcan("O")).view(), "\r");
  EXPECT_EQ(format_slcan_answer(parse_slcan("?")).view(), "\a");
}

TEST(Slcan, MalformedLinesAreRefused) {
  for (const char* line :
       {"",       "t",        "t0",          "t001",       "t00",
        "t0019",  "t00110",   "t00110G",     "t0011001",   "t8001FF",
        "tG0100", "T1234567", "T2000000000", "T123456781", "r00180000000000000000",
        "r0019",  "S",        "S9",          "S88",        "O1",
        "Cc",     "o",        "t001 10B",    "t0011\n0",   "x001"})
    EXPECT_FALSE(parse_slcan(line)) << line;
}

TEST(Slcan, AnyCharactersAreEitherRefusedOrAFrameThatComesBack) {
  std::mt19937_64 random(2);
  const std::string letters = "tTrRSOCL0123456789ABCDEFabcdef\n x";
  int frames = 0;
  for (int k = 0; k < 300'000; ++k) {
    std::string line(random() % 28, '0');
    for (char& c : line) c = letters[random() % letters.size()];
    if (k % 2 == 0) line = "t0010" + line.substr(0, random() % 2);
    const auto command = parse_slcan(line);
    if (!command || command->kind != Kind::frame) continue;
    ++frames;
    ASSERT_EQ(parse_slcan(without_end(format_slcan(command->frame)))->frame, command->frame);
  }
  EXPECT_GT(frames, 1000);
}

TEST(SlcanLines, TheSameLinesHoweverTheStreamIsCut) {
  SlcanLines lines;
  std::string seen;
  for (const char c : std::string("C\rS8\r\rt06410B\rO"))
    if (const auto line = lines.take(c)) seen += "[" + std::string(*line) + "]";
  EXPECT_EQ(seen, "[C][S8][][t06410B]");
}

TEST(SlcanLines, ALineThatIsTooLongIsMalformedAndTheNextOneIsWhole) {
  SlcanLines lines;
  int bad = 0;
  std::string last;
  for (const char c : "T1234567880011223344556677" + std::string(1000, '0') + "\rt0010\r")
    if (const auto line = lines.take(c)) {
      last = *line;
      if (!parse_slcan(*line)) ++bad;
    }
  EXPECT_EQ(bad, 1);
  EXPECT_EQ(last, "t0010");
}

}  // namespace
}  // namespace isograsp::slcan_codec_test
