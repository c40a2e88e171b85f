// SPDX-License-Identifier: GPL-3.0-or-later
// Files of hands: what is accepted is a hand with lengths and ranges, and is read back as it was.
#include "virtual_hand/hand_model.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;
using namespace isograsp::virtual_hand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  const auto hand = parse_hand(text, "hand.toml");
  if (!hand) {
    fuzz::require_helpful(hand.error(), text);
    return 0;
  }
  for (const DigitModel& digit : hand->digits) {
    for (const double length_m : digit.lengths_m)
      fuzz::require(length_m > 0.0, "a link has a length");
    for (const AngleRange& range : digit.limits)
      fuzz::require(range.least < range.most, "a range has room");
  }
  const auto again = parse_hand(hand_text(*hand), "again.toml");
  fuzz::require(again.ok(), "a written hand is read");
  fuzz::require(hand_text(*again) == hand_text(*hand), "and is the same");
  return 0;
}
