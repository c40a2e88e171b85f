// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_sight.hpp"

#include <algorithm>

#include "hand/finger.hpp"

namespace isograsp::session {

namespace {
bool is_lost_for_long(const ShownHand& hand) noexcept {
  constexpr double kRounding_s = 1e-9;  // twenty frames of 10 ms are 0.2 s
  return !hand.known || (hand.held && hand.unseen_s > kLongestLoss_s + kRounding_s);
}
}  // namespace

Reception hand_reception(const ShownHand& hand, HandFault fault) noexcept {
  Reception reception;
  reception.gap = hand.held;
  if (stops_hand(fault))
    reception.sight = Reception::Sight::lost;
  else if (is_lost_for_long(hand))
    reception.sight = Reception::Sight::occluded;
  return reception;
}

std::uint8_t hand_flags(const ShownHand& hand) noexcept {
  if (!hand.held) return 0;
  return is_lost_for_long(hand) ? bit(SampleFlag::missing) : bit(SampleFlag::held);
}

bool touches(const hand_world::GraspState& grasp) noexcept {
  return std::any_of(grasp.digits.begin(), grasp.digits.end(), [](const auto& digit) {
    return digit.touching || digit.state == virtual_hand::DigitState::attached;
  });
}

}  // namespace isograsp::session
