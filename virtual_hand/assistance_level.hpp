// SPDX-License-Identifier: GPL-3.0-or-later
// How much a grasp is helped: a word of task files, records and of the world that helps.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace isograsp::virtual_hand {

/// How much a grasp is helped; stands with every placement and changes between placements only.
enum class AssistanceLevel : std::uint8_t {
  full,    ///< ties as in the source
  softer,  ///< ties of half the stiffness, which let go at half the effort
  off      ///< contacts and friction alone
};
inline constexpr std::array<std::string_view, 3> kAssistanceLevelNames{"full", "softer", "off"};
[[nodiscard]] constexpr std::string_view name_of(AssistanceLevel level) noexcept {
  return kAssistanceLevelNames[static_cast<std::size_t>(level)];
}
[[nodiscard]] constexpr std::optional<AssistanceLevel> assistance_level(
    std::string_view name) noexcept {
  for (std::size_t i = 0; i < kAssistanceLevelNames.size(); ++i)
    if (kAssistanceLevelNames[i] == name) return static_cast<AssistanceLevel>(i);
  return std::nullopt;
}

}  // namespace isograsp::virtual_hand
