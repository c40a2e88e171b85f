// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/known_delay.hpp"

namespace isograsp::tasks {

DelayCorrected without_delay(statistics::Computed raw_s, std::optional<double> delay_s) {
  DelayCorrected result{raw_s, raw_s};
  if (!raw_s.value) return result;
  if (delay_s)
    result.corrected_s = *raw_s.value - *delay_s;
  else
    result.corrected_s = "the delay was not measured and is contained in the raw value"_text;
  return result;
}

}  // namespace isograsp::tasks
