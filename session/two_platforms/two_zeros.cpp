// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/two_zeros.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace isograsp::session {

namespace {

std::string of_hand(Hand hand, std::string_view name) {
  return std::string(name_of(hand)) + "_" + std::string(name);
}

Text on_platform(Hand hand, Text words) {
  return hand == Hand::left ? "Left platform: %1"_text(std::move(words))
                            : "Right platform: %1"_text(std::move(words));
}

}  // namespace

PreparationOutcome TwoZeros::outcome() const {
  PreparationOutcome both;
  both.name = "zero";
  both.accepted = true;
  both.only_changed = true;
  both.record.kind = platform::kTwoInstrumentZeros;
  both.record.columns = platform::two_six_axes_columns();
  std::vector<Text> reasons;
  std::vector<Text> remarks;
  for (const Hand hand : kBothHands) {
    const PreparationOutcome one = of[hand].outcome();
    if (!one.accepted) {
      both.accepted = false;
      both.only_changed = both.only_changed && one.only_changed;
      reasons.push_back(on_platform(hand, one.reason));
    }
    if (!one.remark.empty()) remarks.push_back(on_platform(hand, one.remark));
    both.record.mean.insert(both.record.mean.end(), one.record.mean.begin(), one.record.mean.end());
    both.record.sd.insert(both.record.sd.end(), one.record.sd.begin(), one.record.sd.end());
    for (const auto& [name, value] : one.record.references)
      storage::set_value(both.record.references, of_hand(hand, name), value);
    both.record.change_confirmed = both.record.change_confirmed || one.record.change_confirmed;
    both.record.drifted = both.record.drifted || one.record.drifted;
  }
  both.only_changed = both.only_changed && !both.accepted;
  both.reason = joined(reasons);
  if (both.accepted) both.remark = joined(remarks);
  return both;
}

}  // namespace isograsp::session
