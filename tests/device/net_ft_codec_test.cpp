// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_codec.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/device/hex.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::net_ft_codec_test {
namespace {

using test::bytes_of;
using test::hex;

NetFtRecord record(const std::string& text) {
  return decode_net_ft_record(hex(text)).value();
}

const std::string kGrasp =
    "000003E9 00001B77 00000000 00BC4B20 FFAC13A0 FD2345E0 0001E26C FFF48E50 00009E34";

TEST(NetFtCodec, EncodesTheRequestsOfTheWorkedExamples) {
  const auto request = [](NetFtCommand command, std::uint32_t samples) {
    return bytes_of(encode_net_ft_request(0, {command, samples}));
  };
  EXPECT_EQ(request(NetFtCommand::start, 0), hex("1234000200000000"));
  EXPECT_EQ(request(NetFtCommand::start, 1000), hex("12340002000003E8"));
  EXPECT_EQ(request(NetFtCommand::start_buffered, 0), hex("1234000300000000"));
  EXPECT_EQ(request(NetFtCommand::stop, 0), hex("1234000000000000"));
  EXPECT_EQ(request(NetFtCommand::set_bias, 0), hex("1234004200000000"));
  EXPECT_EQ(request(NetFtCommand::reset_latch, 0), hex("1234004100000000"));
}

TEST(NetFtCodec, RequestsComeBackAndOtherBytesAreNone) {
  for (const auto command : {NetFtCommand::stop, NetFtCommand::start, NetFtCommand::start_buffered,
                             NetFtCommand::reset_latch, NetFtCommand::set_bias})
    for (const std::uint32_t samples : {0U, 1U, 1000U, UINT32_MAX}) {
      const NetFtRequest request{command, samples};
      EXPECT_EQ(decode_net_ft_request(encode_net_ft_request(2, request).bytes()), request);
    }
  EXPECT_EQ(encode_net_ft_request(2, {}).id, 2u);
  EXPECT_FALSE(decode_net_ft_request(hex("1235000200000000")));
  EXPECT_FALSE(decode_net_ft_request(hex("12340002000000")));
  EXPECT_FALSE(decode_net_ft_request(hex("123400020000000000")));
  EXPECT_FALSE(decode_net_ft_request(hex("1234000100000000")));
  EXPECT_FALSE(decode_net_ft_request({}));
}

TEST(NetFtCodec, DecodesTheWorkedExamplesToTheLastBit) {
  const auto first = record("00000001 0000000A 00000000" + std::string(48, '0'));
  EXPECT_EQ(first, (NetFtRecord{1, 10, 0, {}}));
  EXPECT_TRUE(judge(first, NetFtProduct::net_box).valid());

  const auto grasp = record(kGrasp);
  EXPECT_EQ(grasp.rdt_sequence, 1001u);
  EXPECT_EQ(grasp.ft_sequence, 7031u);
  const Wrench wrench = wrench_of(grasp.raw, {});
  EXPECT_EQ(wrench.force, Vec3(12.34, -5.5, -48.02));
  EXPECT_EQ(wrench.torque, Vec3(0.1235, -0.75, 0.0405));
  EXPECT_EQ(flag_words(grasp, NetFtProduct::net_box), "");

  const auto limits =
      record("000003EA 00001B7E 80020000 FFFFFFFF 00000001 7FFFFFFF 80000000 00000005 FFFFFFFA");
  EXPECT_EQ(limits.raw, (RawCounts{-1, 1, INT32_MAX, INT32_MIN, 5, -6}));
  const auto verdict = judge(limits, NetFtProduct::net_box);
  EXPECT_TRUE(verdict.saturated);
  EXPECT_TRUE(verdict.critical);
  EXPECT_FALSE(verdict.valid());
  EXPECT_EQ(flag_words(limits, NetFtProduct::net_box),
            "saturated+status_error_summary+status_transducer_saturation_or_ad_error");
}

TEST(NetFtCodec, RecordsComeBackWhateverTheirBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    NetFtRecord sent;
    sent.rdt_sequence = static_cast<std::uint32_t>(random());
    sent.ft_sequence = static_cast<std::uint32_t>(random());
    sent.status = static_cast<std::uint32_t>(random());
    for (auto& value : sent.raw) value = static_cast<std::int32_t>(random());
    const auto frame = encode_net_ft_record(1, sent);
    ASSERT_EQ(frame.length, kNetFtRecord);
    ASSERT_EQ(frame.id, 1u);
    ASSERT_EQ(decode_net_ft_record(frame.bytes()), sent);
  }
}

TEST(NetFtCodec, OnlyThirtySixBytesAreARecord) {
  const std::array<std::uint8_t, 64> zeros{};
  for (std::size_t n = 0; n <= zeros.size(); ++n)
    EXPECT_EQ(decode_net_ft_record(std::span(zeros).first(n)).has_value(), n == 36) << n;
}

TEST(NetFtCodec, ScalesByTheUnitsOfTheBox) {
  NetFtScale scale;
  scale.counts_per_unit_force = 1000.0;  // lbf
  scale.unit_force_N = 4.4482216152605;
  scale.counts_per_unit_torque = 10.0;  // Nmm
  scale.unit_torque_Nm = 0.001;
  const Wrench wrench = wrench_of({1000, -2000, 0, 10, 0, -30}, scale);
  EXPECT_EQ(wrench.force, Vec3(4.4482216152605, -2.0 * 4.4482216152605, 0.0));
  EXPECT_EQ(wrench.torque, Vec3(0.001, 0.0, -0.003));
  const Vec6 units = units_per_count(scale);
  EXPECT_DOUBLE_EQ(units[2], 4.4482216152605e-3);
  EXPECT_DOUBLE_EQ(units[3], 1e-4);
}

TEST(NetFtCodec, EveryBitOfTheStatusIsCriticalButALatchedThreshold) {
  for (const auto product : {NetFtProduct::net_box, NetFtProduct::axia}) {
    NetFtRecord healthy;
    EXPECT_TRUE(judge(healthy, product).valid());
    for (unsigned bit = 0; bit < 32; ++bit) {
      NetFtRecord one;
      one.status = 1U << bit;
      EXPECT_EQ(judge(one, product).critical, bit != 16) << bit;
      NetFtRecord with_summary;
      with_summary.status = 0x80000000 | 1U << bit;
      EXPECT_EQ(judge(with_summary, product).critical, bit != 16) << bit;
      NetFtRecord with_latch;
      with_latch.status = 0x00010000 | 1U << bit;
      EXPECT_EQ(judge(with_latch, product).critical, bit != 16 && bit != 31) << bit;
    }
  }
}

TEST(NetFtCodec, TheProductsSaySaturatedWithDifferentBits) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    NetFtRecord one;
    one.status = 1U << bit;
    EXPECT_EQ(judge(one, NetFtProduct::net_box).saturated, bit == 17) << bit;
    EXPECT_EQ(judge(one, NetFtProduct::axia).saturated, bit == 27) << bit;
    EXPECT_FALSE(judge(one, NetFtProduct::net_box).overload);
    EXPECT_EQ(judge(one, NetFtProduct::axia).overload, bit == 30) << bit;
  }
  for (std::size_t axis = 0; axis < 6; ++axis)
    for (const std::int32_t end : {INT32_MAX, INT32_MIN}) {
      NetFtRecord at_end;
      at_end.raw[axis] = end;
      EXPECT_FALSE(judge(at_end, NetFtProduct::net_box).valid());
      EXPECT_EQ(flag_words(at_end, NetFtProduct::net_box), "saturated");
      at_end.raw[axis] += end > 0 ? -1 : 1;
      EXPECT_TRUE(judge(at_end, NetFtProduct::net_box).valid());
    }
}

TEST(NetFtCodec, NamesEveryBitOfBothStatusWords) {
  const auto words = [](std::uint32_t status, NetFtProduct product) {
    NetFtRecord one;
    one.status = status;
    return flag_words(one, product);
  };
  EXPECT_EQ(words(0x80010000, NetFtProduct::net_box),
            "status_error_summary+status_monitor_condition_latched");
  EXPECT_EQ(words(0x80010000, NetFtProduct::axia), "status_any_error+status_monitor_latched");
  EXPECT_EQ(words(0x00000402, NetFtProduct::net_box), "status_analog_watchdog+status_http");
  EXPECT_EQ(words(0x00000402, NetFtProduct::axia), "status_bit_10+status_supply");
  EXPECT_EQ(words(0x00008001, NetFtProduct::net_box), "status_bit_15+status_bit_0");
  for (const auto product : {NetFtProduct::net_box, NetFtProduct::axia}) {
    const std::string all = words(UINT32_MAX, product);
    EXPECT_EQ(std::count(all.begin(), all.end(), '+'), 32);  // saturated and 32 bits
    for (const char c : test::every(all))
      EXPECT_TRUE((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '+');
  }
}

TEST(NetFtCodec, KnowsTheFiltersOfTheNetBox) {
  EXPECT_EQ(net_ft_filter_code(0.0), 0u);
  EXPECT_EQ(net_ft_filter_code(35.0), 5u);
  EXPECT_EQ(net_ft_filter_code(30.0), std::nullopt);
  for (unsigned code = 0; code < 13; ++code)
    EXPECT_EQ(net_ft_filter_code(net_ft_filter_Hz(code)), code);
  EXPECT_EQ(net_ft_filter_Hz(13), 0.0);
}

TEST(NetFtCodec, DoesNotAllocate) {
  const auto frame = encode_net_ft_record(0, record(kGrasp));
  const auto before = test::allocations();
  const auto read = decode_net_ft_record(frame.bytes());
  const auto verdict = judge(*read, NetFtProduct::axia);
  const Wrench wrench = wrench_of(read->raw, {});
  EXPECT_EQ(test::allocations(), before);
  EXPECT_TRUE(verdict.valid());
  EXPECT_EQ(wrench.force.x(), 12.34);
}

}  // namespace
}  // namespace isograsp::net_ft_codec_test
