// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_sight.hpp"

namespace isograsp::session {

Reception hand_reception(const ShownHand& hand, HandFault fault) noexcept {
  constexpr double kRounding_s = 1e-9;  // twenty frames of 10 ms are 0.2 s
  Reception reception;
  reception.gap = hand.held;
  if (stops_hand(fault))
    reception.sight = Reception::Sight::lost;
  else if (!hand.known || (hand.held && hand.unseen_s > kLongestLoss_s + kRounding_s))
    reception.sight = Reception::Sight::occluded;
  return reception;
}

}  // namespace isograsp::session
