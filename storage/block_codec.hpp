// SPDX-License-Identifier: GPL-3.0-or-later
// One second of one signal group as bytes: float64, channel after channel, byte-shuffled, zstd.
// Lossless to the bit: -0.0, denormals and NaN payloads come back as they were. Pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isograsp {

/// CRC-32 (polynomial 0xEDB88320, as in zlib) of some bytes.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes) noexcept;

/// Packs row-major `rows` of `columns` values each; layout in docs/file_formats.md, "Database".
/// @pre columns > 0 and rows.size() is a multiple of columns. Throws std::bad_alloc only.
[[nodiscard]] std::string encode_block(std::span<const double> rows, std::size_t columns);

/// The reverse; nothing if the bytes are not a whole block of row_count x columns values.
[[nodiscard]] std::optional<std::vector<double>> decode_block(std::string_view bytes,
                                                              std::size_t row_count,
                                                              std::size_t columns);

}  // namespace isograsp
