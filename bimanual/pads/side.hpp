// SPDX-License-Identifier: GPL-3.0-or-later
// The two hands, and what is theirs in arrays.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isograsp::bimanual {

enum class Side : std::uint8_t { left, right };
inline constexpr std::size_t kSides = 2;
[[nodiscard]] constexpr std::size_t index_of(Side side) noexcept {
  return static_cast<std::size_t>(side);
}

}  // namespace isograsp::bimanual
