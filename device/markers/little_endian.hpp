// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers from bytes and into them, the least significant first. @pre the bytes are there
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace isograsp {

template <class Unsigned>
[[nodiscard]] constexpr Unsigned little_endian(std::span<const std::uint8_t> bytes,
                                               std::size_t at) noexcept {
  Unsigned value = 0;
  for (std::size_t i = sizeof(Unsigned); i-- > 0;)
    value = static_cast<Unsigned>((value << 8) | bytes[at + i]);
  return value;
}
[[nodiscard]] constexpr float little_endian_float(std::span<const std::uint8_t> bytes,
                                                  std::size_t at) noexcept {
  return std::bit_cast<float>(little_endian<std::uint32_t>(bytes, at));
}
template <class Unsigned>
constexpr void put_little_endian(std::span<std::uint8_t> bytes, std::size_t at,
                                 Unsigned value) noexcept {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    bytes[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
}

}  // namespace isograsp
