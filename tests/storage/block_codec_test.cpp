// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/sqlite/block_codec.hpp"

#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::block_codec_test {
namespace {

TEST(BlockCodec, EveryBitOfEveryDoubleComesBack) {
  std::mt19937_64 random(1);
  for (const std::size_t columns : {1u, 3u, 60u}) {
    std::vector<double> rows = awkward_doubles();
    while (rows.size() < 100 * columns) rows.push_back(std::bit_cast<double>(random()));
    rows.resize(100 * columns);
    std::vector<std::vector<double>> back(columns);
    ASSERT_TRUE(decode_block(encode_block(rows, columns), 100, back));
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_TRUE(same_bits(rows[i], back[i % columns][i / columns])) << i;
    EXPECT_EQ(compress(shuffle_columns(back)), encode_block(rows, columns));
  }
}

TEST(BlockCodec, SameRowsGiveSameBytesWhateverWasPackedBefore) {
  const auto rows = awkward_doubles();
  const std::string first = encode_block(rows, 3);
  std::mt19937_64 random(2);
  for (const std::size_t count : {7u, 600u, 30000u}) {
    std::vector<double> others(count);
    for (double& value : others) value = static_cast<double>(random() % 1000);
    (void)encode_block(others, 1);
    EXPECT_EQ(encode_block(rows, 3), first) << count;
  }
}

TEST(BlockCodec, NoSingleBitFlipPassesTheChecksum) {
  std::string bytes = encode_block(awkward_doubles(), 3);
  const auto sound = crc32(bytes);
  for (std::size_t i = 0; i < 8 * bytes.size(); ++i) {
    const auto mask = static_cast<char>(1 << (i % 8));
    bytes[i / 8] = static_cast<char>(bytes[i / 8] ^ mask);
    EXPECT_NE(crc32(bytes), sound) << "bit " << i;
    bytes[i / 8] = static_cast<char>(bytes[i / 8] ^ mask);
  }
}

TEST(BlockCodec, ChecksumIsTheOneOfZlib) {
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);  // the check value of CRC-32/ISO-HDLC
}

TEST(BlockCodec, WrongSizeOrTornBytesAreNoBlock) {
  const std::string bytes = encode_block(awkward_doubles(), 3);
  std::vector<std::vector<double>> columns(3);
  EXPECT_FALSE(decode_block(bytes, 4, columns));
  EXPECT_FALSE(decode_block(bytes.substr(0, bytes.size() / 2), 3, columns));
  EXPECT_FALSE(decode_block("", 3, columns));
  for (const auto huge : {std::numeric_limits<std::size_t>::max(), std::size_t{1} << 61U})
    EXPECT_FALSE(decode_block(bytes, huge, columns)) << "asks for no memory";
  for (const auto& column : test::every(columns)) EXPECT_TRUE(column.empty());
}

}  // namespace
}  // namespace isograsp::storage::block_codec_test
