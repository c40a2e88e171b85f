// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/rft_codec.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "device/bus/candump_log.hpp"

namespace isograsp::rft_codec_test {
namespace {

using namespace std::chrono_literals;

BusFrame frame(const std::string& text) {
  const auto entry = parse_candump_line("(1700000000.000000) can0 " + text);
  return entry.value()->frame;
}

std::optional<RftPacket> pair(RftPairing& pairing, const std::string& first,
                              const std::string& second, Timestamp at = 1s) {
  EXPECT_FALSE(pairing.push(frame(first), at).has_value());
  return pairing.push(frame(second), at + 130us);
}

TEST(RftCodec, RoundTripsEveryCountOnEveryAxis) {
  for (std::size_t axis = 0; axis < 6; ++axis) {
    RftPairing pairing(kRftIds[1]);
    Timestamp t = 1s;
    for (int value = INT16_MIN; value <= INT16_MAX; ++value, t += 10ms) {
      RftCounts counts;
      counts.raw = {value ^ 0x55, -1, 0, 1, value / 2, 7};
      counts.raw[0] = static_cast<std::int16_t>(counts.raw[0]);
      counts.raw[axis] = value;
      counts.overload = static_cast<std::uint8_t>(value & 0x3F);
      const auto frames = encode_counts(kRftIds[1], counts);
      ASSERT_FALSE(pairing.push(frames[0], t).has_value());
      const auto packet = pairing.push(frames[1], t + 130us);
      ASSERT_TRUE(packet.has_value());
      ASSERT_TRUE(packet->is_data());
      ASSERT_EQ(packet->stamp, t + 130us);
      ASSERT_EQ(decode_counts(*packet), counts);
    }
    EXPECT_EQ(pairing.torn() + pairing.duplicate() + pairing.foreign(), 0u);
  }
}

struct Example {
  const char* first;
  const char* second;
  RftDivisors divisors;
  Vec3 force_N;
  Vec3 torque_Nm;
  int overload;
};

TEST(RftCodec, DecodesTheWorkedExamplesToTheLastBit) {
  const std::vector<Example> examples{{"001#0BFFFDFFFE000400",
                                       "002#0100000005000000",
                                       {},
                                       {-0.06, -0.04, 0.08},
                                       {0.0005, 0, 0.0025},
                                       0},
                                      {"001#0B0269FEEDF69F00",
                                       "002#F7FA240051000000",
                                       {},
                                       {12.34, -5.5, -48.02},
                                       {0.1235, -0.75, 0.0405},
                                       0},
                                      {"001#0B0096FFB5CFF403",
                                       "002#E801F4FF38080000",
                                       {},
                                       {3.0, -1.5, -246.0},
                                       {0.5, 0.25, -0.1},
                                       0x08},
                                      {"001#0BD8F0012D61A713",
                                       "002#88D8EF0001000000",
                                       {25, 500},
                                       {-400.0, 12.04, 999.96},
                                       {10.0, -20.002, 0.002},
                                       0}};
  for (const auto& e : examples) {
    RftPairing pairing(kRftIds[0]);
    const auto packet = pair(pairing, e.first, e.second);
    ASSERT_TRUE(packet.has_value()) << e.first;
    const auto counts = decode_counts(*packet);
    const Wrench wrench = wrench_of(counts, e.divisors);
    EXPECT_EQ(wrench.force, e.force_N) << e.first;
    EXPECT_EQ(wrench.torque, e.torque_Nm) << e.first;
    EXPECT_EQ(counts.overload, e.overload);
  }
}

TEST(RftCodec, EncodesTheCommandsOfTheManual) {
  const auto& ids = kRftIds[0];
  EXPECT_EQ(encode_command(ids, RftCommand::set_rate, {4}), frame("064#0F04000000000000"));
  EXPECT_EQ(encode_command(ids, RftCommand::set_filter, {1, 8}), frame("064#0801080000000000"));
  EXPECT_EQ(encode_command(ids, RftCommand::set_ids, {0x66, 5, 6}), frame("064#0466050600000000"));
  EXPECT_EQ(encode_command(ids, RftCommand::set_bias, {1}), frame("064#1101000000000000"));
  EXPECT_EQ(encode_command(ids, RftCommand::start), frame("064#0B00000000000000"));
  EXPECT_EQ(encode_command(ids, RftCommand::stop), frame("064#0C00000000000000"));
}

TEST(RftCodec, TellsAnswersFromDataByTheirFirstByte) {
  RftPairing pairing(kRftIds[0]);
  const auto packet = pair(pairing, "001#0801000000000000", "002#0000000000000000");
  ASSERT_TRUE(packet.has_value());
  EXPECT_FALSE(packet->is_data());
  EXPECT_EQ(packet->command, 0x08);
  EXPECT_EQ(packet->content[0], 1);
  const std::array<std::uint8_t, 15> content{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const auto frames = encode_packet(kRftIds[0], 0x02, content);
  (void)pairing.push(frames[0], 2s);
  EXPECT_EQ(pairing.push(frames[1], 2s)->content, content);
}

TEST(RftCodec, KnowsRatesAndBothOrdersOfTheFilterCodes) {
  EXPECT_EQ(rft_rate_code(100), 4);
  EXPECT_EQ(rft_rate_code(200), 5);
  EXPECT_EQ(rft_rate_Hz(0), 200);
  EXPECT_FALSE(rft_rate_code(120).has_value());
  EXPECT_EQ(rft_filter_code(30), 8);
  EXPECT_EQ(rft_filter_code(1), 14);
  EXPECT_EQ(rft_filter_code(1, RftFilterTable::header), 1);
  EXPECT_EQ(rft_filter_code(500, RftFilterTable::header), 14);
  EXPECT_EQ(rft_filter_code(0, RftFilterTable::header), 0);
  EXPECT_FALSE(rft_filter_code(31.25).has_value());
}

constexpr const char* kFirst = "001#0B0269FEEDF69F00";
constexpr const char* kSecond = "002#F7FA240051000000";

TEST(RftPairing, DropsAndCountsHalves) {
  RftPairing pairing(kRftIds[0]);
  EXPECT_FALSE(pairing.push(frame(kSecond), 1s));  // alone
  EXPECT_EQ(pairing.torn(), 1u);
  EXPECT_FALSE(pairing.push(frame(kFirst), 2s));
  EXPECT_FALSE(pairing.push(frame(kFirst), 2s + 10ms));  // the second never came
  EXPECT_EQ(pairing.torn(), 2u);
  EXPECT_TRUE(pairing.push(frame(kSecond), 2s + 10ms + 2ms));  // just in time
  EXPECT_EQ(pairing.torn(), 2u);
  EXPECT_FALSE(pairing.push(frame(kFirst), 3s));
  pairing.finish();
  EXPECT_EQ(pairing.torn(), 3u);
}

TEST(RftPairing, NeverJoinsHalvesOfTwoSamples) {
  RftPairing pairing(kRftIds[0]);
  EXPECT_FALSE(pairing.push(frame(kFirst), 1s));          // its second is lost,
  EXPECT_FALSE(pairing.push(frame(kSecond), 1s + 10ms));  // and the first of the next
  EXPECT_EQ(pairing.torn(), 2u);
  EXPECT_FALSE(pairing.push(frame(kFirst), 2s));
  EXPECT_FALSE(pairing.push(frame(kSecond), 2s - 1us));  // time went back
  EXPECT_EQ(pairing.torn(), 4u);
}

TEST(RftPairing, CountsRepeatedFramesOnceEach) {
  RftPairing pairing(kRftIds[0]);
  EXPECT_FALSE(pairing.push(frame(kFirst), 1s));
  EXPECT_FALSE(pairing.push(frame(kFirst), 1s + 100us));
  EXPECT_TRUE(pairing.push(frame(kSecond), 1s + 200us));
  EXPECT_FALSE(pairing.push(frame(kSecond), 1s + 300us));
  EXPECT_EQ(pairing.duplicate(), 2u);
  EXPECT_EQ(pairing.torn(), 0u);
}

TEST(RftPairing, KeepsForeignFramesOutOfAPair) {
  RftPairing pairing(kRftIds[0]);
  EXPECT_FALSE(pairing.push(frame(kFirst), 1s));
  for (const char* foreign :
       {"00000002#F7FA240051000000", "002#R8", "002#F7FA2400510000", "003#F7FA240051000000",
        "001#0D00000000000000", "20000004#0001000000000000"})
    EXPECT_FALSE(pairing.push(frame(foreign), 1s + 50us)) << foreign;
  EXPECT_EQ(pairing.foreign(), 6u);
  EXPECT_TRUE(pairing.push(frame(kSecond), 1s + 130us));
  EXPECT_EQ(pairing.torn(), 0u);
}

TEST(RftPairing, DecodesTheGoldenLog) {
  struct Row {
    int sensor;
    Vec3 force_N;
    Vec3 torque_Nm;
    int overload;
  };
  const std::vector<Row> expected{{0, {12.34, -5.5, -48.02}, {0.1235, -0.75, 0.0405}, 0},
                                  {1, {-0.8, 6.2, 18.1}, {-0.006, 0.032, -0.0015}, 0},
                                  {2, {-1.1, 5.8, 29.92}, {-0.01, 0.0355, 0.002}, 0},
                                  {0, {12.44, -5.4, -48.2}, {0.123, -0.751, 0.04}, 0},
                                  {1, {-0.82, 6.24, 18.2}, {-0.006, 0.032, -0.0015}, 0},
                                  {2, {-1.08, 5.76, -242.0}, {-0.01, 0.0355, 0.002}, 0x08}};
  auto log = CandumpReader::open(ISOGRASP_SOURCE_DIR "/tests/data/golden_rft.log");
  ASSERT_TRUE(log.ok());
  std::array<RftPairing, 3> sensors{RftPairing(kRftIds[0]), RftPairing(kRftIds[1]),
                                    RftPairing(kRftIds[2])};
  CandumpEntry entry;
  std::size_t row = 0;
  int answers = 0;
  while (log->next(entry).value()) {
    for (std::size_t f = 0; f < 3; ++f) {
      if (entry.frame.id != kRftIds[f].first && entry.frame.id != kRftIds[f].second) continue;
      const auto packet = sensors[f].push(entry.frame, entry.wall_time);
      if (!packet) continue;
      if (!packet->is_data()) {
        ++answers;
        continue;
      }
      ASSERT_LT(row, expected.size());
      const auto counts = decode_counts(*packet);
      const Wrench wrench = wrench_of(counts, {});
      EXPECT_EQ(static_cast<int>(f), expected[row].sensor);
      EXPECT_EQ(wrench.force, expected[row].force_N);
      EXPECT_EQ(wrench.torque, expected[row].torque_Nm);
      EXPECT_EQ(counts.overload, expected[row].overload);
      ++row;
    }
  }
  EXPECT_EQ(row, expected.size());
  EXPECT_EQ(answers, 6);
}

}  // namespace
}  // namespace isograsp::rft_codec_test
