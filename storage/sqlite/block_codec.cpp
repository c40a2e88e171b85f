// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/sqlite/block_codec.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <new>

#include <zstd.h>

namespace isograsp::storage {

namespace {

static_assert(std::endian::native == std::endian::little, "blocks are little-endian");

constexpr int kCompressionLevel =
    3;  // measured: higher levels save 1 % for twice the time and more

/// More is damage: a minute of 100 columns at 1000 Hz has 6 million values. Damage must not ask for
/// all memory.
constexpr std::size_t kMostValues = std::size_t{1} << 24;

constexpr std::array<std::uint32_t, 256> make_crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
    table[byte] = crc;
  }
  return table;
}

/// value(c, r): of column c, row r.
template <class Value>
Planes shuffle(std::size_t columns, std::size_t row_count, const Value& value) {
  Planes planes(columns * row_count);
  const std::size_t count = planes.values();
  char* to = planes.data();
  for (std::size_t c = 0; c < columns; ++c)
    for (std::size_t r = 0; r < row_count; ++r, ++to) {
      const auto bits = std::bit_cast<std::uint64_t>(value(c, r));
      for (std::size_t b = 0; b < sizeof(double); ++b)
        to[b * count] = static_cast<char>((bits >> (8 * b)) & 0xFFu);
    }
  return planes;
}

/// Made anew for every block, its tables cost more than the compression.
template <class Context, std::size_t (*release)(Context*)>
struct Release {
  void operator()(Context* context) const { release(context); }
};
using Compressor = std::unique_ptr<ZSTD_CCtx, Release<ZSTD_CCtx, ZSTD_freeCCtx>>;
using Decompressor = std::unique_ptr<ZSTD_DCtx, Release<ZSTD_DCtx, ZSTD_freeDCtx>>;

}  // namespace

std::uint32_t crc32(std::string_view bytes) noexcept {
  static constexpr auto kTable = make_crc_table();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : bytes)
    crc = (crc >> 8) ^ kTable[(crc ^ static_cast<unsigned char>(c)) & 0xFFu];
  return crc ^ 0xFFFFFFFFu;
}

Planes::Planes(std::size_t values)
    : values_(values), data_(std::make_unique_for_overwrite<char[]>(values * sizeof(double))) {}

Planes shuffle_rows(std::span<const double> rows, std::size_t columns) {
  assert(columns > 0 && rows.size() % columns == 0);
  return shuffle(columns, rows.size() / columns,
                 [&](std::size_t c, std::size_t r) { return rows[r * columns + c]; });
}

Planes shuffle_columns(std::span<const std::vector<double>> columns) {
  return shuffle(columns.size(), columns.empty() ? 0 : columns.front().size(),
                 [&](std::size_t c, std::size_t r) { return columns[c][r]; });
}

void unshuffle(const Planes& planes, std::span<std::vector<double>> columns) {
  assert(!columns.empty() && planes.values() % columns.size() == 0);
  const std::size_t count = planes.values();
  const std::size_t row_count = count / columns.size();
  const char* from = planes.bytes().data();
  for (std::vector<double>& column : columns) {
    const std::size_t before = column.size();
    column.resize(before + row_count);
    for (double* to = column.data() + before; to != column.data() + column.size(); ++to, ++from) {
      std::uint64_t bits = 0;
      for (std::size_t b = 0; b < sizeof(double); ++b)
        bits |= std::uint64_t{static_cast<unsigned char>(from[b * count])} << (8 * b);
      *to = std::bit_cast<double>(bits);
    }
  }
}

std::string compress(const Planes& planes) {
  thread_local const Compressor context(ZSTD_createCCtx());
  if (!context) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kCompressionLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  const std::string_view from = planes.bytes();
  std::string packed(ZSTD_compressBound(from.size()), '\0');
  const std::size_t size =
      ZSTD_compress2(context.get(), packed.data(), packed.size(), from.data(), from.size());
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();  // the bound leaves no other cause
  packed.resize(size);
  return packed;
}

std::optional<Planes> decompress(std::string_view bytes, std::size_t row_count,
                                 std::size_t columns) {
  if (columns == 0 || row_count > kMostValues / columns) return {};
  const std::size_t values = row_count * columns;
  const std::size_t size = values * sizeof(double);
  if (ZSTD_getFrameContentSize(bytes.data(), bytes.size()) != size) return {};
  thread_local const Decompressor context(ZSTD_createDCtx());
  if (!context) throw std::bad_alloc();
  Planes planes(values);
  if (ZSTD_decompressDCtx(context.get(), planes.data(), size, bytes.data(), bytes.size()) != size)
    return {};
  return planes;
}

std::string encode_block(std::span<const double> rows, std::size_t columns) {
  return compress(shuffle_rows(rows, columns));
}

bool decode_block(std::string_view bytes, std::size_t row_count,
                  std::span<std::vector<double>> columns) {
  const auto planes = decompress(bytes, row_count, columns.size());
  if (!planes) return false;
  unshuffle(*planes, columns);
  return true;
}

}  // namespace isograsp::storage
