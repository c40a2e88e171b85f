// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/datagram_log.hpp"

#include <random>

#include <gtest/gtest.h>

#include "device/config/net_ft_sensor.hpp"
#include "device/protocol/net_ft_decoder.hpp"
#include "tests/device/hex.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::datagram_log_test {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::hex;

TEST(Endpoint, ReadsAndWritesNumbers) {
  const auto endpoint = parse_endpoint("192.168.1.10:49152");
  ASSERT_TRUE(endpoint.has_value());
  EXPECT_EQ(endpoint->address, 0xC0A8010Au);
  EXPECT_EQ(endpoint->port, 49152);
  EXPECT_EQ(endpoint->text(), "192.168.1.10:49152");
  for (const char* text :
       {"", ":", "1.2.3.4", "1.2.3.4:", "1.2.3.4:0", "1.2.3.4:65536", "1.2.3:4", "256.1.1.1:1",
        "1.2.3.4:01", "-1.2.3.4:1", "1.2.3.4:1x", "a.b.c.d:1", "[::1]:1", "1..3.4:1", "1.2.3.4 :1"})
    EXPECT_FALSE(parse_endpoint(text)) << text;
}

TEST(Endpoint, OrderIsThatOfTheNumbersAndThenOfThePorts) {
  const auto at = [](const char* text) { return parse_endpoint(text).value(); };
  EXPECT_LT(at("192.168.1.9:2"), at("192.168.1.10:1"));  // not the order of the letters
  EXPECT_LT(at("10.0.0.1:9"), at("10.0.0.1:10"));
  EXPECT_LT(at("127.0.0.1:1"), at("192.0.0.1:1"));
}

TEST(DatagramLog, ReadsALine) {
  const auto entry = parse_datagram_line("(1700000000.001000) 192.168.1.1:49152 0001fFA0");
  ASSERT_TRUE(entry) << entry.error().message();
  ASSERT_TRUE(entry->has_value());
  EXPECT_EQ((*entry)->time_text, "1700000000.001000");
  EXPECT_EQ((*entry)->wall_time, 1700000000s + 1ms);
  EXPECT_EQ((*entry)->from.text(), "192.168.1.1:49152");
  EXPECT_EQ((*entry)->bytes, hex("0001FFA0"));
  EXPECT_FALSE(parse_datagram_line("").value().has_value());
  EXPECT_FALSE(parse_datagram_line(" \r").value().has_value());
  EXPECT_TRUE(parse_datagram_line("(1.000000) 1.2.3.4:5 00\r").value().has_value());
}

TEST(DatagramLog, WritesWhatItReads) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    Bytes bytes(1 + random() % 80);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const Endpoint from{static_cast<std::uint32_t>(random()),
                        static_cast<std::uint16_t>(1 + random() % 65535)};
    const Timestamp when = std::chrono::microseconds(random() % 9'000'000'000'000'000);
    const auto entry = parse_datagram_line(format_datagram_line(when, from, bytes));
    ASSERT_TRUE(entry) << entry.error().message();
    EXPECT_EQ((*entry)->wall_time, when);
    EXPECT_EQ((*entry)->from, from);
    EXPECT_EQ((*entry)->bytes, bytes);
  }
}

TEST(DatagramLog, RefusesEveryOtherLine) {
  for (const char* line :
       {"(1700000000.001000", "1700000000.001000 1.2.3.4:5 00", "(1700000000) 1.2.3.4:5 00",
        "(1700000000.01) 1.2.3.4:5 00", "(17000000000.001000) 1.2.3.4:5 00",
        "(1700000000.001000) 1.2.3.4 00", "(1700000000.001000) box:5 00",
        "(1700000000.001000) 1.2.3.4:5", "(1700000000.001000) 1.2.3.4:5 0",
        "(1700000000.001000) 1.2.3.4:5 0G", "(1700000000.001000) 1.2.3.4:5 00 11",
        "(1700000000.001000) can0 064#0C00", "# a comment", "(-170000000.001000) 1.2.3.4:5 00"}) {
    const auto entry = parse_datagram_line(line);
    ASSERT_FALSE(entry) << line;
    EXPECT_FALSE(entry.error().what.empty());
    EXPECT_NE(english(entry.error().remedy).find("192.168.1.1:49152"), std::string::npos);
  }
  const std::string longest(2 * 65507, '0');
  EXPECT_TRUE(parse_datagram_line("(1.000000) 1.2.3.4:5 " + longest));
  const auto too_long = parse_datagram_line("(1.000000) 1.2.3.4:5 00" + longest);
  ASSERT_FALSE(too_long);
  EXPECT_LT(too_long.error().message().size(), 400u) << "no page of digits on the screen";
}

TEST(DatagramLog, ErrorsNameFileAndLine) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("net.log", "(1.000000) 1.2.3.4:5 00\n\n(2.000000) 1.2.3.4:5 0\n");
  auto log = DatagramLogReader::open(path);
  ASSERT_TRUE(log);
  DatagramEntry entry;
  EXPECT_TRUE(log->next(entry).value());
  const auto second = log->next(entry);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().file, path);
  EXPECT_EQ(second.error().line, 3);
  EXPECT_FALSE(DatagramLogReader::open(folder.path("none")));
}

// ---- the decoder of such logs

Bytes record(std::uint32_t rdt, std::uint32_t status = 0, std::int32_t fx = 12'340'000) {
  return test::bytes_of(
      encode_net_ft_record(0, {rdt, 1000 + 7 * rdt, status, {fx, 0, 0, 0, 0, 0}}));
}

TEST(NetFtDecoder, MakesOneSampleOfEveryRecordThatIsNew) {
  NetFtDecoder decoder;
  std::vector<NetFtSample> samples;
  for (const std::uint32_t rdt : {100, 101, 101, 104, 103, 104, 105})
    decoder.push(record(rdt), Timestamp(rdt), samples);
  ASSERT_EQ(samples.size(), 5u);
  EXPECT_EQ(samples[2].record.rdt_sequence, 104u);
  EXPECT_EQ(samples[3].record.rdt_sequence, 103u) << "late, but a sample all the same";
  EXPECT_EQ(samples[3].stamp, Timestamp(103));
  EXPECT_EQ(samples[0].wrench_S.force.x(), 12.34);
  EXPECT_EQ(decoder.sequence().duplicate(), 2u);
  EXPECT_EQ(decoder.sequence().lost(), 2u);
  EXPECT_EQ(decoder.sequence().late(), 1u);
}

TEST(NetFtDecoder, ReadsBufferedDatagramsAndCountsTheRest) {
  NetFtDecoder decoder;
  std::vector<NetFtSample> samples;
  Bytes three = record(1);
  for (const std::uint32_t rdt : {2, 3}) {
    const Bytes more = record(rdt);
    three.insert(three.end(), more.begin(), more.end());
  }
  decoder.push(three, 1s, samples);
  EXPECT_EQ(samples.size(), 3u);
  three.pop_back();
  decoder.push(three, 2s, samples);
  decoder.push({}, 2s, samples);
  decoder.push(hex("1234000200000000"), 3s, samples);
  EXPECT_EQ(samples.size(), 3u);
  EXPECT_EQ(decoder.foreign(), 2u);
  EXPECT_EQ(decoder.requests(), 1u);
}

TEST(NetFtDecoder, SaysWhatMeansNothing) {
  NetFtDecoder decoder;
  std::vector<NetFtSample> samples;
  decoder.push(record(1), 1s, samples);
  decoder.push(record(2, 0x80010000), 1s, samples);
  decoder.push(record(3, 0x80020000), 1s, samples);
  decoder.push(record(4, 0x80000004), 1s, samples);
  decoder.push(record(5, 0, INT32_MIN), 1s, samples);
  ASSERT_EQ(samples.size(), 5u);
  EXPECT_TRUE(samples[0].valid);
  EXPECT_TRUE(samples[1].valid) << "a latched threshold is a warning";
  EXPECT_FALSE(samples[2].valid);
  EXPECT_FALSE(samples[3].valid);
  EXPECT_FALSE(samples[4].valid);
}

TEST(NetFtFingers, AddressesInAscendingOrderAreThumbIndexMiddle) {
  const auto at = [](const char* text) { return parse_endpoint(text).value(); };
  const std::vector<Endpoint> senders{at("192.168.1.10:49152"), at("192.168.1.2:49153"),
                                      at("192.168.1.2:49152"), at("192.168.1.10:49152")};
  const auto fingers = NetFtFingers::in_order(senders, "net.log");
  ASSERT_TRUE(fingers);
  EXPECT_EQ(fingers->finger_of(at("192.168.1.2:49152")), 0u);
  EXPECT_EQ(fingers->finger_of(at("192.168.1.2:49153")), 1u);
  EXPECT_EQ(fingers->finger_of(at("192.168.1.10:49152")), 2u);
  EXPECT_EQ(fingers->finger_of(at("192.168.1.3:49152")), std::nullopt);

  auto four = senders;
  four.push_back(at("192.168.1.11:49152"));
  EXPECT_FALSE(NetFtFingers::in_order(four, "net.log"));
  EXPECT_FALSE(NetFtFingers::in_order({}, "net.log"));
  const auto one = NetFtFingers::in_order({at("10.0.0.1:1")}, "net.log");
  EXPECT_EQ(one->finger_of(at("10.0.0.1:1")), 0u);
}

TEST(NetFtFingers, TheConfigurationMaySayOtherwise) {
  auto config = DeviceConfig::standard(kNetFtFamily);
  config.sensors[0].connection = NetFtSensor{"192.168.1.9"};
  config.sensors[1].connection = NetFtSensor{"192.168.1.3:50000"};
  config.sensors[2].connection = NetFtSensor{"192.168.1.1:49152:8080"};
  const auto fingers = NetFtFingers::of(config);
  ASSERT_TRUE(fingers) << fingers.error().message();
  EXPECT_EQ(fingers->finger_of({0xC0A80109, 1234}), 0u) << "any port";
  EXPECT_EQ(fingers->finger_of({0xC0A80103, 50000}), 1u);
  EXPECT_EQ(fingers->finger_of({0xC0A80103, 49152}), std::nullopt);
  EXPECT_EQ(fingers->finger_of({0xC0A80101, 49152}), 2u);
  config.sensors[2].connection = NetFtSensor{"box.clinic"};
  EXPECT_FALSE(NetFtFingers::of(config));
}

}  // namespace
}  // namespace isograsp::datagram_log_test
