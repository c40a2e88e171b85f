// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/simulated_person.hpp"

namespace isograsp {

Result<std::unique_ptr<VirtualPatient>> simulated_person(const Uri& uri) {
  if (uri.scheme != "sim") return std::unique_ptr<VirtualPatient>();
  const auto traits = patient_traits(uri.target);
  if (!traits)
    return uri.error("", "there is no simulated patient '" + uri.target + "'",
                     "use sim://healthy or sim://paretic");
  constexpr double kLargestSeed = 9007199254740992.0;  // 2^53: every integer below is a double
  const auto seed = uri.number_or("seed", 1.0, 0.0, kLargestSeed);
  if (!seed) return seed.error();
  const auto recovery = uri.number_or("recovery", 0.0, 0.0, 1.0);
  if (!recovery) return recovery.error();
  return std::make_unique<VirtualPatient>(recovered(*traits, *recovery),
                                          static_cast<std::uint64_t>(*seed));
}

}  // namespace isograsp
