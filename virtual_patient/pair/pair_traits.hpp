// SPDX-License-Identifier: GPL-3.0-or-later
// What makes two hands those of one person, and people with both as files, format "isograsp-pair-1"
// (library/patients/pairs, docs/virtual_patient.md). A software test instrument, not data.
#pragma once

#include <string>
#include <string_view>

#include "core/result.hpp"
#include "hand/hands.hpp"

namespace isograsp::virtual_patient {

struct PairTraits {
  double crosstalk = 0.0;          ///< part of what one hand does that the other does, too
  double crosstalk_delay_s = 0.0;  ///< … so much later
  /// What is asked of both together is shared as their strengths to this power: 0 equally, 1 so
  /// that both make the same effort.
  double share_exponent = 1.0;
  double common_noise = 0.0;  ///< part of the slow noise of force that both have in common, 0 … 1
  double lag_s = 0.0;         ///< the weaker hand does all so much later
  bool operator==(const PairTraits&) const = default;
};

struct PairFile {
  std::string name;             ///< for people to read
  std::string description;      ///< what is special about them
  OfHands<std::string> people;  ///< whose hands they are (session/simulated_person.hpp)
  PairTraits traits;
};

/// Unknown keys, missing traits and values out of range are errors with their line. `file` is used
/// in errors only.
[[nodiscard]] Result<PairFile> parse_pair(std::string_view text, const std::string& file);

}  // namespace isograsp::virtual_patient
