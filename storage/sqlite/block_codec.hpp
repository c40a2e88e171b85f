// SPDX-License-Identifier: GPL-3.0-or-later
// Some rows of one signal group as bytes: float64, channel after channel, byte-shuffled, zstd.
// Lossless to the bit: -0.0, denormals and NaN payloads come back as they were. Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isograsp::storage {

/// Most values of one trial, of all its columns together: two hours of 150 columns at 100 Hz, 0.8
/// GiB. A file that claims more is damaged, or made to fill the memory; more cannot be stored.
inline constexpr std::size_t kMostTrialValues = 108'000'000;

/// CRC-32 (polynomial 0xEDB88320, as in zlib) of some bytes.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes) noexcept;

/// Values before they are compressed: plane b holds byte b (0 = least significant) of every value,
/// channel after channel, so that the slowly changing exponents stand side by side.
class Planes {
 public:
  explicit Planes(std::size_t values);
  [[nodiscard]] std::size_t values() const noexcept { return values_; }
  [[nodiscard]] std::string_view bytes() const noexcept { return {data_.get(), 8 * values_}; }
  [[nodiscard]] char* data() noexcept { return data_.get(); }

 private:
  std::size_t values_;
  std::unique_ptr<char[]> data_;  ///< not zeroed first: it is filled at once
};

/// Of row-major `rows`. @pre columns > 0 and rows.size() is a multiple of columns
[[nodiscard]] Planes shuffle_rows(std::span<const double> rows, std::size_t columns);
/// @pre all columns are equally long
[[nodiscard]] Planes shuffle_columns(std::span<const std::vector<double>> columns);
/// Appends the values to their columns. @pre values() is a multiple of columns.size()
void unshuffle(const Planes& planes, std::span<std::vector<double>> columns);

/// One Zstandard frame with content checksum. Throws std::bad_alloc only.
[[nodiscard]] std::string compress(const Planes& planes);
/// Nothing if the bytes are not one whole frame of row_count x columns values.
[[nodiscard]] std::optional<Planes> decompress(std::string_view bytes, std::size_t row_count,
                                               std::size_t columns);

/// A block of row-major rows; layout in docs/file_formats.md, "Database".
[[nodiscard]] std::string encode_block(std::span<const double> rows, std::size_t columns);
/// The reverse: appends row_count values to every column; false, and nothing appended, if the bytes
/// are not such a block.
[[nodiscard]] bool decode_block(std::string_view bytes, std::size_t row_count,
                                std::span<std::vector<double>> columns);

}  // namespace isograsp::storage
