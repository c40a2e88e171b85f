// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/finger.hpp"

namespace isograsp {

std::optional<Finger> finger_from_name(std::string_view name) noexcept {
  for (const Finger finger : kFingers)
    if (name == name_of(finger)) return finger;
  return std::nullopt;
}

std::optional<Hand> hand_from_name(std::string_view name) noexcept {
  for (const Hand hand : {Hand::right, Hand::left})
    if (name == name_of(hand)) return hand;
  return std::nullopt;
}

}  // namespace isograsp
