// SPDX-License-Identifier: GPL-3.0-or-later
// One hand, or both together: what a session is about, and what there is of each.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "hand/finger.hpp"

namespace isograsp {

/// Nothing: both of them.
[[nodiscard]] constexpr std::string_view name_of(std::optional<Hand> hand) noexcept {
  return hand ? name_of(*hand) : "both";
}

/// In the order in which both are shown, stored and told.
inline constexpr std::array<Hand, 2> kBothHands{Hand::left, Hand::right};

[[nodiscard]] constexpr Hand other_than(Hand hand) noexcept {
  return hand == Hand::left ? Hand::right : Hand::left;
}

/// One for each hand.
template <class T>
struct OfHands {
  T left{};
  T right{};
  [[nodiscard]] constexpr T& operator[](Hand hand) noexcept {
    return hand == Hand::left ? left : right;
  }
  [[nodiscard]] constexpr const T& operator[](Hand hand) const noexcept {
    return hand == Hand::left ? left : right;
  }
  friend bool operator==(const OfHands&, const OfHands&) = default;
};

}  // namespace isograsp
