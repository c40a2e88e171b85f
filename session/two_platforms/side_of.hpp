// SPDX-License-Identifier: GPL-3.0-or-later
// Inside session/two_platforms/ only: hands of people are sides of the mathematics of two hands.
#pragma once

#include <cstddef>

#include "bimanual/pads/side.hpp"
#include "hand/hands.hpp"

namespace isograsp::session {

[[nodiscard]] inline bimanual::Side side_of(Hand hand) noexcept {
  return hand == Hand::left ? bimanual::Side::left : bimanual::Side::right;
}
[[nodiscard]] inline std::size_t place_of(Hand hand) noexcept {
  return bimanual::index_of(side_of(hand));
}

}  // namespace isograsp::session
