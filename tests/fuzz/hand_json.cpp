// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that scripts send: what is accepted is a hand with joints that are numbers or not given,
// and is read back as it was.
#include "device/hand/hand_json.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto hand = parse_hand_json(fuzz::as_text(data, size));
  if (!hand) return 0;
  fuzz::require(std::isfinite(hand->t_s), "a time is a number");
  fuzz::require(hand->confidence >= 0.0 && hand->confidence <= 1.0, "confidence is a share");
  for (const Vec3& joint : hand->joints)
    fuzz::require(joint.allFinite() || joint.array().isNaN().all(),
                  "a joint is whole or not there");
  const auto again = parse_hand_json(hand_json(*hand));
  fuzz::require(again.has_value(), "a written hand is read");
  fuzz::require(fuzz::same_bits(again->t_s, hand->t_s) && again->side == hand->side &&
                    again->tracked == hand->tracked,
                "and is the same hand at the same time");
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    for (Eigen::Index a = 0; a < 3 && hand->joints[j].allFinite(); ++a)
      fuzz::require(again->joints[j][a] == hand->joints[j][a], "and in the same place");
  return 0;
}
