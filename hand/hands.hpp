// SPDX-License-Identifier: GPL-3.0-or-later
// One hand, or both together: what a session is about.
#pragma once

#include <optional>
#include <string_view>

#include "hand/finger.hpp"

namespace isograsp {

/// Nothing: both of them.
[[nodiscard]] constexpr std::string_view name_of(std::optional<Hand> hand) noexcept {
  return hand ? name_of(*hand) : "both";
}

}  // namespace isograsp
