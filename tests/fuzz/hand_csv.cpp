// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of tracked hands: what is accepted has times that increase for each hand, and joints that
// are numbers or not given.
#include "device/hand/hand_csv.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const auto text = fuzz::as_text(data, size);
  file.write(text);
  const auto hands = read_hand_csv(file.path());
  if (!hands) {
    fuzz::require_helpful(hands.error(), text);
    return 0;
  }
  std::array<double, 2> last_s{-std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
  for (const HandFrame& hand : *hands) {
    double& before_s = last_s[static_cast<std::size_t>(hand.side)];
    fuzz::require(hand.t_s > before_s, "time increases for each hand");
    before_s = hand.t_s;
    fuzz::require(hand.confidence >= 0.0 && hand.confidence <= 1.0, "confidence is a share");
    for (const Vec3& joint : hand.joints)
      fuzz::require(joint.allFinite() || joint.array().isNaN().all(),
                    "a joint is whole or not there");
  }
  return 0;
}
