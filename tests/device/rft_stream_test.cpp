// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/rft_stream.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/device/hex.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::rft_stream_test {
namespace {

using namespace std::chrono_literals;
using test::Bytes;
using test::bytes_of;
using test::hex;

Bytes data_packet(const RawCounts& raw, std::uint8_t overload = 0) {
  return bytes_of(encode_stream_counts(0, {raw, overload}));
}

void append(Bytes& stream, const Bytes& more) {
  stream.insert(stream.end(), more.begin(), more.end());
}

struct Found {
  RftPacket packet;
  std::size_t last_byte;  ///< position in the stream of the byte that completed it
};

/// Pushes byte by byte.
std::vector<Found> read_all(RftStream& stream, const Bytes& bytes) {
  std::vector<Found> found;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if (auto packet = stream.push(std::span(bytes).subspan(i, 1), Timestamp(i)))
      found.push_back({*packet, i});
  return found;
}

TEST(RftStream, EncodesTheCommandsOfTheManual) {
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::start)),
            hex("55 0B00000000000000 0B AA"));
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::stop)), hex("55 0C00000000000000 0C AA"));
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::set_rate, {4})),
            hex("55 0F04000000000000 13 AA"));
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::set_filter, {1, 8})),
            hex("55 0801080000000000 11 AA"));
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::set_bias, {1})),
            hex("55 1101000000000000 12 AA"));
  EXPECT_EQ(bytes_of(encode_stream_command(0, RftCommand::read_once)),
            hex("55 0A00000000000000 0A AA"));
  EXPECT_EQ(encode_stream_command(2, RftCommand::stop).id, 2u);
}

TEST(RftStream, CommandsComeBackAndDamagedOnesDoNot) {
  const auto frame = encode_stream_command(0, RftCommand::set_filter, {1, 8});
  const std::array<std::uint8_t, 8> field{8, 1, 8, 0, 0, 0, 0, 0};
  EXPECT_EQ(decode_stream_command(frame.bytes()), field);
  EXPECT_EQ(decode_stream_command(frame.bytes().first(10)), std::nullopt);
  for (std::size_t i = 0; i < kRftStreamCommand; ++i)
    for (unsigned flip = 1; flip < 256; ++flip) {
      BusFrame damaged = frame;
      damaged.data[i] = static_cast<std::uint8_t>(damaged.data[i] ^ flip);
      EXPECT_EQ(decode_stream_command(damaged.bytes()), std::nullopt);
    }
}

TEST(RftStream, DecodesTheWorkedExampleToTheLastBit) {
  const auto bytes = hex("55 0B0269FEEDF69F00F7FA240051000000 5C AA");
  RftStream stream;
  const auto packet = stream.push(bytes, 7ms);
  ASSERT_TRUE(packet.has_value());
  EXPECT_EQ(packet->stamp, 7ms);
  ASSERT_TRUE(packet->is_data());
  const auto counts = decode_counts(*packet);
  EXPECT_EQ(counts.raw, (RawCounts{617, -275, -2401, 247, -1500, 81}));
  EXPECT_EQ(wrench_of(counts, {}).force, Vec3(12.34, -5.5, -48.02));
  EXPECT_EQ(wrench_of(counts, {}).torque, Vec3(0.1235, -0.75, 0.0405));
  EXPECT_EQ(data_packet(counts.raw), bytes);
}

TEST(RftStream, RoundTripsEveryCountOnEveryAxis) {
  RftStream stream;
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (int value = INT16_MIN; value <= INT16_MAX; ++value) {
      RftCounts counts;
      counts.raw = {0x55, -1, 0x55AA, 1, value / 2, -0x55AB};
      counts.raw[axis] = value;
      counts.overload = static_cast<std::uint8_t>(value & 0x3F);
      const auto frame = encode_stream_counts(1, counts);
      ASSERT_EQ(frame.id, 1u);
      const auto packet = stream.push(frame.bytes(), 1s);
      ASSERT_TRUE(packet.has_value());
      ASSERT_EQ(decode_counts(*packet), counts);
    }
  EXPECT_EQ(stream.torn() + stream.foreign(), 0u);
}

TEST(RftStream, DataFullOfBeginAndEndMarksSurvive) {
  // Each packet looks like beginnings and ends of others all over.
  const int a = 0x5555;
  const int b = static_cast<std::int16_t>(0xAAAA);
  const int c = 0x55AA;
  const int d = static_cast<std::int16_t>(0xAA55);
  const std::vector<RawCounts> all{{a, a, a, a, a, a}, {b, b, b, b, b, b}, {a, b, a, b, a, b},
                                   {c, d, c, d, c, d}, {d, d, d, c, c, c}, {a, 0, b, 0, c, d}};
  Bytes bytes;
  for (int round = 0; round < 5; ++round)
    for (const auto& raw : all) append(bytes, data_packet(raw));
  RftStream stream;
  const auto found = read_all(stream, bytes);
  ASSERT_EQ(found.size(), 5 * all.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(decode_counts(found[i].packet).raw, all[i % all.size()]);
    EXPECT_EQ(found[i].last_byte, (i + 1) * kRftStreamPacket - 1);
  }
  EXPECT_EQ(stream.torn(), 0u);
}

TEST(RftStream, EveryChangedByteIsRejectedAndTheNextPacketIsFound) {
  const Bytes good = hex("55 0B0269FEEDF69F00F7FA240051000000 5C AA");
  const Bytes next = data_packet({1, 2, 3, 4, 5, 6});
  for (std::size_t i = 0; i < good.size(); ++i)
    for (unsigned flip = 1; flip < 256; ++flip) {
      Bytes bytes = good;
      bytes[i] = static_cast<std::uint8_t>(bytes[i] ^ flip);
      append(bytes, next);
      RftStream stream;
      const auto found = read_all(stream, bytes);
      ASSERT_EQ(found.size(), 1u) << "byte " << i << " flipped by " << flip;
      EXPECT_EQ(found[0].last_byte, bytes.size() - 1);
      EXPECT_EQ(decode_counts(found[0].packet).raw, (RawCounts{1, 2, 3, 4, 5, 6}));
      EXPECT_EQ(stream.torn(), 1u);
    }
}

TEST(RftStream, EveryTruncatedPacketCostsOnlyItself) {
  const Bytes cut = data_packet({0x55, 0x55AA, 3, 4, 0x5555, 6});
  const Bytes next = data_packet({1, 2, 3, 4, 5, 6});
  for (std::size_t from = 0; from < cut.size(); ++from)
    for (std::size_t to = from + 1; to <= cut.size(); ++to) {
      if (to - from == cut.size()) continue;
      Bytes bytes(cut.begin() + static_cast<std::ptrdiff_t>(from),
                  cut.begin() + static_cast<std::ptrdiff_t>(to));
      append(bytes, next);
      RftStream stream;
      const auto found = read_all(stream, bytes);
      ASSERT_EQ(found.size(), 1u) << from << " to " << to;
      EXPECT_EQ(found[0].last_byte, bytes.size() - 1);
      EXPECT_EQ(stream.torn(), 1u);
    }
}

/// Whether a packet could begin here.
bool is_packet(const Bytes& bytes, std::size_t at) {
  if (at + kRftStreamPacket > bytes.size() || bytes[at] != 0x55 || bytes[at + 18] != 0xAA)
    return false;
  unsigned sum = 0;
  for (std::size_t i = 1; i <= 16; ++i) sum += bytes[at + i];
  return bytes[at + 17] == (sum & 0xFF);
}

TEST(RftStream, GarbageBeforePacketsNeitherDelaysNorInventsThem) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 20'000; ++round) {
    Bytes bytes;
    const auto garbage = random() % 60;
    const std::array<std::uint8_t, 4> likely{0x55, 0xAA, 0x0B, 0x00};
    for (std::uint64_t i = 0; i < garbage; ++i) {
      const auto r = random();
      bytes.push_back(r % 2 == 0 ? likely[r / 2 % 4] : static_cast<std::uint8_t>(r >> 32));
    }
    append(bytes, data_packet({1, 2, 3, 4, 5, static_cast<int>(random() % 1000)}));
    append(bytes, data_packet({6, 5, 4, 3, 2, static_cast<int>(random() % 1000)}));
    // One garbage in 2^24 is a packet to everybody; such luck would be no fault of the reader.
    bool is_lucky = false;
    for (std::size_t at = 0; at < garbage; ++at) is_lucky = is_lucky || is_packet(bytes, at);
    if (is_lucky) continue;
    RftStream stream;
    const auto found = read_all(stream, bytes);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].last_byte, garbage + kRftStreamPacket - 1);
    EXPECT_EQ(found[1].last_byte, bytes.size() - 1);
    EXPECT_EQ(stream.torn(), garbage == 0 ? 0u : 1u);
  }
}

TEST(RftStream, FindsTheLeftmostPacketsHoweverTheBytesAreCut) {
  std::mt19937_64 random(2);
  for (int round = 0; round < 500; ++round) {
    Bytes bytes;
    while (bytes.size() < 2000) {
      Bytes packet = data_packet({0x55, static_cast<std::int16_t>(random() & 0xFFFF), 0, -1, 0, 0});
      const auto fate = random() % 8;
      if (fate == 0) packet.resize(random() % packet.size());
      if (fate == 1) packet[random() % packet.size()] = static_cast<std::uint8_t>(random() & 0xFF);
      if (fate == 2) packet.insert(packet.begin(), random() % 25, 0x55);
      append(bytes, packet);
    }
    std::vector<std::size_t> expected;
    for (std::size_t at = 0; at < bytes.size();) {
      const bool here = is_packet(bytes, at);
      if (here) expected.push_back(at + kRftStreamPacket - 1);
      at += here ? kRftStreamPacket : 1;
    }
    RftStream whole;
    RftStream pieces;
    std::size_t count = 0;
    const auto found = read_all(whole, bytes);
    for (std::size_t at = 0; at < bytes.size();) {
      const auto size = std::min<std::size_t>(random() % (kRftStreamPacket + 1), bytes.size() - at);
      const auto packet = pieces.push(std::span(bytes).subspan(at, size), 1s);
      at += size;
      if (!packet) continue;
      ASSERT_LT(count, found.size());
      EXPECT_EQ(packet->content, found[count++].packet.content);
    }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].last_byte, expected[i]);
    EXPECT_EQ(count, found.size());
    EXPECT_EQ(pieces.torn(), whole.torn());
    EXPECT_EQ(pieces.foreign(), whole.foreign());
  }
}

TEST(RftStream, CountsWhatIsNotOurs) {
  RftStream stream;
  const Bytes unknown = bytes_of(encode_stream_packet(0, 0x77, {}));
  EXPECT_FALSE(stream.push(unknown, 1s).has_value());
  EXPECT_EQ(stream.foreign(), 1u);
  EXPECT_EQ(stream.torn(), 0u);

  Bytes two = data_packet({1, 2, 3, 4, 5, 6});
  append(two, two);
  EXPECT_FALSE(stream.push(two, 1s).has_value()) << "longer than a packet";
  EXPECT_EQ(stream.foreign(), 2u);

  const Bytes good = data_packet({1, 2, 3, 4, 5, 6});
  EXPECT_FALSE(stream.push(std::span(good).first(7), 1s).has_value());
  stream.finish();
  EXPECT_EQ(stream.torn(), 1u);
  EXPECT_TRUE(stream.push(good, 1s).has_value());
  stream.finish();
  EXPECT_EQ(stream.torn(), 1u);
}

TEST(RftStream, DoesNotAllocate) {
  const auto frame = encode_stream_counts(0, {{1, 2, 3, 4, 5, 6}, 0});
  RftStream stream;
  const auto before = test::allocations();
  for (int i = 0; i < 100; ++i) {
    (void)stream.push(frame.bytes().first(16), 1s);
    (void)stream.push(frame.bytes().subspan(16), 1s);
    (void)stream.push(frame.bytes().first(9), 1s);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace isograsp::rft_stream_test
